// Images of one pixel, and of one row or column of 16,384.

#include <algorithm>
#include <cmath>
#include <string>

#include "extremes/agreement.h"
#include "extremes/extreme.h"
#include "extremes/furnace.h"
#include "extremes/pictures.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

constexpr int kLong = 16384;

TEST(ImageSize, OnePixelIsTheMeanOfAll) {
    for (const auto& [integrator, name] : kNamedIntegrators) {
        RenderSettings one = small_settings(integrator, 1, 1024);
        RenderSettings many = small_settings(integrator, 8, 16);
        const Replicas a = render_replicas(many_lights(), one, kReplicas, 1);
        const Replicas b = render_replicas(many_lights(), many, kReplicas, 2);
        EXPECT_TRUE(at_most({"image size", std::string("1 x 1, ") + name, "the mean of 8 x 8: standard errors apart"},
                            errors_apart(a, b), kMostErrors));
    }
}

/// Nothing but sky, of radiance 1, in every pixel, however long the image makes the aperture.
TEST(ImageSize, LongImagesShowTheSky) {
    SceneBuilder b;
    b.light(white_sky());
    b.camera({0, 0, 4}, {0, 0, 0}, 40);
    for (const bool wide : {true, false}) {
        for (const ApertureConform conform : {ApertureConform::ExpandAperture, ApertureConform::CropAperture}) {
            double worst = 0;
            for (const IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
                RenderSettings settings = endless(integrator, 1);
                settings.width = wide ? kLong : 1;
                settings.height = wide ? 1 : kLong;
                settings.conform = conform;
                const Replicas seen = render_replicas(b.scene(), settings, 4, 1);
                worst = std::max(worst, relative_error(seen, 1));
            }
            EXPECT_TRUE(at_most({"image size",
                                 std::string(wide ? "16384 x 1" : "1 x 16384") +
                                     (conform == ApertureConform::ExpandAperture ? ", expanded" : ", cropped"),
                                 "a white sky: deviation of the mean from 1"},
                                worst, 2e-4));
        }
    }
}

}  // namespace
}  // namespace etendue::test
