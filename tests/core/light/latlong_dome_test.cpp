// Domes with a latlong image: which way it faces, and how it is sampled.

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include <etendue/error.h>

#include "core/light/light_cases.h"
#include "core/light/memory_image.h"
#include "math/constants.h"
#include "math/rng.h"
#include "support/chi2.h"
#include "support/estimate.h"

namespace etendue {
namespace {

using test::MemoryImage;

LightDesc dome_desc(const Matrix4& world_from_light = {}, Axis pole = Axis::Y) {
    LightDesc desc;
    desc.name = "/World/Sky";
    desc.kind = LightKind::Dome;
    desc.world_from_light = world_from_light;
    desc.pole_axis = pole;
    return desc;
}

std::unique_ptr<Light> make_dome(const MemoryImage& image, const LightDesc& desc = dome_desc()) {
    return make_light(desc, test::kBounds, std::make_shared<MemoryImage>(image));
}

LightPoint towards(const Vec3& w) {
    LightPoint y;
    y.p = w;
    y.n = -w;
    return y;
}

Rgb radiance(const Light& light, const Vec3& w) { return light.radiance(towards(w), -w); }

/// Light space, pole Y: longitude pi at the left edge falling to -pi at the right one, latitude pi/2 at the top;
/// longitude 0 is +Z, pi/2 is +X (OpenEXR, technical introduction).
Vec3 texel_direction(const MemoryImage& image, double x, double y) {
    const double longitude = kPi - 2 * kPi * (x + 0.5) / image.width();
    const double latitude = kPi / 2 - kPi * (y + 0.5) / image.height();
    return {std::sin(longitude) * std::cos(latitude), std::sin(latitude), std::cos(longitude) * std::cos(latitude)};
}

// ------------------------------------------------------------------------------------------------------ orientation

TEST(LatlongDome, EveryTexelLiesWhereOpenExrSaysItDoes) {
    const MemoryImage image = test::mottled_image(16, 8, true);
    const auto light = make_dome(image);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) {
            const Rgb found = radiance(*light, texel_direction(image, x, y));
            const Rgb expected = image.at({(x + 0.5) / 16, 1 - (y + 0.5) / 8});
            EXPECT_NEAR(found.r, expected.r, 1e-12);
            EXPECT_NEAR(found.b, expected.b, 1e-12);
        }
    }
}

/// A picture in words: the middle of the image is +Z, what is left of it +X, the top +Y.
TEST(LatlongDome, LandmarksOfThePoles) {
    MemoryImage image(36, 19, true);  // odd rows: one lies on the horizon
    const auto mark = [&](int x, int y, const Rgb& color) {
        for (const int dx : {-1, 0}) image.texel((x + dx + 36) % 36, y) = color;
    };
    mark(18, 9, {1, 0, 0});                                              // middle
    mark(9, 9, {0, 1, 0});                                               // a quarter to the left
    mark(0, 9, {0, 0, 1});                                               // the edge
    for (int x = 0; x < 36; ++x) image.texel(x, 0) = {0.25, 0.5, 0.75};  // top
    const auto y_up = make_dome(image);
    EXPECT_NEAR(radiance(*y_up, {0, 0, 1}).r, 1, 1e-9);
    EXPECT_NEAR(radiance(*y_up, {1, 0, 0}).g, 1, 1e-9);
    EXPECT_NEAR(radiance(*y_up, {0, 0, -1}).b, 1, 1e-9);
    EXPECT_NEAR(radiance(*y_up, {0, 1, 0}).b, 0.75, 1e-9);
    EXPECT_EQ(radiance(*y_up, {-1, 0, 0}), Rgb());

    const auto z_up = make_dome(image, dome_desc({}, Axis::Z));  // latitude and longitude 0 point to -Y
    EXPECT_NEAR(radiance(*z_up, {0, -1, 0}).r, 1, 1e-9);
    EXPECT_NEAR(radiance(*z_up, {1, 0, 0}).g, 1, 1e-9);
    EXPECT_NEAR(radiance(*z_up, {0, 1, 0}).b, 1, 1e-9);
    EXPECT_NEAR(radiance(*z_up, {0, 0, 1}).b, 0.75, 1e-9);
}

TEST(LatlongDome, TurnsWithItsTransform) {
    const MemoryImage image = test::mottled_image(16, 8, true);
    // The second scales differently along the axes: at infinity that means nothing.
    for (const Matrix4& m : {test::rotated(1), test::rotated(2.5, {3, -2, 1}), test::scaling(-1, 1, 1),
                             test::scaling(2, 3, 5), test::scaling(-2, 3, 5)}) {
        const Transform t(m);
        const auto light = make_dome(image, dome_desc(m));
        for (const auto& [x, y] : {std::pair{3, 2}, std::pair{9, 5}, std::pair{15, 4}}) {
            Vec3 local = texel_direction(image, x, y);
            const bool rigid = std::abs(length(t.vector({1, 0, 0})) - length(t.vector({0, 1, 0}))) < 1e-9;
            if (!rigid) local = {local.x / 2, local.y / 3, local.z / 5};
            const Rgb found = radiance(*light, normalize(t.vector(local)));
            EXPECT_NEAR(found.r, image.at({(x + 0.5) / 16, 1 - (y + 0.5) / 8}).r, 1e-9);
        }
    }
}

