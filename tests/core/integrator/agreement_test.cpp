// Path, light and bidirectional tracing are different estimators of one integral: their pictures must agree on every
// scene that they can all sample (theory.md §8.2).

#include <gtest/gtest.h>

#include "support/replicas.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

struct Case {
    const char* name;
    SceneDescription (*scene)();
    bool light_sees_all;  ///< nothing is seen directly through or in a mirror
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Agreement : public testing::TestWithParam<Case> {};

constexpr int kReplicas = 24;
constexpr int kSize = 16;

TEST_P(Agreement, BdptIsPath) {
    const SceneDescription scene = GetParam().scene();
    const Replicas path = render_replicas(scene, small_settings(IntegratorKind::Path, kSize, 96), kReplicas, 1);
    const Replicas bdpt = render_replicas(scene, small_settings(IntegratorKind::Bdpt, kSize, 32), kReplicas, 2);
    EXPECT_TRUE(same_picture(path, bdpt));
}

TEST_P(Agreement, LightIsPath) {
    if (!GetParam().light_sees_all) return;  // BdptIsPath is the case's test
    const SceneDescription scene = GetParam().scene();
    const Replicas path = render_replicas(scene, small_settings(IntegratorKind::Path, kSize, 96), kReplicas, 3);
    const Replicas light = render_replicas(scene, small_settings(IntegratorKind::Light, kSize, 96), kReplicas, 4);
    EXPECT_TRUE(same_picture(path, light));
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Agreement,
    testing::Values(Case{"diffuse_box", diffuse_box, true}, Case{"indirect_box", indirect_box, true},
                    Case{"glossy_box", glossy_box, true}, Case{"phong_box", phong_box, true},
                    Case{"layered_box", layered_box, false}, Case{"glass_box", glass_box, false},
                    Case{"rough_glass_box", rough_glass_box, true}, Case{"mirror_box", mirror_box, false},
                    Case{"smooth_normals_box", smooth_normals_box, true}, Case{"sky", sky, false},
                    Case{"image_sky", image_sky, true}, Case{"shaped_lights", shaped_lights, true},
                    Case{"many_lights", many_lights, true}, Case{"aimed_lights", aimed_lights, true},
                    Case{"light_crowd", light_crowd, true}, Case{"delta_lights", delta_lights, true},
                    Case{"lens_box", lens_box, false}, Case{"orthographic_box", orthographic_box, true},
                    Case{"orthographic_sky", orthographic_sky, false}, Case{"instanced_box", instanced_box, true},
                    Case{"coordinate_planes", coordinate_planes, true}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace etendue::test
