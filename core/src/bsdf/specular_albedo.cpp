#include "bsdf/specular_albedo.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bsdf/fresnel.h"
#include "bsdf/microfacet_reflection.h"

namespace etendue {
namespace {

constexpr int kCosines = 25;
constexpr int kRoughnesses = 17;
constexpr int kHeights = 24;
constexpr int kAzimuths = 12;

SpecularAlbedo operator*(const SpecularAlbedo& a, double s) { return {a.of_f0 * s, a.of_f90 * s}; }
SpecularAlbedo operator+(const SpecularAlbedo& a, const SpecularAlbedo& b) {
    return {a.of_f0 + b.of_f0, a.of_f90 + b.of_f90};
}

SquaredSpecularAlbedo operator*(const SquaredSpecularAlbedo& a, double s) {
    return {a.of_f0_f0 * s, a.of_f0_f90 * s, a.of_f90_f90 * s};
}
SquaredSpecularAlbedo operator+(const SquaredSpecularAlbedo& a, const SquaredSpecularAlbedo& b) {
    return {a.of_f0_f0 + b.of_f0_f0, a.of_f0_f90 + b.of_f0_f90, a.of_f90_f90 + b.of_f90_f90};
}

/// The products of two albedos, symmetrised.
SquaredSpecularAlbedo product(const SpecularAlbedo& a, const SpecularAlbedo& b) {
    return {a.of_f0 * b.of_f0, (a.of_f0 * b.of_f90 + a.of_f90 * b.of_f0) / 2, a.of_f90 * b.of_f90};
}

SpecularAlbedo smooth_albedo(double cos) {
    const double s5 = pow5(1 - cos);
    return {1 - s5, s5};
}

/// Midpoint rule over the square of random numbers that visible-normal sampling takes. Its first number is u = 1 -
/// (1 - x)^2, which puts points where reflections are lost below the surface; of its second, half the range is enough,
/// the other half is the mirror image.
SpecularAlbedo integrate(double cos, double alpha) {
    const Ggx ggx(alpha);
    const Vec3 wo{std::sqrt(1 - cos * cos), 0, cos};
    const double a_o = ggx.a(wo);
    const double g1 = Ggx::g1_over_cos(cos, a_o);
    SpecularAlbedo sum;
    for (int i = 0; i < kHeights; ++i) {
        const double rest = 1 - (i + 0.5) / kHeights;
        for (int j = 0; j < kAzimuths; ++j) {
            const Vec3 wi = sample_microfacet_reflection(ggx, wo, {1 - rest * rest, 0.5 * (j + 0.5) / kAzimuths});
            if (wi.z <= 0) continue;
            const double weight = wi.z * Ggx::g2_over_cosines(cos, a_o, wi.z, ggx.a(wi)) / g1;
            sum = sum + smooth_albedo(std::min(length(wo + wi) / 2, 1.0)) * (2 * rest * weight);
        }
    }
    return sum * (1.0 / (kHeights * kAzimuths));
}

constexpr SpecularAlbedo kSmoothMean{20.0 / 21, 1.0 / 21};  // 2 times the integral of cos (1 - cos)^5 is 1/21
/// 2 times the integrals of cos (1 - cos)^5 and cos (1 - cos)^10 are 1/21 and 1/66.
constexpr SquaredSpecularAlbedo kSmoothMeanSquare{1 - 2.0 / 21 + 1.0 / 66, 1.0 / 21 - 1.0 / 66, 1.0 / 66};

/// How far between smooth, 0, and the table's first row of a rough surface, 1; beyond that too.
double first_step(double alpha) {
    const double smooth = std::sqrt(kSmoothAlpha);
    return (std::sqrt(alpha) - smooth) / (1.0 / (kRoughnesses - 1) - smooth);
}

/// Nodes are even in the square roots of the cosine and of alpha: albedos vary fastest at grazing angles. The first row
/// is the smooth surface, exactly, and stands at kSmoothAlpha: there the table goes over into it without a jump.
class Table {
public:
    Table() {
        means_[0] = kSmoothMean;
        mean_squares_[0] = kSmoothMeanSquare;
        for (int r = 1; r < kRoughnesses; ++r) {
            const double roughness = static_cast<double>(r) / (kRoughnesses - 1);
            for (int c = 0; c < kCosines; ++c) entry(r, c) = make_entry(node_cos(c), roughness * roughness);
            mean(r) = integrate_row(r);
            mean_square(r) = integrate_squared_row(r);
        }
    }

    [[nodiscard]] SpecularAlbedo directional(double cos, double alpha) const {
        const Position r = position_of_alpha(alpha);
        const Position c = position(cos, kCosines);
        const double c0 = node_cos(c.index);
        const double t = std::clamp((cos - c0) / (node_cos(c.index + 1) - c0), 0.0, 1.0);  // linear in the cosine
        const SpecularAlbedo low =
            r.index == 0 ? smooth_albedo(cos) : lerp(t, entry(r.index, c.index), entry(r.index, c.index + 1));
        const SpecularAlbedo high = lerp(t, entry(r.index + 1, c.index), entry(r.index + 1, c.index + 1));
        return lerp(r.fraction, low, high);
    }

    [[nodiscard]] SpecularAlbedo hemispherical(double alpha) const {
        const Position r = position_of_alpha(alpha);
        return lerp(r.fraction, mean(r.index), mean(r.index + 1));
    }