TEST(LatlongDome, MirroringMirrors) {
    MemoryImage image(16, 8, true);
    for (int y = 0; y < 8; ++y) image.texel(4, y) = image.texel(3, y) = Rgb(1);  // about +X
    const auto plain = make_dome(image);
    const auto mirrored = make_dome(image, dome_desc(test::scaling(-1, 1, 1)));
    EXPECT_NEAR(radiance(*plain, {1, 0, 0}).g, 1, 1e-9);
    EXPECT_EQ(radiance(*plain, {-1, 0, 0}), Rgb());
    EXPECT_EQ(radiance(*mirrored, {1, 0, 0}), Rgb());
    EXPECT_NEAR(radiance(*mirrored, {-1, 0, 0}).g, 1, 1e-9);
}

TEST(LatlongDome, TextureMultipliesTheLight) {
    const MemoryImage image = test::mottled_image(16, 8, true);
    LightDesc desc = dome_desc();
    desc.intensity = 3;
    desc.exposure = 1;
    desc.color = {1, 0.5, 0.25};
    desc.normalize = true;  // ignored
    const Vec3 w = texel_direction(image, 5, 2);
    EXPECT_NEAR(radiance(*make_dome(image, desc), w).g / radiance(*make_dome(image), w).g, 3, 1e-12);
}

// --------------------------------------------------------------------------------------------------------- sampling

struct Dome {
    std::unique_ptr<Light> light;
    test::SphereGrid grid;  ///< rings and sectors end where cells of the image do
};

Dome dome(const MemoryImage& image, const Matrix4& world_from_light = {}) {
    Dome dome{make_dome(image, dome_desc(world_from_light)), {}};
    const Transform t(world_from_light);
    const auto axis = [&t](const Vec3& v) { return normalize(t.vector(v)); };
    dome.grid.frame = {axis({0, 0, 1}), axis({1, 0, 0}), axis({0, 1, 0})};
    dome.grid.azimuths = image.width();
    dome.grid.one_minus_cos_edges.clear();
    for (int row = 0; row <= image.height(); ++row) {
        dome.grid.one_minus_cos_edges.push_back(1 - std::cos(row * kPi / image.height()));
    }
    return dome;
}

