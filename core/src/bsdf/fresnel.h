#pragma once

#include <algorithm>
#include <cmath>

#include "math/rgb.h"

namespace etendue {

constexpr double pow5(double x) {
    const double x2 = x * x;
    return x2 * x2 * x;
}

/// Unpolarised reflectance of an interface, cos_i >= 0 on the incident side, eta = index beyond / index here; 1 under
/// total internal reflection. With g = eta cos_t both differences that cancel are written as quotients: g^2 - c^2 =
/// eta^2 - 1 = (eta - 1)(eta + 1), so that eta -> 1 and the critical angle (g -> 0) keep their digits.
inline double fresnel_dielectric(double cos_i, double eta) {
    if (eta == 1) return 0;
    const double c = std::min(cos_i, 1.0);
    const double eta2_minus_1 = (eta - 1) * (eta + 1);
    const double g2 = eta2_minus_1 + c * c;
    if (g2 <= 0) return 1;
    const double sum = std::sqrt(g2) + c;
    const double difference = eta2_minus_1 / sum;  // g - c
    const double r_s = difference / sum;
    const double p_over_s = (c * sum - 1) / (c * difference + 1);
    return std::min(0.5 * r_s * r_s * (1 + p_over_s * p_over_s), 1.0);  // Walter 2007 eq. 22
}

/// Reflectance at an interface that light crosses, from both cosines: the one on the rarer side is always well
/// conditioned, and the value is the same, bit for bit, seen from either side.
inline double fresnel_crossing(double cos_a, double eta_a, double cos_b, double eta_b) {
    return eta_a <= eta_b ? fresnel_dielectric(cos_a, eta_b / eta_a) : fresnel_dielectric(cos_b, eta_a / eta_b);
}

/// Cosine on the far side of an interface, eta as above; 0 under total internal reflection.
inline double refracted_cos(double cos_i, double eta) {
    const double g2 = (eta - 1) * (eta + 1) + cos_i * cos_i;
    return g2 <= 0 ? 0 : std::min(std::sqrt(g2) / eta, 1.0);
}

/// Normal reflectance of a dielectric.
constexpr double normal_reflectance(double ior) {
    const double r = (ior - 1) / (ior + 1);
    return r * r;
}

/// Mean of fresnel_dielectric over the hemisphere, the integral of 2 cos F(cos).
inline double mean_fresnel_dielectric(double eta) {
    // Both sides of an interface pass the same power: eta^2 (1 - F(eta)) is 1 - F(1 / eta) for the means.
    if (eta < 1) return 1 - eta * eta * (1 - mean_fresnel_dielectric(1 / eta));
    if (eta - 1 < 1e-4) return (eta - 1) / 3;  // the terms below grow and cancel
    const double n2 = eta * eta;
    const double n4 = n2 * n2;
    const double a = n2 + 1;
    const double b = n4 - 1;
    // Duntley 1942.
    return 0.5 + (eta - 1) * (3 * eta + 1) / (6 * (eta + 1) * (eta + 1)) +
           n2 * (n2 - 1) * (n2 - 1) / (a * a * a) * std::log((eta - 1) / (eta + 1)) -
           2 * n2 * eta * (n2 + 2 * eta - 1) / (a * b) + 8 * n4 * (n4 + 1) / (a * b * b) * std::log(eta);
}

/// Schlick's curve has the mean F0 + (F90 - F0) / 21 over the hemisphere: the grazing value that gives it this one. So
/// does the highlight of a dielectric vanish as its index goes to 1.
inline double grazing_reflectance(double f0, double mean) { return std::clamp(f0 + 21 * (mean - f0), f0, 1.0); }

/// Schlick's reflectance between f0 (normal) and f90 (grazing), less `dip` c (1 - c)^6: OpenPBR's "F82-tint", which
/// colours a metal near 82 degrees.
struct SchlickFresnel {
    Rgb f0;
    Rgb f90{1};
    Rgb dip;

    [[nodiscard]] Rgb operator()(double cos) const {
        const double s = std::clamp(1 - cos, 0.0, 1.0);
        const double s5 = pow5(s);
        const Rgb f = f0 + (f90 - f0) * s5 - dip * (cos * s5 * s);
        return {std::max(f.r, 0.0), std::max(f.g, 0.0), std::max(f.b, 0.0)};
    }

    /// Over the hemisphere: 2 times the integrals of c (1 - c)^5 and c^2 (1 - c)^6 are 1/21 and 1/126.
    [[nodiscard]] Rgb mean() const {
        const Rgb f = f0 + (f90 - f0) / 21 - dip / 126;
        return {std::max(f.r, 0.0), std::max(f.g, 0.0), std::max(f.b, 0.0)};
    }
};

}  // namespace etendue
