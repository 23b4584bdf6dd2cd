// Every strategy (s, t) alone, unweighted, estimates the same picture as any other that samples the same paths
// (theory.md §2, §8.1), and every set of strategies that covers all paths agrees with every other, whatever the number
// of light paths, the pixel filter and the part of the image asked for.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/estimate.h"
#include "support/replicas.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

// ------------------------------------------------------------------------------------------ one strategy alone

/// Surfaces that never touch: next to a corner, connections alone have infinite variance (1/d^2), and tests of means
/// say nothing. No surface is smooth, so that all strategies sample all paths.
SceneBuilder gallery(const MaterialModel& model) {
    SceneBuilder b;
    const int grey = b.diffuse(0.7);
    b.quad({-1.2, -0.9, 0.9}, {2.4, 0, 0}, {0, 0, -1.5}, grey);  // floor
    b.quad({-1.2, -0.6, -1}, {2.4, 0, 0}, {0, 1.7, 0.2}, grey);  // back wall
    b.sphere({0, -0.1, 0}, 0.5, b.material(model));
    b.camera({0.1, 0.2, 3.8}, {0, 0, 0}, 36);
    return b;
}

SceneBuilder lit_gallery(const MaterialModel& model) {
    SceneBuilder b = gallery(model);
    b.rect_light({0.2, 1.2, 0.2}, {-0.2, -1, -0.2}, 0.9, 0.9, 4);
    return b;
}

DielectricMaterial frosted_glass() {
    DielectricMaterial m;
    m.roughness.value = 0.6;
    return m;
}

SceneDescription diffuse() { return lit_gallery(DiffuseMaterial{{{0.8, 0.6, 0.4}}}).scene(); }

SceneDescription metal() {
    ConductorMaterial m;
    m.roughness.value = 0.6;
    return lit_gallery(m).scene();
}

SceneDescription plastic() {
    PreviewSurfaceMaterial m;
    m.diffuse_color.value = {0.2, 0.5, 0.7};
    m.roughness.value = 0.5;
    m.clearcoat.value = 1;
    m.clearcoat_roughness.value = 0.6;
    return lit_gallery(m).scene();
}

SceneDescription rough_glass() { return lit_gallery(frosted_glass()).scene(); }

/// Normals of the mesh turned away from its geometric normal by a known angle, everywhere the same way.
MeshDesc tilted_quad(const Vec3& corner, const Vec3& u, const Vec3& v, const Vec3& towards) {
    const auto narrow = [](const Vec3& p) {
        return Float3{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    };
    MeshDesc mesh;
    mesh.points = {narrow(corner), narrow(corner + u), narrow(corner + u + v), narrow(corner + v)};
    mesh.normals.assign(4, narrow(normalize(normalize(cross(u, v)) + towards)));
    mesh.face_vertex_counts = {4};
    mesh.face_vertex_indices = {0, 1, 2, 3};
    return mesh;
}

SceneDescription shading_normals() {
    SceneBuilder b;
    const int grey = b.diffuse(0.7);
    const int white = b.diffuse(0.85);
    b.shape(tilted_quad({-1.2, -0.9, 0.9}, {2.4, 0, 0}, {0, 0, -1.5}, {0.5, 0, -0.3}), white);
    b.shape(tilted_quad({-1.2, -0.6, -1}, {2.4, 0, 0}, {0, 1.7, 0.2}, {-0.4, -0.4, 0}), white);
    Matrix4 half = translation({0.2, -0.1, 0});
    half.m[0] = half.m[5] = half.m[10] = 0.5;
    b.shape(low_polygon_sphere(6, 4, true), grey, half);
    b.rect_light({0.2, 1.2, 0.2}, {-0.2, -1, -0.2}, 0.9, 0.9, 4);
    b.camera({0.1, 0.2, 3.8}, {0, 0, 0}, 36);
    return b.scene();
}

SceneDescription thin_lens() {
    SceneBuilder b = lit_gallery(DiffuseMaterial{{{0.8, 0.6, 0.4}}});
    b.lens(0.8, 3.2);
    return b.scene();
}

void add_sky(SceneBuilder& b) {
    LightDesc dome;
    dome.kind = LightKind::Dome;
    dome.intensity = 0.5;
    dome.color = {0.6, 0.8, 1};
    b.light(dome);
    LightDesc sun;
    sun.kind = LightKind::Distant;
    sun.angle = 40;
    sun.intensity = 3;
    sun.normalize = true;
    sun.world_from_light = look_at({1, 2, 2}, {0, 0, 0});
    b.light(sun);
}

SceneDescription open_sky() {
    SceneBuilder b = gallery(frosted_glass());
    add_sky(b);
    return b.scene();
}

/// Nothing but glass, all over the picture: errors of its densities are not diluted.
SceneDescription glass_alone() {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, b.material(frosted_glass()));
    LightDesc dome;
    dome.kind = LightKind::Dome;
    b.light(dome);
    b.camera({0, 0, 4}, {0, 0, 0}, 19);
    return b.scene();
}

