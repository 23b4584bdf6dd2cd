#include "film/relative_error.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <etendue/film_view.h>

namespace etendue {
namespace {

double gray(const Rgb& c) { return total(c) * (1.0 / 3); }

}  // namespace

ErrorSums& ErrorSums::operator+=(const ErrorSums& other) {
    count_ += other.count_;
    sum_ += other.sum_;
    squares_ += other.squares_;
    return *this;
}

ErrorEstimate ErrorSums::estimate(double sharing) const {
    return {sum_ / count_, std::sqrt(squares_ * sharing) / count_};
}

/// Views of some rows with the rows around them.
class RelativeError::Rows {
public:
    Rows(const RelativeError& error, int begin, int end)
        : width_(error.width_), first_(std::max(begin - 1, 0)), last_(std::min(end + 1, error.height_)) {
        const std::size_t offset = index(0, first_);
        views_.resize(index(0, last_) - offset);
        for (std::size_t i = 0; i < views_.size(); ++i) views_[i] = error.look(offset + i);
    }

    [[nodiscard]] const View& at(int x, int y) const { return views_[index(x, y - first_)]; }
    /// Means of pixel (x, y), each as far as its neighbours do not show it to be noise.
    [[nodiscard]] std::array<double, kGroups> smoothed(int x, int y) const;

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_;
    int first_;
    int last_;
    std::vector<View> views_;
};

std::array<double, RelativeError::kGroups> RelativeError::Rows::smoothed(int x, int y) const {
    std::array<double, kGroups> sum{};
    std::array<double, kGroups> squares{};
    std::array<double, kGroups> noise{};
    const int x0 = std::max(x - 1, 0);
    const int x1 = std::min(x + 2, width_);
    const int y0 = std::max(y - 1, first_);
    const int y1 = std::min(y + 2, last_);
    for (int ny = y0; ny < y1; ++ny) {
        for (int nx = x0; nx < x1; ++nx) {
            const View& view = at(nx, ny);
            for (std::size_t g = 0; g < kGroups; ++g) {
                sum[g] += view.mean[g];
                squares[g] += view.mean[g] * view.mean[g];
                noise[g] += view.noise[g];
            }
        }
    }
    const double per_pixel = 1.0 / ((x1 - x0) * (y1 - y0));
    std::array<double, kGroups> means{};
    for (std::size_t g = 0; g < kGroups; ++g) {
        const double local = sum[g] * per_pixel;
        const double scatter = squares[g] * per_pixel - local * local;
        const double kept = scatter > 0 ? std::max(0.0, 1 - noise[g] * per_pixel / scatter) : 0;
        means[g] = local + kept * (at(x, y).mean[g] - local);
    }
    return means;
}

RelativeError::RelativeError(const ReplicateSums& sums, int width)
    : sums_(sums), width_(width), height_(static_cast<int>(sums.pixels()) / width) {
    for (std::uint64_t r = 0; r < kReplicates; ++r) {
        passes_[r] = static_cast<double>(sums.passes_of(r));
        per_pass_[r] = 1 / passes_[r];
    }
    const double darkest = kDarkestPart * gray(sums.mean_of_picture());
    darkest_squared_ = darkest * darkest;
}

ErrorSums RelativeError::of_rows(int begin, int end) const {
    const Rows rows(*this, begin, end);
    ErrorSums sums;
    for (int y = begin; y < end; ++y) {
        for (int x = 0; x < width_; ++x) {
            const std::array<double, kGroups> means = rows.smoothed(x, y);
            const std::array<double, kGroups>& deviations = rows.at(x, y).deviation;
            double term = 0;
            for (std::size_t g = 0; g < kGroups; ++g) {
                // Where all is black nothing deviates.
                if (deviations[g] > 0) term += deviations[g] / (means[g] * means[g] + darkest_squared_);
            }
            sums.add(term);
        }
    }
    return sums;
}

RelativeError::View RelativeError::look(std::size_t pixel) const {
    const auto passes = static_cast<double>(sums_.passes());
    const double per_degree = 1 / (static_cast<double>(kReplicates - 1) * passes);
    const Rgb mean = sums_.mean(pixel);
    View view;
    std::array<double, kReplicates> off{};      // what the passes of a replicate are above the mean, together
    std::array<double, kReplicates> squares{};  // of their mean, times passes
    double all_squares = 0;
    for (std::uint64_t r = 0; r < kReplicates; ++r) {
        const Rgb above = sums_.sum(r, pixel) - mean * passes_[r];
        view.deviation[r / kTogether] += gray(above * above) * per_pass_[r] * per_degree;
        off[r] = gray(above);
        squares[r] = off[r] * off[r] * per_pass_[r];
        all_squares += squares[r];
    }
    constexpr auto kOthersDegrees = static_cast<double>(kReplicates - kTogether - 1);
    for (std::uint64_t g = 0; g < kGroups; ++g) {
        double others = passes;
        double others_off = 0;  // all replicates' sum up to 0
        double others_squares = all_squares;
        for (std::uint64_t r = g * kTogether; r < (g + 1) * kTogether; ++r) {
            others -= passes_[r];
            others_off -= off[r];
            others_squares -= squares[r];
        }
        const double per_other = 1 / others;
        const double around_their_mean = std::max(0.0, others_squares - others_off * others_off * per_other);
        view.mean[g] = gray(mean) + others_off * per_other;
        view.noise[g] = around_their_mean * per_other / kOthersDegrees;
    }
    return view;
}

}  // namespace etendue
