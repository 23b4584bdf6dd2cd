// In which bodies places and lights lie, and what bodies leave of light.

#include "scene/media.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <etendue/error.h>

#include "bsdf/interior.h"
#include "math/constants.h"
#include "scene/media_probe.h"
#include "scene/scene.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

TEST(Media, AreLeftInAnyOrder) {
    Media media;
    media.enter(3);
    media.enter(5);
    EXPECT_EQ(media.innermost(), 5);
    media.leave(3);  // overlapping bodies
    EXPECT_EQ(media.innermost(), 5);
    media.leave(7);  // was never entered
    EXPECT_EQ(media.innermost(), 5);
    media.leave(5);
    EXPECT_EQ(media, Media{});
    media.leave(5);
    EXPECT_EQ(media, Media{});
    for (MediumId id = 1; id <= 6; ++id) media.enter(id);
    for (MediumId id = 6; id > 2; --id) media.leave(id);
    EXPECT_EQ(media, Media{});  // two were forgotten
}

DielectricMaterial glass(double color, double depth) {
    DielectricMaterial m;
    m.transmission_tint.value = {color, 1, 0};
    m.transmission_depth = depth;
    return m;
}

MaterialDesc named(const MaterialModel& model) {
    MaterialDesc desc;
    desc.model = model;
    return desc;
}

TEST(Interior, AbsorbsByTheColourAtItsDepth) {
    const Rgb mu = *interior_absorption(named(glass(0.25, 2)));
    EXPECT_NEAR(std::exp(-mu.r * 2), 0.25, 1e-15);
    EXPECT_NEAR(std::exp(-mu.r * 1), 0.5, 1e-15);
    EXPECT_EQ(mu.g, 0);
    EXPECT_TRUE(std::isfinite(mu.b));
    EXPECT_LT(std::exp(-mu.b * 2), 1e-300);
    OpenPbrMaterial pbr;
    pbr.transmission_weight.value = 0.5;
    pbr.transmission_color.value = {0.25, 1, 1};
    pbr.transmission_depth = 2;
    EXPECT_EQ(interior_absorption(named(pbr))->r, mu.r);
}

TEST(Interior, IsClearOrNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (double depth : {0.0, -1.0, nan}) {
        EXPECT_EQ(interior_absorption(named(glass(0.25, depth))), Rgb());
    }
    DielectricMaterial textured = glass(0.25, 1);
    textured.transmission_tint.texture = 0;
    EXPECT_EQ(interior_absorption(named(textured)), Rgb());
    OpenPbrMaterial opaque;
    opaque.transmission_depth = 1;
    EXPECT_FALSE(interior_absorption(named(opaque)));
    EXPECT_FALSE(interior_absorption(named(DiffuseMaterial{})));
    EXPECT_FALSE(interior_absorption(named(PreviewSurfaceMaterial{})));
    PreviewSurfaceMaterial clear;
    clear.opacity.value = 0;
    EXPECT_EQ(interior_absorption(named(clear)), Rgb());
    clear.opacity_mode = PreviewOpacityMode::Presence;
    EXPECT_FALSE(interior_absorption(named(clear)));
}

/// Metal lets nothing in, whatever else is said of its inside.
TEST(Interior, IsNoneInMetal) {
    OpenPbrMaterial pbr;
    pbr.transmission_weight.value = 1;
    pbr.transmission_color.value = {0.5, 0.5, 0.5};
    pbr.transmission_depth = 1;
    PreviewSurfaceMaterial preview;
    preview.opacity.value = 0.5;
    ASSERT_TRUE(interior_absorption(named(pbr)));
    ASSERT_TRUE(interior_absorption(named(preview)));
    pbr.base_metalness.value = preview.metallic.value = 1;
    EXPECT_FALSE(interior_absorption(named(pbr)));
    EXPECT_FALSE(interior_absorption(named(preview)));
    preview.use_specular_workflow = true;  // knows no metal
    EXPECT_TRUE(interior_absorption(named(preview)));
    pbr.base_metalness.texture = 0;
    EXPECT_TRUE(interior_absorption(named(pbr)));
}

/// The colour that 1 unit of the media at p leaves, red.
double red_at(const Scene& scene, const Vec3& p) { return scene.absorption().transmittance(media_at(scene, p), 1).r; }