SceneDescription sky_through_lens() {
    SceneBuilder b = gallery(DiffuseMaterial{});
    add_sky(b);
    b.lens(0.8, 3.2);
    return b.scene();
}

SceneDescription all_lights() {
    SceneBuilder b = gallery(DiffuseMaterial{{{0.8, 0.6, 0.4}}});
    b.rect_light({-0.7, 1.2, 0.2}, {0.2, -1, 0}, 0.5, 0.6, 1);
    LightDesc disk;
    disk.kind = LightKind::Disk;
    disk.radius = 0.35;
    disk.intensity = 3;
    disk.world_from_light = look_at({1.5, 0, 0.3}, {0, 0, 0});
    b.light(disk);
    LightDesc ball;
    ball.kind = LightKind::Sphere;
    ball.radius = 0.2;
    ball.intensity = 4;
    ball.world_from_light = translation({0.9, -0.4, 0.3});
    b.light(ball);
    LightDesc egg = ball;
    egg.world_from_light = translation({-0.9, -0.3, 0.2});
    egg.world_from_light.m[5] = 1.5;
    b.light(egg);
    Matrix4 small = translation({0.3, 0.8, 0});
    small.m[0] = small.m[5] = small.m[10] = 0.2;
    b.shape(low_polygon_sphere(6, 4, false), b.material(DiffuseMaterial{}, {2, 1, 0.5}), small);
    return b.scene();
}

