// A glowing triangle a million times as long as wide. Embree knows its plane so badly that rays which leave it hit it
// again, at a point in its own plane: no light gets there from where they left.

#include <cmath>

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "math/constants.h"
#include "support/replicas.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

/// Seen at right angles, its width the picture's.
SceneDescription glowing_needle() {
    MeshDesc needle;
    needle.points = {{-0x1.c71e2ep-1F, -0x1.d13be2p-5F, 0x1.b0ad2cp-2F},
                     {-0x1.13e604p+0F, 0x1.839a8p-4F, 0x1.f0c234p-2F},
                     {-0x1.a4ea4cp+0F, 0x1.1909ap-1F, 0x1.5880cep-1F}};
    needle.face_vertex_counts = {3};
    needle.face_vertex_indices = {0, 1, 2};
    const Vec3 a{needle.points[0]};
    const Vec3 b{needle.points[1]};
    const Vec3 c{needle.points[2]};
    const Vec3 area = cross(b - a, c - a);
    const double width = length(area) / length(c - a);
    const Vec3 middle = (a + b + c) / 3;
    SceneBuilder builder;
    builder.shape(needle, builder.material(DiffuseMaterial{{{1, 1, 1}}}, {1, 1, 1}));
    builder.camera(middle + normalize(area), middle, std::atan(width) * 90 / kPi);
    return builder.scene();
}

TEST(Needle, GivesNoLightOfItsOwnPlane) {
    RenderSettings settings = small_settings(IntegratorKind::Path, 8, 16);
    settings.max_depth = 4;
    RenderSession session(glowing_needle(), settings);
    session.start();
    session.wait();
    const RenderStatistics statistics = session.snapshot().statistics;
    EXPECT_EQ(statistics.invalid[static_cast<std::size_t>(InvalidKind::NotANumber)], 0U);  // was 147 of 1024
}

}  // namespace
}  // namespace etendue::test
