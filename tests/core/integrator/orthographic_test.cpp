// Orthographic pictures of known value. Every integrator sees them: points are joined to the camera's plane (t = 1).

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "math/constants.h"
#include "support/replicas.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

constexpr std::array kIntegrators{IntegratorKind::Path, IntegratorKind::Light, IntegratorKind::Bdpt};

void expect_mean(const SceneDescription& scene, double expected, double resolution) {
    for (const IntegratorKind integrator : kIntegrators) {
        SCOPED_TRACE(static_cast<int>(integrator));
        const int samples = integrator == IntegratorKind::Light ? 600 : 200;
        EXPECT_TRUE(
            mean_is(render_replicas(scene, small_settings(integrator, 8, samples), 16, 1), expected, resolution));
    }
}

/// Of a square of half-width a at distance h under its centre.
double solid_angle(double a, double h) { return 4 * std::atan(a * a / (h * std::sqrt(h * h + 2 * a * a))); }

/// E = I cos / d^2 over the window sums up to I times the solid angle under which the light sees it; the camera is far,
/// oblique views of a plane show as much of it as lies behind the window.
TEST(Orthographic, SeesThePlaneUnderAPointLight) {
    constexpr double kReflectance = 0.5;
    constexpr double kWindow = 1.6;
    constexpr double kHeight = 0.7;
    SceneBuilder b;
    b.quad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, b.diffuse(kReflectance));
    b.light(point_light({0, kHeight, 0}, 4));
    b.orthographic({0, 1000, 0}, {0, 0, 0}, kWindow);
    const double irradiance = solid_angle(kWindow / 2, kHeight) / (kWindow * kWindow);
    expect_mean(b.scene(), kReflectance / kPi * irradiance, 0.003);
}

TEST(Orthographic, SeesALampByItsProjection) {
    SceneBuilder b;
    LightDesc lamp;
    lamp.kind = LightKind::Rect;
    lamp.width = 0.8;
    lamp.height = 0.5;
    lamp.intensity = 3;
    lamp.world_from_light = look_at({0, 0, 0}, {0, 1, 1});
    b.light(lamp);
    b.orthographic({0, 0, 50}, {0, 0, 0}, 2);
    expect_mean(b.scene(), 3 * 0.8 * 0.5 * std::sqrt(0.5) / 4, 0.006);
}

}  // namespace
}  // namespace etendue::test