    [[nodiscard]] SquaredSpecularAlbedo squared(double alpha) const {
        const Position r = position_of_alpha(alpha);
        return lerp(r.fraction, mean_square(r.index), mean_square(r.index + 1));
    }

private:
    struct Position {
        std::size_t index;
        double fraction;
    };

    static double node_cos(std::size_t c) {
        const double x = static_cast<double>(c) / (kCosines - 1);
        return x * x;
    }
    static double node_cos(int c) { return node_cos(static_cast<std::size_t>(c)); }
    static Position position(double x, int nodes) {
        const double scaled = std::sqrt(std::clamp(x, 0.0, 1.0)) * (nodes - 1);
        const int index = std::min(static_cast<int>(scaled), nodes - 2);
        return {static_cast<std::size_t>(index), scaled - index};
    }
    static Position position_of_alpha(double alpha) {
        const Position even = position(alpha, kRoughnesses);
        return even.index == 0 ? Position{0, std::max(0.0, first_step(alpha))} : even;
    }
    template <typename Albedo>
    static Albedo lerp(double t, const Albedo& a, const Albedo& b) {
        return a * (1 - t) + b * t;
    }
    static SpecularAlbedo make_entry(double cos, double alpha) { return integrate(std::max(cos, 1e-6), alpha); }
    /// Of a function that is linear between nodes: the integral of 2 x ((1 - t) a + t b) from x0 to x1.
    [[nodiscard]] SpecularAlbedo integrate_row(int r) const {
        SpecularAlbedo sum;
        for (int c = 0; c + 1 < kCosines; ++c) {
            const double x0 = node_cos(c);
            const double x1 = node_cos(c + 1);
            const double width = x1 - x0;
            sum = sum + entry(r, c) * (width * (2 * x0 + x1) / 3) + entry(r, c + 1) * (width * (x0 + 2 * x1) / 3);
        }
        return sum;
    }
    /// The same with the square: the integral of 2 x ((1 - t) a + t b)^2 from x0 to x1.
    [[nodiscard]] SquaredSpecularAlbedo integrate_squared_row(int r) const {
        SquaredSpecularAlbedo sum;
        for (int c = 0; c + 1 < kCosines; ++c) {
            const double x0 = node_cos(c);
            const double x1 = node_cos(c + 1);
            const SpecularAlbedo& a = entry(r, c);
            const SpecularAlbedo& b = entry(r, c + 1);
            sum = sum +
                  (product(a, a) * (3 * x0 + x1) + product(a, b) * (2 * (x0 + x1)) + product(b, b) * (x0 + 3 * x1)) *
                      ((x1 - x0) / 6);
        }
        return sum;
    }

    template <typename R, typename C>
    [[nodiscard]] const SpecularAlbedo& entry(R r, C c) const {
        return entries_[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    }
    SpecularAlbedo& entry(int r, int c) { return entries_[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)]; }
    template <typename R>
    [[nodiscard]] const SpecularAlbedo& mean(R r) const {
        return means_[static_cast<std::size_t>(r)];
    }
    SpecularAlbedo& mean(int r) { return means_[static_cast<std::size_t>(r)]; }
    template <typename R>
    [[nodiscard]] const SquaredSpecularAlbedo& mean_square(R r) const {
        return mean_squares_[static_cast<std::size_t>(r)];
    }
    SquaredSpecularAlbedo& mean_square(int r) { return mean_squares_[static_cast<std::size_t>(r)]; }

    std::array<std::array<SpecularAlbedo, kCosines>, kRoughnesses> entries_{};  ///< the first row is not read
    std::array<SpecularAlbedo, kRoughnesses> means_{};
    std::array<SquaredSpecularAlbedo, kRoughnesses> mean_squares_{};
};

const Table& table() {
    static const Table instance;
    return instance;
}

}  // namespace

SpecularAlbedo specular_albedo(double cos, double alpha) {
    if (alpha < kSmoothAlpha) return smooth_albedo(std::clamp(cos, 0.0, 1.0));
    return table().directional(cos, alpha);
}

double lost_albedo(double cos, double alpha) {
    const double fade = std::clamp(alpha / kMultipleScatteringAlpha - 1, 0.0, 1.0);
    if (fade == 0) return 0;
    const SpecularAlbedo white = specular_albedo(cos, alpha);
    return fade * std::max(0.0, 1 - white.of_f0 - white.of_f90 - specular_albedo_margin(cos, alpha));
}

double mean_lost_albedo(double alpha) {
    const SpecularAlbedo white = mean_specular_albedo(alpha);
    return 1 - white.of_f0 - white.of_f90;
}

double specular_albedo_margin(double cos, double alpha) {
    if (alpha < kSmoothAlpha) return 0;
    const double grazing = std::max(0.0, 1 - cos / 0.2);
    // The first row is exact; a fifth of the way to the next, interpolation is as wrong as elsewhere.
    const double fade = std::min(1.0, 5 * first_step(alpha));
    return fade * (0.003 + 0.06 * grazing * grazing);
}

SpecularAlbedo mean_specular_albedo(double alpha) {
    if (alpha < kSmoothAlpha) return kSmoothMean;
    return table().hemispherical(alpha);
}

SquaredSpecularAlbedo mean_squared_specular_albedo(double alpha) {
    if (alpha < kSmoothAlpha) return kSmoothMeanSquare;
    return table().squared(alpha);
}

}  // namespace etendue
