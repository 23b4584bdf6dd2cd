#pragma once

#include <cstddef>
#include <vector>

#include "math/distribution.h"
#include "math/vec.h"

namespace etendue {

/// Discrete distribution over the cells of a grid, proportional to non-negative weights: a row by its total, then a
/// column within it.
class Distribution2d {
public:
    Distribution2d() = default;
    /// `weights` row by row.
    Distribution2d(std::size_t columns, const std::vector<double>& weights) {
        std::vector<double> totals;
        for (std::size_t first = 0; first < weights.size(); first += columns) {
            const auto begin = weights.begin() + static_cast<std::ptrdiff_t>(first);
            rows_.emplace_back(std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(columns)));
            totals.push_back(rows_.back().total());
        }
        by_row_ = Distribution(totals);
    }

    [[nodiscard]] std::size_t columns() const { return rows_.empty() ? 0 : rows_.front().size(); }
    [[nodiscard]] std::size_t rows() const { return rows_.size(); }
    [[nodiscard]] double total() const { return by_row_.total(); }
    [[nodiscard]] double pmf(std::size_t column, std::size_t row) const {
        return rows_[row].total() > 0 ? by_row_.pmf(row) * rows_[row].pmf(column) : 0;
    }

    struct Sample {
        std::size_t column;
        std::size_t row;
        Vec2 u;  ///< uniform in the unit square again
    };
    /// Needs total() > 0; never returns a cell of weight 0.
    [[nodiscard]] Sample sample(const Vec2& u) const {
        const Distribution::Sample row = by_row_.sample(u.y);
        const Distribution::Sample column = rows_[row.index].sample(u.x);
        return {column.index, row.index, {column.u, row.u}};
    }

    [[nodiscard]] std::size_t memory_used() const {
        std::size_t bytes = by_row_.memory_used();
        for (const Distribution& row : rows_) bytes += sizeof(row) + row.memory_used();
        return bytes;
    }

private:
    Distribution by_row_;
    std::vector<Distribution> rows_;
};

}  // namespace etendue
