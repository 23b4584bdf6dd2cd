#pragma once

#include <algorithm>
#include <cmath>

#include <etendue/scene_description.h>

namespace etendue {

/// Scene-linear colour in the rendering space.
struct Rgb {
    double r = 0;
    double g = 0;
    double b = 0;

    constexpr Rgb() = default;
    explicit constexpr Rgb(double v) : r(v), g(v), b(v) {}
    constexpr Rgb(double r_in, double g_in, double b_in) : r(r_in), g(g_in), b(b_in) {}
    explicit constexpr Rgb(const Color& c) : r(c[0]), g(c[1]), b(c[2]) {}

    constexpr Rgb& operator+=(const Rgb& o) {
        r += o.r;
        g += o.g;
        b += o.b;
        return *this;
    }
    constexpr Rgb& operator*=(const Rgb& o) {
        r *= o.r;
        g *= o.g;
        b *= o.b;
        return *this;
    }
    constexpr Rgb& operator*=(double s) {
        r *= s;
        g *= s;
        b *= s;
        return *this;
    }
    constexpr bool operator==(const Rgb&) const = default;
};

constexpr Rgb operator+(const Rgb& a, const Rgb& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Rgb operator-(const Rgb& a, const Rgb& b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
constexpr Rgb operator*(const Rgb& a, const Rgb& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Rgb operator*(const Rgb& a, double s) { return {a.r * s, a.g * s, a.b * s}; }
constexpr Rgb operator*(double s, const Rgb& a) { return a * s; }
constexpr Rgb operator/(const Rgb& a, double s) { return a * (1 / s); }
constexpr Rgb lerp(double t, const Rgb& a, const Rgb& b) { return a * (1 - t) + b * t; }

constexpr bool is_black(const Rgb& c) { return c.r == 0 && c.g == 0 && c.b == 0; }
/// What light is chosen by. All channels count alike: blue light must not be starved for its low luminance.
constexpr double total(const Rgb& c) { return c.r + c.g + c.b; }
inline double max_component(const Rgb& c) { return std::max({c.r, c.g, c.b}); }

}  // namespace etendue
