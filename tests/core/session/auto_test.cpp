// What the integrator `auto` chooses, and that its pictures are those of the choice.

#include <atomic>

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "session/pilot.h"
#include "support/replicas.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

RenderSettings auto_settings(int size, int samples_per_pixel) {
    RenderSettings settings = small_settings(IntegratorKind::Auto, size, samples_per_pixel);
    settings.light_paths_per_pixel.reset();
    return settings;
}

/// So many samples that a pilot pays.
RenderSettings long_settings() {
    RenderSettings settings = auto_settings(512, 8);
    settings.max_depth = 4;
    return settings;
}

/// A scene, and a pilot of a long render of it.
class Piloted {
public:
    explicit Piloted(const SceneDescription& description, const RenderSettings& settings = long_settings())
        : settings_(settings),
          small_(pilot_settings(settings_)),
          scene_(description, {}),
          strategies_(find_requirements(description, settings_).strategies),
          camera_(description.cameras[0], small_.width, small_.height, small_.conform) {}

    [[nodiscard]] ChosenMethod chosen() const { return choose_method(settings_, scene_, camera_, strategies_, never_); }
    [[nodiscard]] double cost(const ChosenMethod& method) const {
        Pilot pilot(scene_, camera_, small_, strategies_, never_);
        (void)pilot.cost({IntegratorKind::Bdpt, 1});  // tells how bright the picture is
        return pilot.cost(method);
    }
    [[nodiscard]] const Scene& scene() const { return scene_; }

private:
    RenderSettings settings_;
    RenderSettings small_;
    Scene scene_;
    StrategySet strategies_;
    Camera camera_;
    std::atomic<bool> never_{false};
};

/// A ball on the ground under an even sky.
SceneDescription diffuse_day() {
    SceneBuilder b;
    b.quad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, b.diffuse(0.5));
    b.sphere({0, 0.6, 0}, 0.6, b.diffuse(0.8));
    LightDesc dome;
    dome.kind = LightKind::Dome;
    b.light(dome);
    b.camera({0, 2, 5}, {0, 0.4, 0}, 40);
    return b.scene();
}

/// A glass ball over the ground, and a lamp of that radius.
SceneDescription glass_ball(double lamp_radius) {
    SceneBuilder b;
    b.quad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, b.diffuse(0.5));
    b.sphere({0, 1, 0}, 0.5, b.material(DielectricMaterial{}));
    LightDesc lamp;
    lamp.kind = LightKind::Sphere;
    lamp.radius = lamp_radius;
    lamp.intensity = 30;
    lamp.normalize = true;
    lamp.world_from_light = translation({0.5, 4, 0.5});
    b.light(lamp);
    b.camera({0, 3, 5}, {0, 0.4, 0}, 40);
    return b.scene();
}

void expect_same_picture(const RenderedImage& a, const RenderedImage& b) {
    EXPECT_EQ(a.find(Aov::Color)->data, b.find(Aov::Color)->data);
    EXPECT_EQ(a.statistics.rays, b.statistics.rays);
    EXPECT_EQ(a.statistics.light_paths, b.statistics.light_paths);
}

// Diffuse and evenly lit: nothing starts paths at lights, or pays for those who do.
TEST(Auto, RendersAPlainDaysPictureByPathTracing) {
    RenderSettings settings = long_settings();
    settings.max_depth = 2;
    settings.threads = 1;
    const RenderedImage image = render(diffuse_day(), settings);
    ASSERT_EQ(image.statistics.chosen, (ChosenMethod{IntegratorKind::Path, {}}));
    EXPECT_EQ(image.statistics.light_paths, 0U);
    settings.threads = 3;
    expect_same_picture(image, render(diffuse_day(), settings));
    settings.integrator = IntegratorKind::Path;
    expect_same_picture(image, render(diffuse_day(), settings));
}

TEST(Auto, ChoosesTheSameOnAnyNumberOfThreads) {
    RenderSettings settings = long_settings();
    settings.samples_per_pixel = 0;
    settings.time_limit = 100;
    std::optional<ChosenMethod> first;
    for (const int threads : {1, 2, 5}) {
        settings.threads = threads;
        RenderSession session(diffuse_box(), settings);
        session.start();
        while (session.progress().passes_done == 0 && !session.wait_for(0.01)) {
        }
        const std::optional<ChosenMethod> chosen = session.snapshot().statistics.chosen;
        ASSERT_TRUE(chosen);
        if (!first) first = chosen;
        EXPECT_EQ(chosen, first);
    }
}

// Of what it focuses, a trial of path tracing sees nothing, and takes the picture for quiet.
TEST(Auto, IsNotFooledByACausticThatPathTracingDoesNotSee) {
    const ChosenMethod path{IntegratorKind::Path, {}};
    const ChosenMethod bdpt{IntegratorKind::Bdpt, 1};
    for (const double radius : {0.1, 0.01, 0.001}) {
        const Piloted piloted(glass_ball(radius));
        EXPECT_EQ(piloted.chosen().integrator, IntegratorKind::Bdpt) << radius;
        // Its variance goes by one over the lamp's area.
        EXPECT_GT(piloted.cost(path), 0.1 / (radius * radius) * piloted.cost(bdpt)) << radius;
    }
}