TEST(MediaAt, KnowsNestedBodies) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 3, b.material(glass(0.5, 1)));
    b.sphere({1, 0, 0}, 1, b.material(glass(0.25, 1)));
    b.sphere({1, 0, 0}, 0.5, b.material(glass(1, 0)));  // a clear core
    b.sphere({-1, 0, 0}, 0.3, b.diffuse(0.5));
    const Scene scene(b.scene(), {});
    EXPECT_TRUE(scene.absorbs());
    EXPECT_NEAR(red_at(scene, {0, 0, 5}), 1, 1e-12);
    EXPECT_NEAR(red_at(scene, {0, 2, 0}), 0.5, 1e-12);
    EXPECT_NEAR(red_at(scene, {1, 0.7, 0}), 0.25, 1e-12);
    EXPECT_NEAR(red_at(scene, {1, 0, 0}), 1, 1e-12);
    // Out of the core, out of the ball, out of everything.
    Media media = media_at(scene, {1, 0, 0});
    SurfaceInteraction core = *scene.intersect({{1, 0, 0}, {0, 1, 0}});
    const Vec3 up{0, 1, 0};
    media = scene.absorption().beyond(media, core, -up, up);
    EXPECT_EQ(media, media_at(scene, {1, 0.7, 0}));
    EXPECT_EQ(scene.absorption().beyond(media, core, up, -up), media_at(scene, {1, 0, 0}));  // back in
    EXPECT_EQ(scene.absorption().beyond(media, core, up, up), media);                        // reflected
    media = scene.absorption().beyond(media, *scene.intersect({{1, 0.7, 0}, up}), -up, up);
    EXPECT_EQ(media, media_at(scene, {0, 2, 0}));
    media = scene.absorption().beyond(media, *scene.intersect({{1, 1.5, 0}, up}), -up, up);
    EXPECT_EQ(media, Media{});
}

TEST(MediaAt, KnowsAPoolByItsSurface) {
    SceneBuilder b;
    b.open_box(b.diffuse(0.5));
    b.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, b.material(glass(0.5, 1)));
    b.sphere({0.4, -0.6, 0}, 0.3, b.material(glass(0.25, 1)));
    const Scene scene(b.scene(), {});
    EXPECT_NEAR(red_at(scene, {0.2, 0.5, 0.3}), 1, 1e-12);
    EXPECT_NEAR(red_at(scene, {-0.5, -0.5, 0}), 0.5, 1e-12);
    EXPECT_NEAR(red_at(scene, {0.4, -0.6, 0}), 0.25, 1e-12);
    EXPECT_NEAR(red_at(scene, {0, -3, 0}), 1, 1e-12);  // below the floor
    EXPECT_NEAR(red_at(scene, {0, 0.5, 5}), 1, 1e-12);
}

/// Nothing that it shines at is water's surface; what it lights is.
TEST(LightMedia, OfALampThatLooksDown) {
    SceneBuilder b;
    b.open_box(b.diffuse(0.5));
    b.quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0}, b.diffuse(0.5));
    b.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, b.material(glass(0.5, 1)));
    b.rect_light({0, -0.3, 0}, {0, -1, 0}, 0.5, 0.5, 1);
    b.rect_light({0, 0.3, 0}, {0, 1, 0}, 0.5, 0.5, 1);
    const Scene scene(b.scene(), {});
    const auto red = [&](int light) { return scene.absorption().transmittance(scene.light_media(light), 1).r; };
    EXPECT_NEAR(red(0), 0.5, 1e-12);
    EXPECT_NEAR(red(1), 1, 1e-12);
}

TEST(LightMedia, AreThoseInFrontOfTheLight) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, b.material(glass(0.5, 1)));
    b.rect_light({0, 0, 0}, {0, -1, 0}, 0.5, 0.5, 1);
    b.rect_light({0, 2, 0}, {0, -1, 0}, 0.5, 0.5, 1);
    b.light(point_light({0.5, 0.2, 0}, 1));
    LightDesc dome;
    dome.kind = LightKind::Dome;
    b.light(dome);
    const int glow = b.material(DiffuseMaterial{}, {1, 1, 1});
    Matrix4 small = translation({0, 0.9, 0});
    small.m[0] = small.m[5] = small.m[10] = 0.25;
    b.shape(low_polygon_sphere(8, 6, false), glow, small);  // sticks out of the ball; most of it lies in it
    const Scene scene(b.scene(), {});
    const auto red = [&](int light) { return scene.absorption().transmittance(scene.light_media(light), 1).r; };
    EXPECT_NEAR(red(0), 0.5, 1e-12);
    EXPECT_NEAR(red(1), 1, 1e-12);
    EXPECT_NEAR(red(2), 0.5, 1e-12);
    EXPECT_NEAR(red(3), 1, 1e-12);
    EXPECT_NEAR(red(4), 0.5, 1e-12);
}

TEST(Absorption, IsNobodysBusinessWhereAllIsClear) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, b.material(glass(0.5, 0)));
    const Scene scene(b.scene(), {});
    EXPECT_FALSE(scene.absorbs());
    EXPECT_EQ(media_at(scene, {0, 0, 0}), Media{});
}

/// More bodies than can be told apart are no error unless someone asks which is which.
TEST(Absorption, CountsBodiesOnlyWhereOneAbsorbs) {
    std::vector<MaterialDesc> many(70'000, named(glass(0.5, 0)));
    EXPECT_FALSE(Absorption(many).any());
    many.front() = named(glass(0.5, 1));
    EXPECT_THROW(Absorption{many}, SceneError);
}

TEST(Absorption, LeavesNothingOfWhatGoesOnForEver) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, b.material(glass(0.5, 1)));
    const Scene scene(b.scene(), {});
    const Rgb left = scene.absorption().transmittance(media_at(scene, {0, 0, 0}), kInfinity);
    EXPECT_EQ(left, Rgb(0, 1, 0));
    EXPECT_EQ(scene.absorption().transmittance(Media{}, kInfinity), Rgb(1));
}

}  // namespace
}  // namespace etendue::test
