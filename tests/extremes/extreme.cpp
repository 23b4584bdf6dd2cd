#include "extremes/extreme.h"

#include <numeric>
#include <sstream>

namespace etendue::test {

std::string in_words(double x) {
    std::ostringstream text;
    text.precision(3);
    text << x;
    return text.str();
}

testing::AssertionResult at_most(const Extreme& row, double measured, double limit) {
    // Properties of one test need names of their own; the table's command knows them by their beginning.
    static int rows = 0;
    testing::Test::RecordProperty(
        "row_" + std::to_string(++rows),
        row.family + "|" + row.extreme + "|" + row.must_hold + "|" + in_words(measured) + "|" + in_words(limit));
    if (measured <= limit) return testing::AssertionSuccess();
    return testing::AssertionFailure() << row.extreme << ": " << row.must_hold << ": " << measured << ", not at most "
                                       << limit;
}

std::uint64_t invalid(const RenderStatistics& statistics) {
    return std::accumulate(statistics.invalid.begin(), statistics.invalid.end(), std::uint64_t{0});
}

}  // namespace etendue::test
