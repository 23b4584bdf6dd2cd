#include "fuzz/dice.h"

#include <cmath>
#include <limits>

namespace etendue::test {

std::uint32_t Dice::next() {
    if (!from_bytes_) return static_cast<std::uint32_t>(rng_.next_bits() >> 32);
    std::uint32_t bits = 0;
    for (int i = 0; i < 4 && used_ < bytes_.size(); ++i) bits = bits << 8 | bytes_[used_++];
    return bits;
}

double Dice::unit() { return static_cast<double>(next()) * 0x1p-32; }

double Dice::log_between(double low, double high) { return low * std::pow(high / low, unit()); }

double Dice::number(double sensible) {
    if (!hostile_ || !chance(0.05)) return sensible;
    constexpr double kInf = std::numeric_limits<double>::infinity();
    return one_of({std::numeric_limits<double>::quiet_NaN(), kInf, -kInf, -1.0, 1e19, -1e19, 1e30, 1e300, -1e300, 1e-30,
                   1e-300, 5e-324});
}

double Dice::fraction() {
    const double usual = unit();
    return number(
        chance(0.5) ? usual : one_of({0.0,  -0.0,  5e-324,   1e-310,   1e-40,       1e-20, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3,
                                      0.03, 0.999, 1 - 1e-6, 1 - 1e-9, 1 - 0x1p-53, 1.0,   1.0,  1.0,  1.5,  -0.5}));
}

double Dice::power(double usual) { return number(chance(0.7) ? usual : log_between(1e-20, 1e20)); }

}  // namespace etendue::test
