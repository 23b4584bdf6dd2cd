// Weights that sum to one may still be bad weights: on caustics the full set of strategies must not be much noisier
// than its best subset at equal samples (transport.md §1). With the densities of delta lobes left out, it is.

#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/estimate.h"
#include "support/replicas.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

/// Variance of one render's pixel, averaged over pixels. Each replica's mean squared deviation is one sample of it,
/// which gives its standard error without any assumption about how noise is distributed.
Estimate pixel_variance(const Replicas& replicas) {
    const auto n = static_cast<double>(replicas.images.size());
    std::vector<double> means(replicas.images[0].size());
    for (const auto& image : replicas.images) {
        for (std::size_t i = 0; i < means.size(); ++i) means[i] += image[i] / n;
    }
    Estimate variance;
    for (const auto& image : replicas.images) {
        double sum = 0;
        for (std::size_t i = 0; i < means.size(); ++i) sum += (image[i] - means[i]) * (image[i] - means[i]);
        variance.add(sum / static_cast<double>(means.size()) * n / (n - 1));
    }
    return variance;
}

/// A lamp far above a glass sphere that all but touches the floor: where distances before and after a chain of delta
/// lobes differ most, weights that forget them go most wrong.
SceneDescription distant_lamp() {
    SceneBuilder b;
    b.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, b.diffuse(0.7));
    b.sphere({0, 0.5, 0}, 0.4, b.material(DielectricMaterial{}));
    b.rect_light({0.5, 8, 0}, {0, -1, 0}, 2, 2, 100);
    b.camera({0, 1.2, 3.5}, {0, 0.2, 0}, 32);
    return b.scene();
}

/// Light of a far lamp that a flat mirror throws on the floor.
SceneDescription mirrored_lamp() {
    SceneBuilder b;
    b.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, b.diffuse(0.7));
    b.quad({-1, 0.1, -1}, {2, 0, 0}, {0, 1, 0}, b.material(ConductorMaterial{}));
    b.rect_light({0, 5, 5}, {0, -1, -1}, 1, 1, 60);
    b.camera({0, 4, 0.4}, {0, 0, 0.4}, 20);  // the mirror is out of view
    return b.scene();
}

struct Case {
    const char* name;
    SceneDescription (*scene)();
    /// Where light tracing alone carries the picture (nothing is seen in or through a smooth surface, no lamp either):
    /// what of its variance may be left. 0 elsewhere.
    double of_light_image = 0;
    int replicas = 64;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

struct Subset {
    const char* name;
    StrategySet strategies;
};

/// Those that carry the whole picture. Weights decide about all but the last, which therefore holds however wrong they
/// are; it carries the picture only of some scenes.
constexpr Subset kSubsets[]{
    {"emission", {true, false, false, false, false}},
    {"emission, direct", {true, true, false, false, false}},
    {"emission, light image", {true, false, false, true, false}},
    {"emission, direct, connection", {true, true, true, false, false}},
    {"emission, direct, light image", {true, true, false, true, false}},
    {"light image", {false, false, false, true, false}},
};

class WeightVariance : public testing::TestWithParam<Case> {};

constexpr double kAllowed = 1.2;

TEST_P(WeightVariance, AllStrategiesAreAsGoodAsTheBestSubset) {
    const SceneDescription scene = GetParam().scene();
    RenderSettings settings = small_settings(IntegratorKind::Bdpt, 16, 16);
    settings.max_depth = 6;
    const int replicas = GetParam().replicas;
    const Estimate all = pixel_variance(render_replicas(scene, settings, replicas, 1));
    std::cout << std::setprecision(3) << GetParam().name << ": all " << all.mean() << " +- " << all.standard_error();
    std::uint64_t stream = 2;
    for (const Subset& subset : kSubsets) {
        const bool light_alone = !subset.strategies.emission_hit;
        if (light_alone && GetParam().of_light_image == 0) continue;
        const double allowed = light_alone ? GetParam().of_light_image : kAllowed;
        settings.strategies = subset.strategies;
        const Estimate part = pixel_variance(render_replicas(scene, settings, replicas, stream++));
        std::cout << "; " << subset.name << ' ' << part.mean() << " +- " << part.standard_error();
        const double noise = kSigmas * std::hypot(all.standard_error(), allowed * part.standard_error());
        EXPECT_LE(all.mean(), allowed * part.mean() + noise) << subset.name;
    }
    std::cout << '\n';
    if (full_effort()) EXPECT_LT(all.standard_error(), 0.15 * all.mean()) << "too noisy to tell";
}

INSTANTIATE_TEST_SUITE_P(Scenes, WeightVariance,
                         testing::Values(Case{"glass_box", glass_box}, Case{"pool", pool, 0.8},
                                         Case{"distant_lamp", distant_lamp, 0, 160},
                                         Case{"mirrored_lamp", mirrored_lamp, 0.4}, Case{"sky", sky}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace etendue::test
