#include "light/light_sampler.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/light/light_cases.h"
#include "light/dark_light.h"
#include "light/point_light.h"
#include "math/rng.h"
#include "support/estimate.h"

namespace etendue {
namespace {

using Lights = std::vector<std::unique_ptr<Light>>;

LightSampler make_sampler(const Lights& lights) { return LightSampler(lights, test::kBounds); }

Lights points(const std::vector<Rgb>& intensities) {
    Lights lights;
    for (const Rgb& intensity : intensities) lights.push_back(std::make_unique<PointLight>(Vec3{}, intensity));
    return lights;
}

TEST(LightSampler, NoLights) {
    for (Lights& lights : std::vector<Lights>(1)) {
        EXPECT_FALSE(make_sampler(lights).sample_emission(0.5));
        EXPECT_FALSE(make_sampler(lights).sample_direct({}, 0.5));
        lights.push_back(std::make_unique<DarkLight>());
        const LightSampler dark = make_sampler(lights);
        EXPECT_FALSE(dark.sample_emission(0.5));
        EXPECT_FALSE(dark.sample_direct({}, 0.5));
        EXPECT_EQ(dark.pmf_emission(0), 0);
        EXPECT_EQ(dark.pmf_direct({}, 0), 0);
    }
}

TEST(LightSampler, OneLight) {
    const LightSampler sampler = make_sampler(points({Rgb(1e-30)}));
    for (const double u : {0.0, 0.5, 1 - 0x1p-53}) {
        EXPECT_EQ(sampler.sample_emission(u)->light, 0);
        EXPECT_EQ(sampler.sample_emission(u)->pmf, 1);
        EXPECT_EQ(sampler.sample_direct({}, u)->light, 0);
        EXPECT_EQ(sampler.sample_direct({}, u)->pmf, 1);
    }
}

/// Of lights in one place the receiver's place says nothing: all that is left is power, and a third, one over the
/// number of lights that emit, half evenly.
TEST(LightSampler, ByPowerAndSometimesEvenly) {
    const LightSampler sampler = make_sampler(points({Rgb(1), Rgb(), Rgb(0, 0, 9), Rgb(1e-9), Rgb()}));
    const Vec3 receiver{1, 2, 3};
    EXPECT_NEAR(sampler.pmf_emission(0), 0.25, 1e-9);
    EXPECT_NEAR(sampler.pmf_emission(2), 0.75, 1e-9);
    EXPECT_NEAR(sampler.pmf_direct(receiver, 0), (0.125 + 1 / 6.0) / 3 + 0.25 * 2 / 3, 1e-9);
    EXPECT_NEAR(sampler.pmf_direct(receiver, 3), 1 / 18.0, 1e-9);
    for (const int dark : {1, 4}) {
        EXPECT_EQ(sampler.pmf_emission(dark), 0);
        EXPECT_EQ(sampler.pmf_direct(receiver, dark), 0);
    }
}

TEST(LightSampler, ChoosesAsOftenAsItSays) {
    const LightSampler sampler = make_sampler(points({Rgb(1), Rgb(), Rgb(0, 0, 9), Rgb(2), Rgb()}));
    std::vector<test::Estimate> emission(5);
    std::vector<test::Estimate> direct(5);
    Rng rng(31, 0, 0);
    for (int i = 0; i < test::samples(200'000); ++i) {
        const LightChoice e = *sampler.sample_emission(rng.next_1d());
        const LightChoice d = *sampler.sample_direct({}, rng.next_1d());
        ASSERT_EQ(e.pmf, sampler.pmf_emission(e.light));
        ASSERT_EQ(d.pmf, sampler.pmf_direct({}, d.light));
        for (int light = 0; light < 5; ++light) {
            emission[static_cast<std::size_t>(light)].add(e.light == light);
            direct[static_cast<std::size_t>(light)].add(d.light == light);
        }
    }
    for (const int light : {0, 1, 2, 3, 4}) {
        const auto i = static_cast<std::size_t>(light);
        EXPECT_TRUE(test::agrees(emission[i], sampler.pmf_emission(light), 0.01));
        EXPECT_TRUE(test::agrees(direct[i], sampler.pmf_direct({}, light), 0.01));
    }
}

/// A texture may be dark at every point that the power estimate looks at; the light must still be chosen.
TEST(LightSampler, TexturedMeshIsNeverLost) {
    class Spot final : public EmissionTexture {
    public:
        [[nodiscard]] Rgb at(const Vec2& st) const override { return Rgb(st.x > 0.999999 ? 1e6 : 0.0); }
    };
    LightDesc desc;
    desc.kind = LightKind::Mesh;
    Lights lights = points({Rgb(1)});
    lights.push_back(make_mesh_light(desc, test::tetrahedron(), std::make_shared<Spot>()));
    const LightSampler sampler = make_sampler(lights);
    EXPECT_GT(sampler.pmf_emission(1), 1e-5);
    EXPECT_GT(sampler.pmf_direct({}, 1), 0.5 / 4);
}

TEST(LightSampler, TexturedMeshPowerIsItsMean) {
    LightDesc desc;
    desc.kind = LightKind::Mesh;
    const auto plain = make_mesh_light(desc, test::tetrahedron(), nullptr);
    const auto ramp = make_mesh_light(desc, test::tetrahedron(), std::make_shared<test::RampTexture>());
    EXPECT_NEAR(ramp->power().r / plain->power().r, 4 / 3.0, 0.01);  // mean of 1 + s over a triangle
}

}  // namespace
}  // namespace etendue
