#include "film/relative_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <etendue/film_view.h>

namespace etendue {
namespace {

double gray(const Rgb& c) { return total(c) / 3; }

}  // namespace

ErrorSums& ErrorSums::operator+=(const ErrorSums& other) {
    count_ += other.count_;
    sum_ += other.sum_;
    squares_ += other.squares_;
    return *this;
}

ErrorEstimate ErrorSums::estimate(double sharing) const {
    const double mean = sum_ / count_;
    const double scatter = std::max(0.0, squares_ / count_ - mean * mean);
    return {mean, std::sqrt(scatter * sharing / count_)};
}

RelativeError::RelativeError(std::span<const ReplicateSums> pixels, int width, std::uint64_t passes)
    : pixels_(pixels), width_(width), height_(static_cast<int>(pixels.size()) / width), counts_(passes) {
    double sum = 0;
    for (const ReplicateSums& sums : pixels_) sum += gray(mean_of(sums, counts_));
    const double darkest = kDarkestPart * sum / static_cast<double>(pixels_.size());
    darkest_squared_ = darkest * darkest;
}

ErrorSums RelativeError::of_rows(int begin, int end) const {
    ErrorSums sums;
    const int first = std::max(begin - 1, 0);
    const int last = std::min(end + 1, height_);
    std::vector<Views> rows;
    rows.reserve(static_cast<std::size_t>(last - first) * static_cast<std::size_t>(width_));
    for (int y = first; y < last; ++y) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
        for (const ReplicateSums& pixel : pixels_.subspan(row, static_cast<std::size_t>(width_))) {
            rows.push_back(look(pixel));
        }
    }
    for (int y = begin; y < end; ++y) {
        for (int x = 0; x < width_; ++x) {
            const Views& views = rows[static_cast<std::size_t>((y - first) * width_ + x)];
            double term = 0;
            for (std::uint64_t g = 0; g < kGroups; ++g) {
                const double mean = smoothed(rows, last - first, x, y - first, g);
                const double scale = mean * mean + darkest_squared_;
                if (views[g].deviation > 0) term += views[g].deviation / scale;  // black divides nothing by zero
            }
            sums.add(term);
        }
    }
    return sums;
}

RelativeError::Views RelativeError::look(const ReplicateSums& sums) const {
    const Rgb mean = mean_of(sums, counts_);
    Views views;
    std::array<double, kReplicates> off{};  // what all passes of a replicate are above the mean
    double all_squares = 0;
    for (std::uint64_t r = 0; r < kReplicates; ++r) {
        off[r] = gray(sums.passes[r]) - gray(mean) * counts_.of[r];
        all_squares += off[r] * off[r] / counts_.of[r];
        views[r / kTogether].deviation += gray(variance_by(r, sums, mean, counts_));
    }
    for (std::uint64_t g = 0; g < kGroups; ++g) {
        double others = counts_.total;
        double others_off = 0;  // offsets of all replicates sum up to 0
        double squares = all_squares;
        for (std::uint64_t r = g * kTogether; r < (g + 1) * kTogether; ++r) {
            others -= counts_.of[r];
            others_off -= off[r];
            squares -= off[r] * off[r] / counts_.of[r];
        }
        views[g].mean = gray(mean) + others_off / others;
        const double around_their_mean = std::max(0.0, squares - others_off * others_off / others);
        views[g].noise = around_their_mean / (static_cast<double>(kReplicates - kTogether - 1) * others);
    }
    return views;
}

double RelativeError::smoothed(const std::vector<Views>& rows, int height, int x, int y, std::uint64_t group) const {
    double count = 0;
    double sum = 0;
    double squares = 0;
    double noise = 0;
    for (int ny = std::max(y - 1, 0); ny < std::min(y + 2, height); ++ny) {
        for (int nx = std::max(x - 1, 0); nx < std::min(x + 2, width_); ++nx) {
            const View& view = rows[static_cast<std::size_t>(ny * width_ + nx)][group];
            ++count;
            sum += view.mean;
            squares += view.mean * view.mean;
            noise += view.noise;
        }
    }
    const double local = sum / count;
    const double scatter = squares / count - local * local;
    const double kept = scatter > 0 ? std::max(0.0, 1 - noise / count / scatter) : 0;
    return std::lerp(local, rows[static_cast<std::size_t>(y * width_ + x)][group].mean, kept);
}

}  // namespace etendue
