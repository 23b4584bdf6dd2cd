// Shading normals that lean far from the geometry, up to 89 degrees, or face away from it. The factor of theory.md §6
// is unbounded there: it must stay finite, and right in the mean. Tilts up to 45 degrees, and what leaving the factor
// out does, are tested in core/integrator/adjoint_test.cpp.

#include <cmath>
#include <string>

#include "extremes/agreement.h"
#include "extremes/extreme.h"
#include "extremes/pictures.h"
#include "math/constants.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

constexpr double kDegree = kPi / 180;

/// The tilted normal of a mesh that lies in a plane: from n_g, +z, towards x.
Float3 tilted(double degrees) {
    return {static_cast<float>(std::sin(degrees * kDegree)), 0, static_cast<float>(std::cos(degrees * kDegree))};
}

MeshDesc square(const Float3& normal) {
    MeshDesc mesh;
    mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, normal);
    mesh.face_vertex_counts = {4};
    mesh.face_vertex_indices = {0, 1, 2, 3};
    return mesh;
}

/// A square with a tilted normal under a sun so many degrees off, towards the tilt; seen by parallel rays from 30
/// degrees.
SceneDescription facet(double tilt, double sun_angle) {
    SceneBuilder b;
    b.shape(square(tilted(tilt)), b.diffuse(0.8));
    LightDesc sun;
    sun.kind = LightKind::Distant;
    sun.angle = 0;
    sun.intensity = 3;
    sun.world_from_light = look_at({std::sin(sun_angle * kDegree), 0, std::cos(sun_angle * kDegree)}, {0, 0, 0});
    b.light(sun);
    b.orthographic({std::sin(30 * kDegree) * 4, 0, std::cos(30 * kDegree) * 4}, {0, 0, 0}, 1.6);
    return b.scene();
}

TEST(Normals, FacetsHaveTheirKnownRadiance) {
    constexpr double kSun = 88;  // particles weigh up to 40 times more than without the factor
    for (const double tilt : {60.0, 80.0, 89.0}) {
        const double expected = 0.8 / kPi * 3 * std::cos((tilt - kSun) * kDegree);
        for (const auto& [integrator, name] : kNamedIntegrators) {
            const Replicas seen =
                replicas(facet(tilt, kSun), integrator, integrator == IntegratorKind::Light ? 400 : 4);
            EXPECT_TRUE(mean_is(seen, expected, 0.02)) << tilt << name;
            EXPECT_TRUE(at_most({"shading normals", "a facet tilted by " + in_words(tilt) + " degrees, " + name,
                                 "albedo E cos / pi: relative deviation of the mean"},
                                relative_error(seen, expected), 0.02));
        }
    }
}

TEST(Normals, ThatFaceAwayAreBlack) {
    for (const double tilt : {91.0, 150.0, 180.0}) {
        double brightest = 0;
        for (const IntegratorKind integrator : kIntegrators) {
            const Replicas seen = replicas(facet(tilt, 0), integrator, 4);
            brightest = std::max(brightest, seen.mean());
            EXPECT_EQ(seen.invalid, 0);
        }
        EXPECT_TRUE(at_most({"shading normals", "a facet tilted by " + in_words(tilt) + " degrees, sun along n_g",
                             "black: the brightest mean"},
                            brightest, 0));
    }
}

/// A box whose walls' normals lean along them; light goes from wall to wall. The lamp is not in the picture.
SceneDescription leaning_box(double tilt, const MaterialModel& model) {
    SceneBuilder b;
    const int walls = b.diffuse(0.6);
    const int other = b.material(model);
    b.shape(square(tilted(tilt)), walls, translation({0, 0, -1}));
    const Matrix4 floor{{1, 0, 0, 0, 0, 0, 1, -1, 0, -1, 0, 0, 0, 0, 0, 1}};
    b.shape(square(tilted(-tilt)), other, floor);
    const Matrix4 left{{0, 0, 1, -1, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1}};
    b.shape(square(tilted(tilt)), walls, left);
    b.rect_light({0.1, 0.95, 0}, {0, -1, 0}, 0.7, 0.7, 4);
    b.camera({0.1, 0.3, 2.4}, {-0.3, -0.9, -0.4}, 30);
    return b.scene();
}

struct Floor {
    const char* name;
    MaterialModel model;
    bool joined_to_the_lens;
};

std::vector<Floor> floors() {
    ConductorMaterial metal;
    metal.roughness.value = 0.5;
    DielectricMaterial frosted;
    frosted.roughness.value = 0.5;
    return {{"diffuse", DiffuseMaterial{}, true},
            {"rough metal", metal, true},
            {"mirror", ConductorMaterial{}, false},
            {"frosted glass", frosted, true},
            {"smooth glass", DielectricMaterial{}, false}};
}

TEST(Normals, IntegratorsAgreeInALeaningBox) {
    for (const double tilt : {80.0, 89.0}) {
        for (const Floor& floor : floors()) {
            const SceneDescription scene = leaning_box(tilt, floor.model);
            const std::string where = "walls tilted by " + in_words(tilt) + " degrees, floor of " + floor.name;
            const Replicas path = replicas(scene, IntegratorKind::Path);
            const auto expect_agreement = [&](const Replicas& other, const std::string& name) {
                EXPECT_TRUE(same_picture(path, other, 0.1)) << where;
                EXPECT_TRUE(at_most({"shading normals", where, "path and " + name + ": standard errors apart"},
                                    errors_apart(path, other), kMostErrors));
            };
            expect_agreement(replicas(scene, IntegratorKind::Bdpt), "bdpt");
            if (floor.joined_to_the_lens) expect_agreement(replicas(scene, IntegratorKind::Light, 128), "light");
        }
    }
}

}  // namespace
}  // namespace etendue::test
