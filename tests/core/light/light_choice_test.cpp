// Choosing among many lights for a receiver: often those that matter, exactly as often as said, never not at all.

#include <cmath>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/light/light_cases.h"
#include "light/light_sampler.h"
#include "light/light_tree.h"
#include "light/point_light.h"
#include "light/rect_light.h"
#include "math/frame.h"
#include "math/rng.h"
#include "math/sampling.h"
#include "support/chi2.h"
#include "support/estimate.h"

namespace etendue {
namespace {

using test::passes;
using Lights = std::vector<std::unique_ptr<Light>>;

constexpr SceneBounds kUnitBounds{{0, 0, 0}, 1};

/// A number of [low, high).
double between(Rng& rng, double low, double high) { return low + (high - low) * rng.next_1d(); }

Vec3 in_cube(Rng& rng, double size) {
    const Vec2 xy = rng.next_2d();
    return Vec3{xy.x - 0.5, xy.y - 0.5, rng.next_1d() - 0.5} * size;
}

/// A square lamp.
std::unique_ptr<Light> lamp(const Vec3& center, const Vec3& normal, double size, double radiance) {
    const Frame f = Frame::from_normal(-normal);
    Matrix4 m;
    m.m = {f.s.x, f.t.x, f.n.x, center.x, f.s.y, f.t.y, f.n.y, center.y, f.s.z, f.t.z, f.n.z, center.z, 0, 0, 0, 1};
    return std::make_unique<RectLight>(Transform(m), size, size, Rgb(radiance));
}

/// Of every kind, some at infinity, some dark, of powers wide apart.
Lights mixed_lights() {
    Lights lights;
    Rng rng(71, 0, 0);
    constexpr LightKind kKinds[]{LightKind::Rect, LightKind::Disk, LightKind::Sphere};
    for (int i = 0; i < 60; ++i) {
        LightDesc desc;
        desc.kind = kKinds[i % 3];
        desc.world_from_light = test::rotated(between(rng, 0.05, 0.3), in_cube(rng, 2));
        if (i % 2 == 0) desc.world_from_light = test::scaling(0.1, 0.3, 0.2, in_cube(rng, 2));
        desc.treat_as_point = i % 9 == 2;
        desc.intensity = i % 10 == 3 ? 0 : std::exp(between(rng, -3, 3));
        lights.push_back(make_light(desc, kUnitBounds));
    }
    lights.push_back(make_mesh_light(LightDesc{}, test::tetrahedron(), nullptr));
    for (const LightKind kind : {LightKind::Distant, LightKind::Dome}) {
        LightDesc desc;
        desc.kind = kind;
        lights.push_back(make_light(desc, kUnitBounds));
    }
    return lights;
}

/// Irradiance from the middle of the light; nothing lies in between.
double irradiance(const Light& light, const Vec3& receiver, const Vec3& normal) {
    const auto sample = light.sample_direct(receiver, {0.5, 0.5});
    return sample ? sample->weight.g * std::max(0.0, dot(sample->wi, normal)) : 0;
}

double blind_pmf(const Lights& lights, std::size_t light) {
    double sum = 0;
    for (const auto& other : lights) sum += other->power().g;
    return 0.5 * (lights[light]->power().g / sum + 1 / static_cast<double>(lights.size()));
}

/// Relative variances of the irradiance by one choice, summed over receivers, no sampling involved: of choosing half
/// by power and half evenly, and of the sampler.
struct Variances {
    double blind = 0;
    double aware = 0;
};
Variances variances(const Lights& lights, const std::vector<Vec3>& receivers) {
    const LightSampler sampler(lights, kUnitBounds);
    std::vector<double> blind;
    for (std::size_t i = 0; i < std::min<std::size_t>(lights.size(), 100); ++i) blind.push_back(blind_pmf(lights, i));
    // Beyond a hundred, lights repeat their powers.
    const auto blind_of = [&](std::size_t i) { return blind[i % blind.size()]; };
    Variances sum;
    for (const Vec3& receiver : receivers) {
        double mean = 0;
        Variances second;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const double e = irradiance(*lights[i], receiver, {0, 1, 0});
            if (e == 0) continue;
            mean += e;
            second.blind += e * e / blind_of(i);
            second.aware += e * e / sampler.pmf_direct(receiver, static_cast<int>(i));
        }
        sum.blind += second.blind / (mean * mean) - 1;
        sum.aware += second.aware / (mean * mean) - 1;
    }
    return sum;
}

TEST(LightChoice, AsOftenAsSaid) {
    const Lights lights = mixed_lights();
    const LightSampler sampler(lights, kUnitBounds);
    const int count = static_cast<int>(lights.size());
    constexpr int kReceivers = 6;
    Rng places(72, 0, 0);
    for (int k = 0; k < kReceivers; ++k) {
        const Vec3 receiver = in_cube(places, 3);
        // Lights side by side, each one unit wide; where none is chosen is a place of its own.
        const auto choose = [&](Rng& rng) -> std::optional<Vec2> {
            const auto choice = sampler.sample_direct(receiver, rng.next_1d());
            if (!choice) return {};
            EXPECT_EQ(choice->pmf, sampler.pmf_direct(receiver, choice->light));
            return Vec2{choice->light + 0.5, 0.5};
        };
        const auto pmf = [&](const Vec2& at) { return sampler.pmf_direct(receiver, static_cast<int>(at.x)); };
        const test::Grid grid{test::even_edges(0, count, count), {0, 1}};
        EXPECT_TRUE(passes(test::chi2_plane(choose, pmf, grid, {100'000, test::sidak(1e-4, kReceivers), 8})));
    }
}

/// Where a light of any kind can be sampled, the tree can choose it; and the probabilities leave to 1 no more than what
/// is lost on lights that turn their backs.
TEST(LightChoice, NoLightIsLost) {
    const Lights lights = mixed_lights();
    std::vector<LightTree::Item> items;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const auto bounds = lights[i]->bounds();
        if (bounds && lights[i]->power().g > 0) items.push_back({static_cast<int>(i), *bounds, lights[i]->power().g});
    }
    const LightTree tree(items);
    Rng rng(73, 0, 0);
    int lit = 0;
    for (int k = 0; k < test::samples(1000); ++k) {
        const Vec3 receiver = in_cube(rng, k % 2 == 0 ? 2 : 8);
        double sum = 0;
        for (const LightTree::Item& item : items) {
            const double pmf = tree.pmf(receiver, item.light);
            sum += pmf;
            if (!lights[static_cast<std::size_t>(item.light)]->sample_direct(receiver, rng.next_2d())) continue;
            ++lit;
            ASSERT_GT(pmf, 0) << item.light;
        }
        ASSERT_LE(sum, 1 + 1e-12);
        ASSERT_GT(sum, 0.5);
    }
    EXPECT_GT(lit, 20 * test::samples(1000));
}

/// Narrower than a cosine can say; the receiver is as near to the light as it is wide.
TEST(LightChoice, TheNarrowestBeamsStayFinite) {
    const LightBounds beam{{-1, -1, 1}, {1, 1, 1}, {0, 0, -1}, 1, std::cos(5e-9)};
    const LightBounds lamp{{3, 0, 0}, {3, 0, 0}};
    const LightTree tree({{0, beam, 1}, {1, lamp, 1}});
    EXPECT_NEAR(tree.pmf({}, 0) + tree.pmf({}, 1), 1, 1e-12);
    EXPECT_GT(tree.pmf({}, 0), 0.99);
}

TEST(LightChoice, AllAroundEveryChoiceIsALight) {
    Lights lights;
    Rng rng(74, 0, 0);
    for (int i = 0; i < 500; ++i) lights.push_back(std::make_unique<PointLight>(in_cube(rng, 2), Rgb(1 + i % 3)));
    const LightSampler sampler(lights, kUnitBounds);
    for (int k = 0; k < 100; ++k) {
        // Also where a light is.
        const Vec3 receiver = k % 10 == 0 ? lights[static_cast<std::size_t>(k)]->bounds()->lower : in_cube(rng, 3);
        double sum = 0;
        for (int i = 0; i < 500; ++i) sum += sampler.pmf_direct(receiver, i);
        ASSERT_NEAR(sum, 1, 1e-12);
        ASSERT_TRUE(sampler.sample_direct(receiver, 1 - 0x1p-53));
    }
}

/// Shapes that split badly: all in one place, and each nearer to the last by a factor.
TEST(LightChoice, DegenerateCrowds) {
    for (const double factor : {1.0, 0.5}) {
        Lights lights;
        Vec3 p{1, 1, 1};
        for (int i = 0; i < 900; ++i, p *= factor) lights.push_back(std::make_unique<PointLight>(p, Rgb(1)));
        const LightSampler sampler(lights, kUnitBounds);
        for (const Vec3& receiver : {Vec3{2, 0, 1}, Vec3{}, Vec3{1, 1, 1}}) {
            double sum = 0;
            for (int i = 0; i < 900; ++i) sum += sampler.pmf_direct(receiver, i);
            EXPECT_NEAR(sum, 1, 1e-12) << factor;
        }
    }
}

/// A hall with 100 x 100 lamps.
TEST(LightChoice, TenThousandLights) {
    Lights lights;
    for (int row = 0; row < 100; ++row) {
        for (int column = 0; column < 100; ++column) {
            lights.push_back(lamp({row + 0.5, 3, column + 0.5}, {0, -1, 0}, 0.2, 1 + column % 5));
        }
    }
    Rng rng(75, 0, 0);
    std::vector<Vec3> receivers;
    for (int i = 0; i < 20; ++i)
        receivers.emplace_back(between(rng, 0, 100), between(rng, 0, 2.5), between(rng, 0, 100));
    const Variances v = variances(lights, receivers);
    std::cout << "10,000 lights: relative variance " << v.blind / 20 << " by power and evenly, " << v.aware / 20
              << " for the receiver: ratio " << v.blind / v.aware << '\n';
    EXPECT_LT(v.aware, v.blind / 100);
}

/// The floor of a box with lamps under its ceiling.
TEST(LightChoice, FewLightsAreNoWorse) {
    for (const int count : {2, 3, 4, 8, 16}) {
        Rng rng(76, 0, static_cast<std::uint64_t>(count));
        Lights lights;
        for (int i = 0; i < count; ++i) {
            lights.push_back(
                lamp({between(rng, -1, 1), 0.95, between(rng, -1, 1)}, {0, -1, 0}, 0.3, std::exp(between(rng, -1, 1))));
        }
        std::vector<Vec3> receivers;
        for (int i = 0; i < 300; ++i) receivers.emplace_back(between(rng, -1, 1), -1, between(rng, -1, 1));
        const Variances v = variances(lights, receivers);
        EXPECT_LT(v.aware, 0.75 * v.blind) << count;
    }
}

/// A lamp that is near but hidden must not starve the one that lights the place.
TEST(LightChoice, HiddenLampsDoNotStarveOthers) {
    Lights lights;
    lights.push_back(lamp({0, 0.01, 0}, {0, -1, 0}, 0.2, 1000));
    lights.push_back(lamp({5, 5, 0}, {0, -1, 0}, 0.2, 1));
    const LightSampler sampler(lights, kUnitBounds);
    EXPECT_GE(sampler.pmf_direct({}, 1), 0.5 * blind_pmf(lights, 1));
}

/// A sun and a lamp: each where it is the stronger.
TEST(LightChoice, BesideInfiniteLights) {
    Lights lights;
    lights.push_back(std::make_unique<PointLight>(Vec3{}, Rgb(1)));
    LightDesc sun;
    sun.kind = LightKind::Distant;
    sun.angle = 0;
    sun.intensity = 1;
    lights.push_back(make_light(sun, kUnitBounds));
    const LightSampler sampler(lights, kUnitBounds);
    EXPECT_GT(sampler.pmf_direct({0.01, 0, 0}, 0), 0.69);
    EXPECT_GT(sampler.pmf_direct({100, 0, 0}, 1), 0.54);
    for (const double x : {0.0, 0.01, 1.0, 100.0}) {
        EXPECT_NEAR(sampler.pmf_direct({x, 0, 0}, 0) + sampler.pmf_direct({x, 0, 0}, 1), 1, 1e-12);
    }
}

}  // namespace
}  // namespace etendue
