#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "math/sampling.h"

namespace etendue {

/// Discrete distribution proportional to non-negative weights, sampled by bisection of its cumulative sums.
class Distribution {
public:
    Distribution() = default;
    explicit Distribution(const std::vector<double>& weights) {
        cumulative_.reserve(weights.size());
        for (double weight : weights) cumulative_.push_back(total_ += weight);
    }

    [[nodiscard]] std::size_t size() const { return cumulative_.size(); }
    [[nodiscard]] double total() const { return total_; }
    [[nodiscard]] double weight(std::size_t i) const { return cumulative_[i] - (i == 0 ? 0 : cumulative_[i - 1]); }
    [[nodiscard]] double pmf(std::size_t i) const { return weight(i) / total_; }

    struct Sample {
        std::size_t index;
        double u;  ///< uniform in [0, 1) again
    };
    /// Needs total() > 0; never returns an entry of weight 0.
    [[nodiscard]] Sample sample(double u) const {
        const double x = u * total_;
        const auto it = std::upper_bound(cumulative_.begin(), cumulative_.end(), x);
        const std::size_t last = cumulative_.size() - 1;
        std::size_t i = std::min(static_cast<std::size_t>(it - cumulative_.begin()), last);
        while (i > 0 && weight(i) <= 0) --i;  // u * total_ may round up to the last sum
        const double below = i == 0 ? 0 : cumulative_[i - 1];
        return {i, std::clamp((x - below) / weight(i), 0.0, kOneMinusEpsilon)};
    }

    [[nodiscard]] std::size_t memory_used() const { return cumulative_.capacity() * sizeof(double); }

private:
    std::vector<double> cumulative_;
    double total_ = 0;
};

}  // namespace etendue
