#pragma once

#include <cfenv>

namespace etendue::test {

/// Whether `run` asks this thread for something that floating point has no answer to: 0/0, inf - inf, 0 inf, the root
/// of a negative number. The NaN that comes of it may well be thrown away again, and what is kept then depends on how
/// comparisons were written.
template <typename Run>
[[nodiscard]] bool raises_invalid(const Run& run) {
    std::feclearexcept(FE_INVALID);
    run();
    return std::fetestexcept(FE_INVALID) != 0;
}

}  // namespace etendue::test
