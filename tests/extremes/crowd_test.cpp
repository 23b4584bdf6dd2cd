// Ten thousand lights. That choosing among them costs little is tested in core/light/light_choice_test.cpp.

#include "extremes/agreement.h"
#include "extremes/extreme.h"
#include "extremes/pictures.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

constexpr int kRows = 100;

/// A ceiling of lamps, 1.8 wide in all, over a box; `rows` squared of them.
SceneDescription lit_by(int rows) {
    SceneBuilder b;
    b.open_box(b.diffuse(0.5));
    const double width = 1.8 / rows;
    for (int i = 0; i < rows * rows; ++i) {
        const int column = i % rows;
        const int row = i / rows;
        const double x = (column + 0.5) * width - 0.9;
        const double z = (row + 0.5) * width - 0.9;
        b.rect_light({x, 0.9, z}, {0, -1, 0}, width, width, 4.0 / (rows * rows));
    }
    b.camera({0.1, 0.1, 3.8}, {0, 0, 0}, 36);
    return b.scene();
}

TEST(Crowd, OfTenThousandLampsIsOneLargeLamp) {
    for (const auto& [integrator, name] : kNamedIntegrators) {
        const int samples = integrator == IntegratorKind::Light ? 64 : 16;
        RenderSettings settings = small_settings(integrator, 8, samples);
        // Building the scene takes most of the time.
        const Replicas many = render_replicas(lit_by(kRows), settings, kReplicas, 1);
        const Replicas one = render_replicas(lit_by(1), settings, kReplicas, 2);
        EXPECT_TRUE(same_picture(many, one, 0.05)) << name;
        EXPECT_TRUE(at_most({"many lights", std::string("10,000 lamps in one plane, ") + name,
                             "one lamp as large: standard errors apart"},
                            errors_apart(many, one), kMostErrors));
    }
}

}  // namespace
}  // namespace etendue::test
