#pragma once

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include <etendue/film_view.h>

namespace etendue::test {

/// One row of the table in README.md: an extreme, and what must hold there.
struct Extreme {
    std::string family;
    std::string extreme;
    std::string must_hold;
};

/// Whether the measured figure is no more than the limit; a row of the table either way. NaN is more than any limit.
[[nodiscard]] testing::AssertionResult at_most(const Extreme& row, double measured, double limit);

/// A number as the table shows it.
[[nodiscard]] std::string in_words(double x);

/// Contributions that were not finite, or negative.
[[nodiscard]] std::uint64_t invalid(const RenderStatistics& statistics);

}  // namespace etendue::test