struct Case {
    const char* name;
    SceneDescription (*scene)();
    bool has_lens = false;
    int longest = 4;  ///< where single strategies still make more than noise
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Alone : public testing::TestWithParam<Case> {};

constexpr int kSize = 12;
constexpr int kReplicas = 20;

/// Of the picture's mean, between two strategies: a bias of six times as much is never missed. Long paths are noisier.
double resolution(int s, int t) {
    const int k = s + t - 1;
    if (t == 0) return 0.08;
    if (s == 1 && t == 1) return 0.04;  // few points of a sky are in the picture
    return k <= 2 ? 0.015 : (k == 3 && s < 2 ? 0.03 : 0.06);
}

/// Cells large enough for every strategy to contribute to each many times: t-tests are no good at rare events. Lenses
/// are hit and skies seen by few light paths.
int cell_size(int s, int t) { return t == 0 || s + t == 2 ? kSize : kSize / 2; }

Replicas render_alone(const SceneDescription& scene, int s, int t) {
    const int effort = s == 0 ? 6 : (t == 0 ? 4 : 1);
    RenderSettings settings = small_settings(IntegratorKind::Bdpt, kSize, 96 * effort);
    settings.single_strategy = Strategy{s, t};
    settings.max_depth = s + t - 2;
    // What else could be traced would be thrown away.
    settings.strategies = {s == 0, s == 1 && t >= 2, s >= 2 && t >= 2, t == 1, t == 0};
    return render_replicas(scene, settings, kReplicas, static_cast<std::uint64_t>(100 + 10 * s + t));
}

TEST_P(Alone, SeesWhatTheOthersSee) {
    const SceneDescription scene = GetParam().scene();
    for (int k = 1; k <= GetParam().longest; ++k) {
        const Strategy reference{k == 1 ? 0 : 1, k == 1 ? 2 : k};
        const Replicas expected = render_alone(scene, reference.s, reference.t);
        for (int s = 0; s <= k + 1; ++s) {
            const int t = k + 1 - s;
            if (s == reference.s || (t == 0 && !GetParam().has_lens)) continue;
            SCOPED_TRACE("(s, t) = (" + std::to_string(s) + ", " + std::to_string(t) + ")");
            const int cell = cell_size(s, t);
            const Replicas alone = render_alone(scene, s, t);
            EXPECT_TRUE(same_picture(expected.blocks(cell), alone.blocks(cell), resolution(s, t)));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Alone,
                         testing::Values(Case{"diffuse", diffuse}, Case{"metal", metal}, Case{"plastic", plastic},
                                         Case{"rough_glass", rough_glass, false, 3},
                                         Case{"shading_normals", shading_normals}, Case{"thin_lens", thin_lens, true},
                                         Case{"open_sky", open_sky, false, 3},
                                         Case{"glass_alone", glass_alone, false, 3},
                                         Case{"sky_through_lens", sky_through_lens, true},
                                         Case{"all_lights", all_lights}),
                         [](const auto& test) { return std::string(test.param.name); });

// ---------------------------------------------------------------------------------------- sets of strategies

struct Subset {
    const char* name;
    StrategySet strategies;
    bool misses_mirrors = false;  ///< what a smooth surface shows, and images of lights in the lens
};

constexpr Subset kSubsets[]{
    {"emission", {true, false, false, false, false}},
    {"emission, direct", {true, true, false, false, false}},
    {"emission, direct, connection", {true, true, true, false, false}},
    {"emission, connection, light image", {true, false, true, true, false}},
    {"emission, direct, light image", {true, true, false, true, false}},
    {"emission, lens", {true, false, false, false, true}},
    {"direct, connection, light image", {false, true, true, true, false}, true},
    {"light image", {false, false, false, true, false}, true},
    {"light image, lens", {false, false, false, true, true}, true},
};

struct SubsetCase {
    const char* name;
    SceneDescription (*scene)();
    bool mirrors;
    MisHeuristic heuristic;
};

void PrintTo(const SubsetCase& c, std::ostream* out) { *out << c.name; }

class Subsets : public testing::TestWithParam<SubsetCase> {};

RenderSettings shallow_settings(IntegratorKind integrator, int samples_per_pixel) {
    RenderSettings settings = small_settings(integrator, kSize, samples_per_pixel);
    settings.max_depth = 5;
    return settings;
}

TEST_P(Subsets, AgreeWithAllStrategies) {
    const SceneDescription scene = GetParam().scene();
    RenderSettings settings = shallow_settings(IntegratorKind::Bdpt, 64);
    settings.heuristic = GetParam().heuristic;
    const Replicas all = render_replicas(scene, settings, kReplicas, 1);
    std::uint64_t stream = 2;
    for (const Subset& subset : kSubsets) {
        if (subset.misses_mirrors && GetParam().mirrors) continue;
        SCOPED_TRACE(subset.name);
        settings.strategies = subset.strategies;
        EXPECT_TRUE(same_picture(all, render_replicas(scene, settings, kReplicas, stream++), 0.02));
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Subsets,
                         testing::Values(SubsetCase{"glossy_balance", glossy_box, false, MisHeuristic::Balance},
                                         SubsetCase{"rough_glass_power", rough_glass_box, false, MisHeuristic::Power},
                                         SubsetCase{"lens_balance", lens_box, true, MisHeuristic::Balance},
                                         SubsetCase{"lens_power", lens_box, true, MisHeuristic::Power},
                                         SubsetCase{"sky_power", sky, true, MisHeuristic::Power}),
                         [](const auto& test) { return std::string(test.param.name); });

// ------------------------------------------------------------------- light paths, crops and filters change nothing

TEST(LightPaths, AnyNumberGivesTheSamePicture) {
    const SceneDescription scene = lens_box();
    RenderSettings settings = shallow_settings(IntegratorKind::Bdpt, 64);
    settings.light_paths_per_pixel = 1;
    const Replicas one = render_replicas(scene, settings, kReplicas, 1);
    std::uint64_t stream = 2;
    for (MisHeuristic heuristic : {MisHeuristic::Balance, MisHeuristic::Power}) {
        for (double paths : {0.0, 0.25, 4.0}) {
            SCOPED_TRACE(paths);
            settings.heuristic = heuristic;
            settings.light_paths_per_pixel = paths;
            EXPECT_TRUE(same_picture(one, render_replicas(scene, settings, kReplicas, stream++), 0.01));
        }
    }
}

/// Even when there are fewer paths than parts of the image that are rendered at a time.
TEST(LightPaths, TwoForTheWholeImageAreEnough) {
    const SceneDescription scene = indirect_box();
    RenderSettings settings = small_settings(IntegratorKind::Bdpt, 18, 160);
    settings.max_depth = 3;
    const Replicas many = render_replicas(scene, settings, 16, 1);
    settings.light_paths_per_pixel = 2.0 / (18 * 18);
    EXPECT_TRUE(same_picture(many, render_replicas(scene, settings, 16, 2), 0.03));
}

constexpr PixelFilter kGaussian{FilterKind::Gaussian, 1.5};

TEST(Crop, IsThatPartOfTheWhole) {
    const SceneDescription scene = lens_box();
    const PixelWindow window{3, 5, 10, 11};
    for (IntegratorKind integrator : {IntegratorKind::Bdpt, IntegratorKind::Light}) {
        SCOPED_TRACE(static_cast<int>(integrator));
        RenderSettings settings = shallow_settings(integrator, 64);
        settings.filter = kGaussian;
        const Replicas whole = render_replicas(scene, settings, kReplicas, 1).cut(window);
        settings.crop = window;
        EXPECT_TRUE(same_picture(whole, render_replicas(scene, settings, kReplicas, 2), 0.02));
    }
}

/// Most of what such a crop gathers lands outside of it, and its light paths, less than one by the pixel, still spread
/// over the whole picture.
TEST(Crop, MayBeNarrowerThanTheFilter) {
    const SceneDescription scene = diffuse_box();
    RenderSettings settings = small_settings(IntegratorKind::Light, kSize, 80);
    settings.max_depth = 3;
    for (const PixelFilter& filter : {PixelFilter{FilterKind::Gaussian, 4}, PixelFilter{FilterKind::Triangle, 3},
                                      PixelFilter{FilterKind::Box, 2}}) {
        SCOPED_TRACE(static_cast<int>(filter.kind));
        settings.filter = filter;
        settings.crop.reset();
        settings.light_paths_per_pixel = 1;
        const Replicas whole = render_replicas(scene, settings, kReplicas, 1);
        for (const PixelWindow& window : {PixelWindow{0, 0, 1, 1}, PixelWindow{9, 4, 12, 6}}) {
            settings.crop = window;
            RenderSettings crop = settings;
            crop.samples_per_pixel = 40 * settings.samples_per_pixel;
            crop.light_paths_per_pixel = 0.4;
            EXPECT_TRUE(same_picture(whole.cut(window), render_replicas(scene, crop, kReplicas, 2), 0.06));
        }
    }
}

TEST(PixelFilter, IsTheSameForSamplesAndSplats) {
    const SceneDescription scene = many_lights();
    for (const PixelFilter& filter :
         {kGaussian, PixelFilter{FilterKind::Triangle, 1}, PixelFilter{FilterKind::Box, 1}}) {
        SCOPED_TRACE(static_cast<int>(filter.kind));
        RenderSettings settings = shallow_settings(IntegratorKind::Path, 64);
        settings.filter = filter;
        const Replicas path = render_replicas(scene, settings, kReplicas, 1);
        settings.integrator = IntegratorKind::Bdpt;
        EXPECT_TRUE(same_picture(path, render_replicas(scene, settings, kReplicas, 2), 0.01));
        settings.integrator = IntegratorKind::Light;
        EXPECT_TRUE(same_picture(path, render_replicas(scene, settings, kReplicas, 3), 0.01));
    }
}

}  // namespace
}  // namespace etendue::test
