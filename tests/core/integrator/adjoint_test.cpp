// Shading normals make scattering asymmetric (theory.md §6). Facets whose normals are tilted by a known angle, lit by a
// sun: what light tracing sees of them is right with the correction, and wrong without it by exactly the factor that
// theory predicts.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "math/constants.h"
#include "support/replicas.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

constexpr double kReflectance = 0.8;
constexpr double kIlluminance = 3;
constexpr double kFacet = 0.3;      ///< half-width
constexpr double kDistance = 200;   ///< of the camera: all rays are parallel, nearly
constexpr double kHalfView = 0.25;  ///< seen of the facet, across the view
constexpr double kRadians = kPi / 180;

/// Angles in degrees from the geometric normal, +z, in the plane of x and z; `azimuth` turns the camera out of it.
struct Case {
    double tilt;  ///< of the shading normal
    double sun;
    double camera;
    double azimuth = 0;
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << "tilt " << c.tilt << ", sun " << c.sun << ", camera " << c.camera << ", azimuth " << c.azimuth;
}

Vec3 direction(double degrees, double azimuth = 0) {
    const double s = std::sin(degrees * kRadians);
    return {s * std::cos(azimuth * kRadians), s * std::sin(azimuth * kRadians), std::cos(degrees * kRadians)};
}

class Facet : public testing::TestWithParam<Case> {
protected:
    Vec3 n_g_{0, 0, 1};
    Vec3 n_s_ = direction(GetParam().tilt);
    Vec3 sun_ = direction(GetParam().sun);
    Vec3 camera_ = direction(GetParam().camera, GetParam().azimuth);

    SceneDescription scene() const {
        SceneBuilder b;
        const Float3 n{static_cast<float>(n_s_.x), static_cast<float>(n_s_.y), static_cast<float>(n_s_.z)};
        MeshDesc mesh;
        const auto size = static_cast<float>(kFacet);
        mesh.points = {{-size, -size, 0}, {size, -size, 0}, {size, size, 0}, {-size, size, 0}};
        mesh.normals.assign(4, n);
        mesh.face_vertex_counts = {4};
        mesh.face_vertex_indices = {0, 1, 2, 3};
        b.shape(mesh, b.diffuse(kReflectance));
        LightDesc sun;
        sun.kind = LightKind::Distant;
        sun.angle = 0;
        sun.intensity = kIlluminance;
        sun.world_from_light = look_at(sun_, {0, 0, 0});
        b.light(sun);
        // The facet, foreshortened, fills the view.
        const double half = kHalfView * std::abs(dot(camera_, n_g_));
        b.camera(camera_ * kDistance, {0, 0, 0}, 2 * std::atan(half / kDistance) / kRadians);
        return b.scene();
    }

    double right() const { return kReflectance / kPi * kIlluminance * dot(sun_, n_s_); }
    /// Of theory.md §6.
    double wrong_over_right() const {
        return std::abs(dot(sun_, n_g_) * dot(camera_, n_s_) / (dot(sun_, n_s_) * dot(camera_, n_g_)));
    }
};

Replicas trace_light(const SceneDescription& scene, bool corrected, std::uint64_t stream) {
    RenderSettings settings = small_settings(IntegratorKind::Light, 4, 3000);
    settings.max_depth = 1;
    settings.adjoint.shading_normal = corrected;
    return render_replicas(scene, settings, 16, stream);
}

TEST_P(Facet, IsTheSameFromEitherEnd) {
    RenderSettings settings = small_settings(IntegratorKind::Path, 4, 4);
    EXPECT_TRUE(mean_is(render_replicas(scene(), settings, 2, 1), right(), 1e-6));
    EXPECT_TRUE(mean_is(trace_light(scene(), true, 2), right(), 0.005));
}

TEST_P(Facet, IsWrongAsPredictedWithoutTheCorrection) {
    const Replicas wrong = trace_light(scene(), false, 3);
    EXPECT_TRUE(mean_is(wrong, right() * wrong_over_right(), 0.005));
    RecordProperty("predicted_ratio", std::to_string(wrong_over_right()));
    RecordProperty("measured_ratio", std::to_string(wrong.mean() / right()));
}

TEST_P(Facet, SeenFromTheCameraNeedsNoCorrection) {
    RenderSettings settings = small_settings(IntegratorKind::Path, 4, 4);
    settings.adjoint.shading_normal = false;
    EXPECT_TRUE(mean_is(render_replicas(scene(), settings, 2, 1), right(), 1e-6));
}

INSTANTIATE_TEST_SUITE_P(Angles, Facet,
                         testing::Values(Case{0, 40, 20}, Case{20, 0, 0}, Case{20, 40, -30}, Case{20, -40, 30},
                                         Case{35, 60, 0}, Case{35, -30, 10}, Case{-45, 20, 30, 90},
                                         Case{-45, -70, 40, 120}));

}  // namespace
}  // namespace etendue::test
