#include "light/emission_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <etendue/error.h>

#include "math/constants.h"

namespace etendue {
namespace {

/// More cells than that cost more memory than they save noise.
constexpr int kMaxCells = 1 << 21;

int texels_per_cell(int width, int height) {
    int texels = 1;
    const auto cells = [&texels](int n) { return std::int64_t{(n + texels - 1) / texels}; };
    while (cells(width) * cells(height) > kMaxCells) ++texels;
    return texels;
}

/// One row of texels, each averaged over its width: of the bilinear filter's tent that is 1/8, 6/8, 1/8.
std::vector<Rgb> filtered_row(const EmissionImage& image, int row, bool wraps) {
    const int width = image.width();
    std::vector<Rgb> texels;
    texels.reserve(static_cast<std::size_t>(width));
    for (int x = 0; x < width; ++x) {
        texels.push_back(image.texel(x, row));
        const Rgb& texel = texels.back();
        if (!std::isfinite(total(texel))) {
            throw SceneError("its texture has a texel that is not finite at (" + std::to_string(x) + ", " +
                             std::to_string(row) + ")");
        }
    }
    const Rgb before = wraps ? texels.back() : texels.front();
    const Rgb after = wraps ? texels.front() : texels.back();
    std::vector<Rgb> filtered;
    filtered.reserve(texels.size());
    for (std::size_t x = 0; x < texels.size(); ++x) {
        const Rgb& left = x == 0 ? before : texels[x - 1];
        const Rgb& right = x + 1 == texels.size() ? after : texels[x + 1];
        filtered.push_back((left + right) * 0.125 + texels[x] * 0.75);
    }
    return filtered;
}

}  // namespace

EmissionTable::EmissionTable(const EmissionImage& image, const std::vector<RowWeights>& rows, bool wraps)
    : width_(image.width()), height_(image.height()), texels_per_cell_(texels_per_cell(width_, height_)) {
    const auto cells = [this](int n) {
        return static_cast<std::size_t>((n + texels_per_cell_ - 1) / texels_per_cell_);
    };
    const std::size_t columns = cells(width_);
    std::vector<double> weights(columns * cells(height_));
    std::vector<Rgb> own = filtered_row(image, 0, wraps);
    std::vector<Rgb> above = own;
    for (int row = 0; row < height_; ++row) {
        std::vector<Rgb> below = row + 1 < height_ ? filtered_row(image, row + 1, wraps) : own;
        const RowWeights& measure = rows[static_cast<std::size_t>(row)];
        double* const weight = weights.data() + static_cast<std::size_t>(row / texels_per_cell_) * columns;
        for (int x = 0; x < width_; ++x) {
            const auto i = static_cast<std::size_t>(x);
            const Rgb texel =
                (above[i] * measure.above + own[i] * measure.own + below[i] * measure.below) / double(width_);
            weight[x / texels_per_cell_] += total(texel);
            integral_ += texel;
        }
        above = std::move(own);
        own = std::move(below);
    }
    cells_ = Distribution2d(columns, weights);
}

EmissionTable::Cell EmissionTable::cell(std::size_t column, std::size_t row) const {
    const auto edge = [this](std::size_t i, int n) {
        return static_cast<double>(std::min(static_cast<int>(i) * texels_per_cell_, n)) / n;
    };
    return {column,
            row,
            edge(column, width_),
            edge(column + 1, width_),
            edge(row, height_),
            edge(row + 1, height_),
            cells_.pmf(column, row)};
}

EmissionTable::Sample EmissionTable::sample(const Vec2& u) const {
    const Distribution2d::Sample sample = cells_.sample(u);
    return {cell(sample.column, sample.row), sample.u};
}

EmissionTable::Cell EmissionTable::cell_at(double x, double y) const {
    const auto index = [this](double t, int n) {
        return static_cast<std::size_t>(std::clamp(static_cast<int>(t * n), 0, n - 1) / texels_per_cell_);
    };
    return cell(index(x, width_), index(y, height_));
}

std::vector<RowWeights> flat_rows(int height) {
    return std::vector<RowWeights>(static_cast<std::size_t>(height), {0.125 / height, 0.75 / height, 0.125 / height});
}

std::vector<RowWeights> latlong_rows(int height) {
    // Over the upper half of a strip the row above has the share (middle - theta) / step, over the lower half the row
    // below has (theta - middle) / step; the integrals of these times sin(theta) are elementary.
    const double step = kPi / height;
    std::vector<RowWeights> rows;
    rows.reserve(static_cast<std::size_t>(height));
    for (int row = 0; row < height; ++row) {
        const double top = row * step;
        const double middle = (row + 0.5) * step;
        const double bottom = (row + 1) * step;
        const double above = std::cos(top) / 2 + (std::sin(top) - std::sin(middle)) / step;
        const double below = -std::cos(bottom) / 2 + (std::sin(bottom) - std::sin(middle)) / step;
        const double strip = 2 * std::sin(middle) * std::sin(step / 2);  // cos(top) - cos(bottom)
        rows.push_back({2 * kPi * above, 2 * kPi * (strip - above - below), 2 * kPi * below});
    }
    return rows;
}

}  // namespace etendue
