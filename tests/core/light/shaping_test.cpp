// ShapingAPI: what it means, and how beams are sampled.

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "core/light/light_cases.h"
#include "light/area_vectors.h"
#include "light/beam.h"
#include "light/emission_aim.h"
#include "light/mesh_light.h"
#include "light/usd_lux.h"
#include "math/constants.h"
#include "math/rng.h"
#include "math/sampling.h"
#include "support/chi2.h"
#include "support/estimate.h"
#include "support/invalid_operations.h"
#include "support/scene_builder.h"

namespace etendue {
namespace {

using test::LightCase;

constexpr double kDegree = kPi / 180;

TEST(Shaping, ConeCutsAndSoftens) {
    const ShapingDesc hard{0, {}, 30, 0};
    EXPECT_EQ(lux_shaping(hard, 0).g, 1);
    EXPECT_EQ(lux_shaping(hard, 29.99 * kDegree).g, 1);
    EXPECT_EQ(lux_shaping(hard, 30.01 * kDegree).g, 0);
    const ShapingDesc soft{0, {}, 40, 0.5};  // falls from 20 to 40 degrees
    EXPECT_EQ(lux_shaping(soft, 19.99 * kDegree).g, 1);
    EXPECT_NEAR(lux_shaping(soft, 30 * kDegree).g, 0.5, 1e-12);
    EXPECT_NEAR(lux_shaping(soft, 25 * kDegree).g, 1 - (3 / 16.0 - 2 / 64.0), 1e-12);
    EXPECT_EQ(lux_shaping(soft, 40.01 * kDegree).g, 0);
    const ShapingDesc softest{0, {}, 40, 7};  // as 1
    EXPECT_NEAR(lux_shaping(softest, 20 * kDegree).g, 0.5, 1e-12);
    // The default, applied, cuts the back off.
    EXPECT_EQ(lux_shaping({}, 89.9 * kDegree).g, 1);
    EXPECT_EQ(lux_shaping({}, 90.1 * kDegree).g, 0);
}

TEST(Shaping, FocusTintsWhatItTakesAway) {
    const ShapingDesc focus{2, {0, 0.5, -4}, 180, 0};
    for (const double theta : {0.0, 60.0, 120.0, 180.0}) {  // by the absolute value
        const double f = theta == 60 || theta == 120 ? 0.25 : 1;
        EXPECT_NEAR(lux_shaping(focus, theta * kDegree).r, f, 1e-12);
        EXPECT_NEAR(lux_shaping(focus, theta * kDegree).g, f + (1 - f) * 0.5, 1e-12);
    }
    EXPECT_NEAR(lux_shaping(focus, 60 * kDegree).b, 0.25, 1e-12);  // no less than untinted
    const ShapingDesc negative{-3, {}, 180, 0};
    EXPECT_EQ(lux_shaping(negative, 1).g, 1);
}

TEST(Shaping, AxisIsMinusZOfTheLight) {
    LightDesc desc = test::light_desc(LightKind::Sphere, test::rotated(2));
    desc.shaping = ShapingDesc{0, {}, 10, 0};
    const auto light = make_light(desc, test::kBounds);
    const Vec3 axis = normalize(Transform(desc.world_from_light).vector({0, 0, -1}));
    EXPECT_TRUE(light->sample_direct(axis * 9, {0.5, 0.5}));
    EXPECT_FALSE(light->sample_direct(-axis * 9, {0.5, 0.5}));
    desc.shaping.reset();
    EXPECT_TRUE(make_light(desc, test::kBounds)->sample_direct(-axis * 9, {0.5, 0.5}));
}

LightDesc plain(LightKind kind) {
    LightDesc light;
    light.kind = kind;
    return light;
}

double shaped_power(LightDesc desc, const ShapingDesc& shaping) {
    desc.shaping = shaping;
    return make_light(desc, test::kBounds)->power().r;
}

TEST(Shaping, PowerInClosedForm) {
    LightDesc point = plain(LightKind::Sphere);
    point.treat_as_point = true;
    const double intensity = kPi / 4;  // pi r^2
    const double rect = 1;
    const double sphere = kPi / 4;  // a quarter of its area
    for (const double angle : {0.1, 5.0, 40.0, 90.0, 150.0, 180.0}) {
        const ShapingDesc cone{0, {}, angle, 0};
        const double solid_angle = 4 * kPi * std::pow(std::sin(angle * kDegree / 2), 2);
        const double flat = angle < 90 ? kPi * std::pow(std::sin(angle * kDegree), 2) : kPi;
        EXPECT_NEAR(shaped_power(point, cone) / (intensity * solid_angle), 1, 1e-9) << angle;
        EXPECT_NEAR(shaped_power(plain(LightKind::Sphere), cone) / (sphere * solid_angle), 1, 1e-9) << angle;
        EXPECT_NEAR(shaped_power(plain(LightKind::Rect), cone) / (rect * flat), 1, 1e-9) << angle;
    }
    for (const double focus : {0.5, 1.0, 20.0, 1e6}) {  // the integral of cos^(m + 1) over a hemisphere
        const ShapingDesc shaping{focus, {}, 180, 0};
        EXPECT_NEAR(shaped_power(plain(LightKind::Rect), shaping) / (2 * kPi / (focus + 2)), 1, 1e-5) << focus;
        EXPECT_NEAR(shaped_power(point, shaping) / (intensity * 4 * kPi / (focus + 1)), 1, 1e-4) << focus;
    }
}

/// A cone of no width has no ring to choose from, on a light whose normal a shear has turned off its axis either.
TEST(Shaping, ConeOfNoWidthIsDark) {
    LightDesc disk = plain(LightKind::Disk);
    disk.world_from_light.m[8] = 0.5;
    double power = 1;
    EXPECT_FALSE(test::raises_invalid([&] { power = shaped_power(disk, {0, {}, 0, 0}); }));
    EXPECT_EQ(power, 0);
}

/// The normal and the axis of a turned light differ by a rounding, which must not decide the beam's frame.
TEST(Shaping, BeamsAreUnitWhateverTheTurn) {
    Rng rng(72, 0, 0);
    for (int turn = 0; turn < 200; ++turn) {
        const Vec3 z = sample_uniform_sphere(rng.next_2d());
        const Frame frame = Frame::from_normal(z);
        LightDesc desc = plain(LightKind::Disk);
        desc.world_from_light =
            test::matrix({frame.s.x, frame.t.x, z.x, frame.s.y, frame.t.y, z.y, frame.s.z, frame.t.z, z.z});
        desc.shaping = ShapingDesc{0, {}, 20, 0.3};
        const auto light = make_light(desc, test::kBounds);
        for (int i = 0; i < 20; ++i) {
            const EmissionSample sample = light->sample_emission({0.3, 0.4}, rng.next_2d());
            ASSERT_NEAR(length(sample.direction), 1, 1e-12);
            ASSERT_GT(dot(sample.direction, -z), std::cos(20.001 * kDegree));
        }
    }
}

TEST(Shaping, ShutConesAreDark) {
    for (const LightKind kind : {LightKind::Rect, LightKind::Sphere, LightKind::Cylinder}) {
        EXPECT_EQ(shaped_power(plain(kind), {0, {}, 0, 0}), 0);
        EXPECT_EQ(shaped_power(plain(kind), {0, {}, -10, 0}), 0);
    }
}

/// How many of a beam's particles carry nothing, and how much the others differ.
TEST(Shaping, NarrowBeamsWasteFewParticles) {
    for (const auto& [kind, most_lost] : {std::pair{LightKind::Rect, 0.0}, std::pair{LightKind::Disk, 0.0},
                                          std::pair{LightKind::Sphere, 0.5}, std::pair{LightKind::Cylinder, 0.5}}) {
        for (const bool point : {false, true}) {
            LightDesc desc = plain(kind);
            desc.shaping = ShapingDesc{0, {}, 5, 0};
            desc.treat_as_point = desc.treat_as_line = point;
            const auto light = make_light(desc, test::kBounds);
            Rng rng(71, 0, 0);
            test::Estimate weight;
            const int count = test::samples(20'000);
            int lost = 0;
            for (int i = 0; i < count; ++i) {
                const Vec2 u_point = rng.next_2d();
                const double w = light->sample_emission(u_point, rng.next_2d()).weight.g;
                weight.add(w);
                if (w == 0) ++lost;
            }
            EXPECT_LE(lost, count * (most_lost + 0.02));
            const double relative_variance = std::pow(weight.standard_error() / weight.mean(), 2) * count;
            EXPECT_LT(relative_variance, most_lost > 0 && !point ? 2.0 : 0.01);  // by the cosine: 130 or more
        }
    }
}

/// Of many facets: by their directions alone, hence about what the sphere shows.
TEST(Shaping, PowerOfFineMeshes) {
    const TriangleMesh ball = make_triangle_mesh(test::low_polygon_sphere(96, 48, false), {}, "ball");
    std::vector<LightTriangle> triangles;
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        triangles.push_back({{ball.point(t, 0), ball.point(t, 1), ball.point(t, 2)}, {}});
    }
    const double quarter = MeshLight::world_area(triangles) / 4;
    for (const double angle : {5.0, 60.0, 180.0}) {
        LightDesc desc = test::shaped(plain(LightKind::Mesh), angle, 0, 0);
        const double solid_angle = 4 * kPi * std::pow(std::sin(angle * kDegree / 2), 2);
        const double power = make_mesh_light(desc, triangles, nullptr)->power().r;
        EXPECT_NEAR(power / (quarter * solid_angle), 1, 0.02) << angle;
    }
}

TEST(AreaVectors, KeepDirectionsNotFacets) {
    AreaVectors facets;
    for (int i = 0; i < 1000; ++i) {
        facets.add({0, 0, 1});
        facets.add({0, -2, 0});
        facets.add({});
    }
    EXPECT_DOUBLE_EQ(facets.seen_along({0, 0, 1}), 1000);
    EXPECT_DOUBLE_EQ(facets.seen_along({0, -0.6, 0.8}), 2000);
    EXPECT_EQ(facets.seen_along({0, 0.6, -0.8}), 0);
    EXPECT_EQ(facets.seen_along({1, 0, 0}), 0);
}

/// Directions that barely leave the front of a flat light, at any lean, have a chance.
TEST(Shaping, LeaningFlatLightsLoseNoDirection) {
    for (int lean = 0; lean < 200; ++lean) {
        const double theta = (90 + 0.06 * lean) * kDegree;  // of the normal from the axis, -z
        const Vec3 n{std::sin(theta), 0, -std::cos(theta)};
        const Vec3 along = cross({0, 1, 0}, n);
        LightDesc desc = test::shaped(plain(LightKind::Mesh), 12, 0, 0);
        const LightTriangle flat{{Vec3{}, along, Vec3{0, 1, 0}}, {}};
        ASSERT_GT(dot(cross(flat.p[1], flat.p[2]), n), 0);
        const auto light = make_mesh_light(desc, {flat}, nullptr);
        const LightPoint y = light->sample_emission({0.3, 0.4}, {0.5, 0.5}).y;
        const Vec3 w = normalize(n * 1e-4 + Vec3{0, 0, -1} + n * n.z);
        ASSERT_FALSE(is_black(light->radiance(y, w))) << theta;
        EXPECT_GT(light->pdf_emission(y, w).pdf_dir, 0) << theta;
    }
}

/// The normal of a lamp that looks along its beam differs from the axis by roundings, other ones at every scale: they
/// must not turn the beam's samples round.
TEST(Shaping, AlignedBeamsAreSampledAlikeAtAnyScale) {
    const auto directions = [](double scale) {
        Matrix4 leaning = test::look_at({0.6, 0.8, 0}, {0.3, -1, 0});
        for (std::size_t i = 0; i < 12; ++i) leaning.m[i] *= scale;
        const LightDesc desc = test::shaped(test::light_desc(LightKind::Disk, leaning), 30, 0.3, 0);
        const auto light = make_light(desc, test::kBounds);
        std::vector<Vec3> all;
        for (int i = 0; i < 32; ++i) all.push_back(light->sample_emission({0.3, 0.4}, {0.5, (i + 0.5) / 32}).direction);
        return all;
    };
    const std::vector<Vec3> expected = directions(1);
    for (const double scale : {1e-6, 3e-4, 0.7, 1e3, 1e6}) {
        const std::vector<Vec3> actual = directions(scale);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_LT(length(actual[i] - expected[i]), 1e-14) << scale;
        }
    }
}

/// Of the last directions of a hard cone, the density may already know nothing.
TEST(Shaping, EdgesOfHardConesAreFinite) {
    const EmissionAim aim({{{0, 0, -4}, 0.5}});
    for (const LightCase& c : test::shaped_lights()) {
        for (int i = 0; i < 500; ++i) {
            const Vec2 u_point{0.7, (i + 0.5) / 500};
            const Vec2 u_dir{kOneMinusEpsilon, (i + 0.5) / 500};
            const EmissionSample sample = c.light->sample_emission(u_point, u_dir);
            const EmissionSample aimed = aim.sample(*c.light, u_point, u_dir);
            ASSERT_TRUE(std::isfinite(max_component(sample.weight))) << c.name;
            ASSERT_TRUE(std::isfinite(max_component(aimed.weight))) << c.name;
        }
    }
}

class BeamChi2 : public testing::TestWithParam<LightCase> {};

TEST_P(BeamChi2, EmissionDirections) {
    const Light& light = *GetParam().light;
    // A point that faces the beam, off every axis of symmetry.
    const Vec2 u_point{0.83, 0.61};
    const LightPoint y = light.sample_emission(u_point, {0.5, 0.5}).y;
    const auto sampler = [&](Rng& rng) -> std::optional<Vec3> {
        const EmissionSample sample = light.sample_emission(u_point, rng.next_2d());
        if (is_black(sample.weight)) return {};
        return sample.direction;
    };
    const auto density = [&](const Vec3& w) {
        if (!light.delta() && is_black(light.radiance(y, w))) return 0.0;
        return light.pdf_emission(y, w).pdf_dir;
    };
    const auto bounds = light.bounds();
    ASSERT_TRUE(bounds);
    test::SphereGrid grid;
    if (bounds->cos_emission > 0) {  // a narrow beam: rings that end where it does
        grid.frame = Frame::from_normal(bounds->axis);
        grid.one_minus_cos_edges = test::even_edges(0, 1 - bounds->cos_emission, 12);
        grid.one_minus_cos_edges.push_back(2);
    } else if (!light.delta()) {
        grid.frame = Frame::from_normal(y.n);
    }
    EXPECT_TRUE(test::passes(test::chi2_sphere(sampler, density, grid, {100'000, test::sidak(1e-4, 30), 8})));
}

INSTANTIATE_TEST_SUITE_P(Lights, BeamChi2, testing::ValuesIn(test::shaped_lights()), test::case_name);

}  // namespace
}  // namespace etendue