test::Chi2Settings settings() { return {100'000, test::sidak(1e-4, 6), 9}; }

TEST(LatlongDome, DirectionsFollowTheirDensity) {
    for (const Matrix4& m : {Matrix4{}, test::rotated(2)}) {
        const Dome d = dome(test::sunny_image(16, 8, true), m);
        const auto density = [&](const Vec3& w) { return d.light->pdf_direct({}, towards(w)); };
        const auto direct = [&](Rng& rng) -> std::optional<Vec3> {
            return d.light->sample_direct({}, rng.next_2d())->wi;
        };
        EXPECT_TRUE(test::passes(test::chi2_sphere(direct, density, d.grid, settings())));
        const auto emitted = [&](Rng& rng) -> std::optional<Vec3> {
            const Vec2 u_point = rng.next_2d();
            return -d.light->sample_emission(u_point, rng.next_2d()).direction;
        };
        const auto density_emitted = [&](const Vec3& w) { return d.light->pdf_emission(towards(w), -w).pdf_point; };
        EXPECT_TRUE(test::passes(test::chi2_sphere(emitted, density_emitted, d.grid, settings())));
    }
}

/// Images too large for a table of all their texels: cells of 2 x 2, the last ones narrower.
TEST(LatlongDome, LargeImagesKeepTheirDensity) {
    class Huge final : public EmissionImage {
    public:
        [[nodiscard]] Rgb at(const Vec2& st) const override { return Rgb(st.x + 2 * st.y > 2.5 ? 5.0 : 0.01); }
        [[nodiscard]] Rgb texel(int x, int y) const override {
            return at({(x + 0.5) / width(), 1 - (y + 0.5) / height()});
        }
        [[nodiscard]] int width() const override { return 2501; }
        [[nodiscard]] int height() const override { return 1251; }
    };
    const auto light = make_light(dome_desc(), test::kBounds, std::make_shared<Huge>());
    Rng rng(61, 0, 0);
    test::Estimate solid_angle;  // the mean of 1/pdf is that of the whole sphere
    for (int i = 0; i < test::samples(20'000); ++i) {
        const auto sample = light->sample_direct({}, rng.next_2d());
        ASSERT_NEAR(sample->pdf_point / light->pdf_direct({}, sample->y), 1, 1e-9);
        solid_angle.add(1 / sample->pdf_point);
    }
    EXPECT_TRUE(test::agrees(solid_angle, 4 * kPi, 0.2));
}

TEST(LatlongDome, WhatShinesCanBeSampled) {
    const auto light = make_dome(test::sunny_image(16, 8, true));
    Rng rng(62, 0, 0);
    int dark = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 w = sample_uniform_sphere(rng.next_2d());
        if (is_black(radiance(*light, w))) {
            ++dark;
        } else {
            ASSERT_GT(light->pdf_direct({}, towards(w)), 0);
        }
    }
    EXPECT_GT(dark, 0);
}

TEST(LatlongDome, WeightsHardlyVary) {
    const auto light = make_dome(test::sunny_image(64, 32, true));
    Rng rng(63, 0, 0);
    test::Estimate green;
    const int count = test::samples(50'000);
    for (int i = 0; i < count; ++i) green.add(light->sample_direct({}, rng.next_2d())->weight.g);
    const double relative_deviation = green.standard_error() * std::sqrt(count) / green.mean();
    EXPECT_LT(relative_deviation, 1.5);  // uniform directions: 16
}

TEST(LatlongDome, PowerIsTheIntegralOfTheImage) {
    const MemoryImage image = test::sunny_image(16, 8, true);
    const auto light = make_dome(image);
    constexpr int kCells = 128;  // along a texel; the filter has its kinks between cells
    double sum = 0;
    for (int row = 0; row < 8 * kCells; ++row) {
        const double theta = (row + 0.5) * kPi / (8 * kCells);
        const double ring = std::sin(theta) * (kPi / (8 * kCells)) * (2 * kPi / 16);
        for (int x = 0; x < 16; ++x) {
            const double t = 1 - (row + 0.5) / (8 * kCells);
            // Along a row the filter is linear from texel to texel.
            sum += ring * (image.at({(x + 0.5) / 16, t}).g + image.at({(x + 1.5) / 16, t}).g) / 2;
        }
    }
    EXPECT_NEAR(light->power().g / (sum * kPi * test::kBounds.radius * test::kBounds.radius), 1, 1e-5);
}

TEST(LatlongDome, WeightsAreRadianceOverDensity) {
    for (const bool pole_z : {false, true}) {
        const auto light =
            make_dome(test::mottled_image(32, 16, true), dome_desc(test::rotated(1), pole_z ? Axis::Z : Axis::Y));
        Rng rng(64, 0, 0);
        for (int i = 0; i < 2000; ++i) {
            const auto sample = light->sample_direct({}, rng.next_2d());
            ASSERT_NEAR(length(sample->wi), 1, 1e-12);
            ASSERT_NEAR(sample->pdf_point / light->pdf_direct({}, sample->y), 1, 1e-9);
            ASSERT_NEAR(sample->weight.b * sample->pdf_point / radiance(*light, sample->wi).b, 1, 1e-9);
        }
    }
}

// -------------------------------------------------------------------------------------------------------- odd images

TEST(LatlongDome, ASinglePixelIsAConstantDome) {
    MemoryImage image(1, 1, true);
    image.texel(0, 0) = Rgb(2);
    const auto light = make_dome(image);
    EXPECT_NEAR(light->pdf_direct({}, towards({0, 1, 0})), kInvPi / 4, 1e-12);
    EXPECT_NEAR(light->sample_direct({}, {0.3, 0.8})->weight.g, 8 * kPi, 1e-9);
}

TEST(LatlongDome, BlackImagesAreDark) {
    const auto light = make_dome(MemoryImage(4, 2, true));
    EXPECT_TRUE(is_black(light->power()));
    EXPECT_FALSE(light->sample_direct({}, {0.5, 0.5}));
}

TEST(LatlongDome, RefusesWhatHasNoMeaning) {
    MemoryImage image = test::mottled_image(4, 2, true);
    image.texel(2, 1).g = std::numeric_limits<double>::infinity();
    const auto message = [](const MemoryImage& texels, const LightDesc& desc) -> std::string {
        try {
            (void)make_dome(texels, desc);
        } catch (const SceneError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_NE(message(image, dome_desc()).find("/World/Sky"), std::string::npos);
    EXPECT_NE(message(image, dome_desc()).find("not finite at (2, 1)"), std::string::npos);
    image.texel(2, 1) = Rgb(1);
    EXPECT_EQ(message(image, dome_desc()), "accepted");
    EXPECT_NE(message(image, dome_desc({}, Axis::X)).find("pole axis"), std::string::npos);
}

}  // namespace
}  // namespace etendue
