// The classic Phong form is not symmetric (theory.md §7). A facet lit by a sun: light tracing sees it as path tracing
// does with the adjoint, and wrong by exactly the predicted ratio without.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "math/constants.h"
#include "support/replicas.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

constexpr double kReflectance = 0.8;
constexpr double kExponent = 6;
constexpr double kIlluminance = 3;
constexpr double kDistance = 200;  ///< of the camera: all rays are parallel, nearly
constexpr double kRadians = kPi / 180;

/// Angles in degrees from the normal, +z, in the plane of x and z.
struct Case {
    double sun;
    double camera;
};

void PrintTo(const Case& c, std::ostream* out) { *out << "sun " << c.sun << ", camera " << c.camera; }

Vec3 direction(double degrees) { return {std::sin(degrees * kRadians), 0, std::cos(degrees * kRadians)}; }

class PhongFacet : public testing::TestWithParam<Case> {
protected:
    Vec3 sun_ = direction(GetParam().sun);
    Vec3 camera_ = direction(GetParam().camera);

    SceneDescription scene() const {
        SceneBuilder b;
        PhongMaterial phong;
        phong.reflectance.value = {kReflectance, kReflectance, kReflectance};
        phong.exponent.value = kExponent;
        phong.form = PhongForm::Classic;
        b.quad({-0.3, -0.3, 0}, {0.6, 0, 0}, {0, 0.6, 0}, b.material(phong));
        LightDesc sun;
        sun.kind = LightKind::Distant;
        sun.angle = 0;
        sun.intensity = kIlluminance;
        sun.world_from_light = look_at(sun_, {0, 0, 0});
        b.light(sun);
        const double half = 0.25 * camera_.z;  // the facet, foreshortened, fills the view
        b.camera(camera_ * kDistance, {0, 0, 0}, 2 * std::atan(half / kDistance) / kRadians);
        return b.scene();
    }

    /// The irradiance's cosine is what the form divides by.
    double right() const {
        const double cos = dot({-sun_.x, 0, sun_.z}, camera_);
        return kReflectance * (kExponent + 1) / (2 * kPi) * std::pow(cos, kExponent) * kIlluminance;
    }

    Replicas trace_light(bool corrected, std::uint64_t stream) const {
        RenderSettings settings = small_settings(IntegratorKind::Light, 4, 3000);
        settings.max_depth = 1;
        settings.adjoint.phong = corrected;
        return render_replicas(scene(), settings, 16, stream);
    }
};

TEST_P(PhongFacet, IsTheSameFromEitherEnd) {
    RenderSettings settings = small_settings(IntegratorKind::Path, 4, 4);
    settings.adjoint.phong = false;  // the camera side never needs it
    EXPECT_TRUE(mean_is(render_replicas(scene(), settings, 2, 1), right(), 0.001));
    EXPECT_TRUE(mean_is(trace_light(true, 2), right(), 0.005));
}

TEST_P(PhongFacet, IsWrongAsPredictedWithoutTheAdjoint) {
    EXPECT_TRUE(mean_is(trace_light(false, 3), right() * sun_.z / camera_.z, 0.005));
}

INSTANTIATE_TEST_SUITE_P(Angles, PhongFacet, testing::Values(Case{0, 0}, Case{40, -10}, Case{-70, 30}));

}  // namespace
}  // namespace etendue::test
