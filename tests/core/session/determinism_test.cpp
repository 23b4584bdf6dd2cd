// The seed alone decides the picture: neither threads, nor chance, nor what else the process renders.

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "support/replicas.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

class Determinism : public testing::TestWithParam<IntegratorKind> {
protected:
    static RenderSettings settings() {
        // More than one tile each way, the last ones narrow, and light paths that do not share out evenly.
        RenderSettings s = small_settings(GetParam(), 39, 3);
        s.light_paths_per_pixel = 0.7;
        s.filter = {FilterKind::Gaussian, 1.3};
        s.aovs = {Aov::Color, Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo, Aov::SampleCount, Aov::Variance};
        s.seed = 7;
        return s;
    }
};

void expect_identical(const RenderedImage& a, const RenderedImage& b) {
    ASSERT_EQ(a.aovs.size(), b.aovs.size());
    for (std::size_t i = 0; i < a.aovs.size(); ++i)
        EXPECT_EQ(a.aovs[i].data, b.aovs[i].data) << aov_name(a.aovs[i].aov);
    EXPECT_EQ(a.statistics.passes, b.statistics.passes);
    EXPECT_EQ(a.statistics.camera_paths, b.statistics.camera_paths);
    EXPECT_EQ(a.statistics.light_paths, b.statistics.light_paths);
    EXPECT_EQ(a.statistics.rays, b.statistics.rays);
}

TEST_P(Determinism, ThreadsDoNotMatter) {
    RenderSettings s = settings();
    for (const SceneDescription& scene : {many_lights(), lens_box()}) {
        s.threads = 1;
        const RenderedImage expected = render(scene, s);
        for (int threads : {2, 3, 5}) {
            s.threads = threads;
            expect_identical(expected, render(scene, s));
        }
    }
}

TEST_P(Determinism, SeedsMatter) {
    RenderSettings s = settings();
    const RenderedImage a = render(diffuse_box(), s);
    expect_identical(a, render(diffuse_box(), s));
    s.seed = 8;
    EXPECT_NE(a.find(Aov::Color)->data, render(diffuse_box(), s).find(Aov::Color)->data);
}

TEST_P(Determinism, SessionsShareNothing) {
    RenderSettings s = settings();
    const RenderedImage box = render(glass_box(), s);
    const RenderedImage day = render(sky(), s);
    RenderSession first(glass_box(), s);
    RenderSession second(sky(), s);
    RenderSession third(glass_box(), s);
    first.start();
    second.start();
    third.start();
    first.wait();
    second.wait();
    third.wait();
    expect_identical(box, first.snapshot());
    expect_identical(day, second.snapshot());
    expect_identical(box, third.snapshot());
}

// A render of n passes is the beginning of a render of more.
TEST_P(Determinism, PassesAreTheSameInLongerRenders) {
    RenderSettings s = settings();
    s.aovs = {Aov::Color};
    s.samples_per_pixel = 1;
    const RenderedImage one = render(diffuse_box(), s);
    s.samples_per_pixel = 2;
    const RenderedImage two = render(diffuse_box(), s);
    EXPECT_EQ(two.statistics.camera_paths, 2 * one.statistics.camera_paths);
    EXPECT_EQ(two.statistics.light_paths, 2 * one.statistics.light_paths);
    EXPECT_NE(one.find(Aov::Color)->data, two.find(Aov::Color)->data);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Determinism,
                         testing::Values(IntegratorKind::Path, IntegratorKind::Light, IntegratorKind::Bdpt));

class Nothing : public testing::TestWithParam<IntegratorKind> {};

void expect_black(const SceneDescription& scene, IntegratorKind integrator) {
    RenderSettings s = small_settings(integrator, 8, 4);
    s.aovs = {Aov::Color, Aov::Variance};
    const RenderedImage image = render(scene, s);
    for (const AovImage& aov : image.aovs) {
        for (float v : aov.data) EXPECT_EQ(v, 0);
    }
    for (std::uint64_t n : image.statistics.invalid) EXPECT_EQ(n, 0U);
    EXPECT_EQ(image.statistics.passes, 4);
}

TEST_P(Nothing, IsSeenWithoutLights) {
    SceneDescription scene = diffuse_box();
    scene.lights.clear();
    expect_black(scene, GetParam());
    scene = diffuse_box();
    scene.lights[0].intensity = 0;
    expect_black(scene, GetParam());
}

TEST_P(Nothing, IsSeenWithoutGeometry) {
    SceneBuilder b;
    b.camera({0, 0, 1}, {0, 0, 0}, 40);
    expect_black(b.scene(), GetParam());
    b.light(point_light({0, 0, 0}, 1));
    expect_black(b.scene(), GetParam());
}

TEST_P(Nothing, ButTheSkyIsSeenInAnEmptyScene) {
    SceneBuilder b;
    b.camera({0, 0, 1}, {0, 0, 0}, 40);
    LightDesc dome;
    dome.kind = LightKind::Dome;
    dome.intensity = 2;
    b.light(dome);
    // Light paths that start towards the whole sphere seldom go to the lens.
    const bool by_light = GetParam() == IntegratorKind::Light;
    const Replicas sky = render_replicas(b.scene(), small_settings(GetParam(), 8, by_light ? 64 : 8), 16, 1);
    EXPECT_TRUE(mean_is(sky, 2, by_light ? 0.05 : 0.001));
}

INSTANTIATE_TEST_SUITE_P(Integrators, Nothing,
                         testing::Values(IntegratorKind::Path, IntegratorKind::Light, IntegratorKind::Bdpt));

}  // namespace
}  // namespace etendue::test
