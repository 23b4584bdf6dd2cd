#pragma once

#include <limits>
#include <numbers>

namespace etendue {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kInvPi = std::numbers::inv_pi;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace etendue