// Glass does not matter where path tracing finds the light behind it.
TEST(Auto, TakesPathTracingThroughGlassUnderAnEvenSky) {
    SceneDescription scene = diffuse_day();
    scene.materials.back().model = DielectricMaterial{};
    EXPECT_EQ(Piloted(scene).chosen(), (ChosenMethod{IntegratorKind::Path, {}}));
}

TEST(Auto, KnowsWhatPathTracingCanNeverFind) {
    EXPECT_TRUE(Piloted(glass_ball(0)).scene().needs_light_paths());
    EXPECT_FALSE(Piloted(glass_ball(0.01)).scene().needs_light_paths());
    SceneDescription diffuse = glass_ball(0);
    diffuse.materials.back().model = DiffuseMaterial{};
    EXPECT_FALSE(Piloted(diffuse).scene().needs_light_paths());
    diffuse.materials.back().model = OpenPbrMaterial{};  // a rough coat
    EXPECT_FALSE(Piloted(diffuse).scene().needs_light_paths());
    OpenPbrMaterial coated;
    coated.specular_roughness.value = 0;  // a mirror of 4 %
    diffuse.materials.back().model = coated;
    EXPECT_TRUE(Piloted(diffuse).scene().needs_light_paths());
    EXPECT_EQ(Piloted(diffuse).chosen().integrator, IntegratorKind::Bdpt);
}

TEST(Auto, MakesNoPilotOfAShortRender) {
    RenderSettings settings = auto_settings(16, 4);
    const RenderedImage image = render(diffuse_day(), settings);
    EXPECT_EQ(image.statistics.chosen, ChosenMethod{});
    settings.integrator = IntegratorKind::Bdpt;
    const RenderedImage fixed = render(diffuse_day(), settings);
    expect_same_picture(image, fixed);
    EXPECT_FALSE(fixed.statistics.chosen);
    for (const double target : {0.2, 0.01}) {
        settings = long_settings();
        settings.width = settings.height = 64;
        settings.samples_per_pixel = 0;
        settings.error_target = target;
        EXPECT_EQ(Piloted(diffuse_day(), settings).chosen() == ChosenMethod{}, target > 0.1);
    }
    settings = long_settings();
    settings.time_limit = 1;
    EXPECT_EQ(Piloted(diffuse_day(), settings).chosen(), ChosenMethod{});
}

TEST(Auto, NeedsNoPilotToSeeEmissionAlone) {
    RenderSettings settings = auto_settings(16, 4);
    settings.max_depth = 0;
    EXPECT_EQ(render(diffuse_day(), settings).statistics.chosen, (ChosenMethod{IntegratorKind::Path, {}}));
}

// A render that ends by the clock in its first pass has not seen all of its pixels.
TEST(Auto, LeavesTimeForPasses) {
    const SceneDescription scene = glass_ball(0.001);
    RenderSettings settings = long_settings();
    settings.samples_per_pixel = 0;
    double before = 0;
    for (const double seconds : {5.0, 20.0, 1e4}) {
        settings.time_limit = seconds;
        const ChosenMethod chosen = Piloted(scene, settings).chosen();
        ASSERT_TRUE(chosen.light_paths_per_pixel);
        EXPECT_GE(*chosen.light_paths_per_pixel, before);
        before = *chosen.light_paths_per_pixel;
        settings.width = settings.height = 1 << 14;
        EXPECT_EQ(Piloted(scene, settings).chosen(),
                  (ChosenMethod{IntegratorKind::Bdpt, seconds > 1e3 ? before : 0.25}));
        settings.width = settings.height = 512;
    }
    settings.time_limit = 0;
    settings.samples_per_pixel = 8;
    EXPECT_EQ(Piloted(scene, settings).chosen(), (ChosenMethod{IntegratorKind::Bdpt, before}));
}

// A crop's pilot is of the crop: here of the sky alone, which has no noise, and of everything.
TEST(Auto, LooksAtTheCrop) {
    RenderSettings settings = long_settings();
    settings.crop = PixelWindow{448, 0, 512, 1};
    const RenderSettings small = pilot_settings(settings);
    ASSERT_TRUE(small.crop);
    EXPECT_EQ(small.crop->x1 - small.crop->x0, 64);
    EXPECT_EQ(small.crop->y1 - small.crop->y0, 1);
    settings.crop = PixelWindow{0, 256, 512, 512};
    const RenderSettings half = pilot_settings(settings);
    EXPECT_EQ(half.crop->x1, half.width);
    EXPECT_EQ(half.crop->y1, half.height);
    EXPECT_NEAR(half.crop->y0, 0.5 * half.height, 1);
    settings.crop = PixelWindow{511, 511, 512, 512};
    settings.width = settings.height = 1 << 14;
    EXPECT_EQ(pilot_settings(settings).width, settings.width);
}

TEST(Auto, CanBeCancelledInItsPilot) {
    RenderSession session(glass_ball(0.1), long_settings());
    session.start();
    session.cancel();
    session.wait();
    EXPECT_EQ(session.snapshot().statistics.passes, 0);
    EXPECT_TRUE(session.progress().finished);
}

}  // namespace
}  // namespace etendue::test
