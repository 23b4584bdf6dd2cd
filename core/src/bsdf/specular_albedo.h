#pragma once

#include "math/rgb.h"

namespace etendue {

/// Albedo of a GGX reflection whose Fresnel factor is Schlick's is linear in f0 and f90: f0 * of_f0 + f90 * of_f90.
struct SpecularAlbedo {
    double of_f0 = 0;
    double of_f90 = 0;

    [[nodiscard]] Rgb operator()(const Rgb& f0, const Rgb& f90) const { return f0 * of_f0 + f90 * of_f90; }
};

/// Square of an albedo, averaged: quadratic in f0 and f90.
struct SquaredSpecularAlbedo {
    double of_f0_f0 = 0;
    double of_f0_f90 = 0;
    double of_f90_f90 = 0;

    [[nodiscard]] Rgb operator()(const Rgb& f0, const Rgb& f90) const {
        return f0 * f0 * of_f0_f0 + f0 * f90 * (2 * of_f0_f90) + f90 * f90 * of_f90_f90;
    }
};

/// Directional albedo, the integral of f |cos wi| over wi, for the cosine of wo. Tabulated; exact when smooth.
[[nodiscard]] SpecularAlbedo specular_albedo(double cos, double alpha);

/// Hemispherical albedo: the integral of 2 cos times specular_albedo(cos, alpha) over cos, exactly that of the
/// interpolated table.
[[nodiscard]] SpecularAlbedo mean_specular_albedo(double alpha);

/// The integral of 2 cos times the square of specular_albedo(cos, alpha) over cos, or more: exact at the table's
/// roughnesses, and squares are convex between them.
[[nodiscard]] SquaredSpecularAlbedo mean_squared_specular_albedo(double alpha);

/// Below this alpha too little of white GGX's light is lost between facets, save at grazing angles, to be worth a lobe.
inline constexpr double kMultipleScatteringAlpha = 0.02;

/// What is lost, 1 less the directional albedo of white GGX: never more than the truth, and faded out between twice
/// kMultipleScatteringAlpha and once.
[[nodiscard]] double lost_albedo(double cos, double alpha);

/// Its hemispherical mean, or more.
[[nodiscard]] double mean_lost_albedo(double alpha);

/// No true directional albedo with 0 <= f0 <= f90 <= 1 exceeds the tabulated one by more (the tests measure it). The
/// table is coarsest where albedos change on the scale cos / alpha.
[[nodiscard]] double specular_albedo_margin(double cos, double alpha);

}  // namespace etendue
