#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "light/light_bounds.h"
#include "math/rgb.h"
#include "math/vec.h"

namespace etendue {

/// y0 of a path. Infinite lights have no position: `p` is then the unit direction from the scene towards the light.
struct LightPoint {
    Vec3 p;
    Vec3 n;        ///< geometric normal of the emitting side; -p for infinite lights; unused for points
    Vec2 st;       ///< texture coordinates (textured emission)
    Vec3 p_error;  ///< as SurfaceInteraction::p_error
};

/// A point on the light chosen with a receiver in mind (strategies s = 1).
struct DirectSample {
    LightPoint y;
    Vec3 wi;              ///< unit, from the receiver to the light
    double distance = 0;  ///< infinite for infinite lights
    /// Radiance over the density per solid angle at the receiver; of a point light I / d^2, of a delta distant light
    /// its irradiance. Irradiance on a surface facing the light is the mean of this.
    Rgb weight;
    /// Density of y in its native measure: per area for surfaces, per solid angle for infinite lights, per length for
    /// lines, 1 for points and single directions.
    double pdf_point = 0;
};

/// Densities of y and of leaving it along a direction.
struct EmissionPdf {
    double pdf_point = 0;  ///< native measure, as above
    double pdf_dir = 0;    ///< per solid angle; of infinite lights per area perpendicular to the direction
};

/// The first ray of a light subpath.
struct EmissionSample {
    LightPoint y;
    Vec3 origin;     ///< where the ray starts: y.p, or a point outside the scene for infinite lights
    Vec3 direction;  ///< unit, along the flow of light
    /// Le |cos| / (pdf_point pdf_dir), without the cosine for infinite lights and points: power, once divided by the
    /// probability of having chosen this light.
    Rgb weight;
    EmissionPdf pdf;
};

struct SceneBounds {
    Vec3 center;
    double radius = 1;
};

/// An emitter. Directions w leave the light. Densities do not include the choice among lights.
class Light {
public:
    virtual ~Light() = default;

    /// Le(y -> w), nits. Zero on the dark side; zero for delta lights (their Le is no function).
    [[nodiscard]] virtual Rgb radiance(const LightPoint& y, const Vec3& w) const = 0;
    /// Le(y -> w) |cos| of surfaces, the intensity of points, candela (of lines per length): what a path that leaves y
    /// along w carries. Not of infinite lights.
    [[nodiscard]] virtual Rgb emission(const LightPoint& y, const Vec3& w) const {
        return radiance(y, w) * std::abs(dot(w, y.n));
    }
    /// Empty when `receiver` cannot be lit.
    [[nodiscard]] virtual std::optional<DirectSample> sample_direct(const Vec3& receiver, const Vec2& u) const = 0;
    /// Density with which sample_direct(receiver) picks y; native measure.
    [[nodiscard]] virtual double pdf_direct(const Vec3& receiver, const LightPoint& y) const = 0;
    [[nodiscard]] virtual EmissionSample sample_emission(const Vec2& u_point, const Vec2& u_dir) const = 0;
    [[nodiscard]] virtual EmissionPdf pdf_emission(const LightPoint& y, const Vec3& w) const = 0;
    /// Total, for choosing among lights.
    [[nodiscard]] virtual Rgb power() const = 0;
    /// Empty when the light has none: at infinity, or a kind that does not say. Asked once, for choosing among lights.
    [[nodiscard]] virtual std::optional<LightBounds> bounds() const { return {}; }
    /// Bytes beside the object itself: tables and triangles.
    [[nodiscard]] virtual std::size_t memory_used() const { return 0; }
    /// At infinity: LightPoint::p is a direction.
    [[nodiscard]] virtual bool infinite() const { return false; }
    /// A point, a line, or a single direction: no path finds it by chance.
    [[nodiscard]] virtual bool delta() const { return false; }
};

}  // namespace etendue
