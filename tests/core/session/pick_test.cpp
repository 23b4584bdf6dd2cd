// What a point of the picture shows.

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "support/replicas.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

/// Seen from above, eight units wide: two quads of two triangles, a ball, two instances, a lamp.
SceneDescription table() {
    SceneBuilder b;
    const int grey = b.diffuse(0.5);
    b.quad({-4, -4, 0}, {4, 0, 0}, {0, 4, 0}, grey);
    b.sphere({2, -2, 0}, 1, grey);
    b.scene().geometries.emplace_back(PlaneDesc{.width = 1, .length = 1});
    b.scene().groups = {
        {"/group", {{"/group/ball", 1, {grey}, translation({0, 0, -9})}, {"/group/leaf", 2, {grey}, {}}}}};
    b.scene().instances = {{"/a", 0, translation({-2, 2, 0})}, {"/b", 0, translation({2, 2, 0})}};
    b.rect_light({0, 0, 5}, {0, 0, 1}, 0.5, 0.5, 1);
    b.orthographic({0, 0, 9}, {0, 0, 0}, 8);
    return b.scene();
}

struct Case {
    double x;  ///< in the scene
    double y;
    PickedSurface expected;
};

TEST(Pick, TellsShapeInstanceAndTriangle) {
    const RenderSession session(table(), small_settings(IntegratorKind::Path, 16, 1));
    for (const Case& c : {Case{-1, -3, {0, -1, 0}}, Case{-3, -1, {0, -1, 1}}, Case{2, -2, {1, -1, 0}},
                          Case{-1.8, 1.9, {1, 0, 0}}, Case{2.1, 1.8, {1, 1, 0}}, Case{0, 0, {-1, -1, 0}}}) {
        const auto picked = session.pick(8 + 2 * c.x, 8 - 2 * c.y);
        ASSERT_TRUE(picked) << c.x << " " << c.y;
        EXPECT_EQ(picked->shape, c.expected.shape) << c.x << " " << c.y;
        EXPECT_EQ(picked->instance, c.expected.instance) << c.x << " " << c.y;
        if (c.expected.instance < 0 && c.expected.shape >= 0) EXPECT_EQ(picked->triangle, c.expected.triangle);
    }
    EXPECT_FALSE(session.pick(15.9, 0.1));
}

}  // namespace
}  // namespace etendue::test
