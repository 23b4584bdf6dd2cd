#pragma once

#include <cstdint>
#include <functional>

#include "fuzz/outcome.h"

namespace etendue::test {

/// Which seeds to try: `count` of them from `first` on, or as many as fit into `seconds` of CPU time.
struct Seeds {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    double seconds = 0;
};

struct Tally {
    std::uint64_t rendered = 0;
    std::uint64_t refused = 0;
    std::uint64_t findings = 0;
};

/// Runs `trial` for each seed in a process of its own kind, a thousand seeds to a process, so that one that crashes or
/// hangs is named and the others still come to pass; leaks show as a process ends. Findings go to standard error, each
/// with its seed. Must be called before anything has started a thread.
Tally supervise(const Seeds& seeds, const std::function<Outcome(std::uint64_t seed)>& trial);

}  // namespace etendue::test
