#pragma once

#include <cstdint>
#include <limits>

#include "film/relative_error.h"

namespace etendue {

/// When to look at the error of a render, and whether it is small enough to end it.
///
/// Looking after every pass and ending at the first estimate that is small would end renders when their luck is good,
/// and make every claim too small. So looks are few: a look decides by how much passes must grow until the next, by a
/// tenth at least. The first waits until each replicate has two passes. And what is held against the target is the
/// estimate plus twice its standard error: where a few pixels make up the error, chance may hide it for long.
class ErrorWatch {
public:
    /// `target`: RenderSettings::error_target; none (0) is never reached.
    explicit ErrorWatch(double target) : target_(target) {}

    [[nodiscard]] bool due(std::int64_t passes) const { return passes >= next_look_; }
    /// An estimate of relMSE after so many passes.
    void look(std::int64_t passes, const ErrorEstimate& estimate);

    /// Passes at the last look; 0 before the first.
    [[nodiscard]] std::int64_t looked_at() const { return looked_at_; }
    /// RenderStatistics::error at the last look.
    [[nodiscard]] double error() const { return error_; }
    [[nodiscard]] bool reached() const { return growth_ <= 1; }
    /// 0..1: passes over those that will be needed, as far as the last look can tell.
    [[nodiscard]] double fraction(std::int64_t passes) const;

private:
    double target_;  ///< of error(): its square may be too small for double
    std::int64_t next_look_ = 2 * kReplicates;
    std::int64_t looked_at_ = 0;
    double error_ = std::numeric_limits<double>::infinity();
    double growth_ = std::numeric_limits<double>::infinity();  ///< of passes since the last look, to reach the target
};

}  // namespace etendue
