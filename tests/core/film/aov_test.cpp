// What the AOVs of a render mean, and that a crop shows what the whole picture shows there.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "support/estimate.h"
#include "support/replicas.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

constexpr std::array kIntegrators{IntegratorKind::Path, IntegratorKind::Light, IntegratorKind::Bdpt};

/// A camera that looks along -z from z = 5; a wall at z = 1 from x = 0.05 to the right, a slope behind the left edge.
SceneDescription half_wall() {
    SceneBuilder b;
    b.quad({0.05, -9, 1}, {9, 0, 0}, {0, 18, 0}, b.material(DiffuseMaterial{{{0.2, 0.4, 0.6}}}));
    b.camera({0, 0, 5}, {0, 0, 0}, 60);
    b.light(point_light({0, 0, 4}, 4));
    return b.scene();
}

float at(const RenderedImage& image, Aov aov, int x, int y, int channel = 0) {
    const AovImage& a = *image.find(aov);
    return a.data[static_cast<std::size_t>((y * image.width + x) * a.channels + channel)];
}

TEST(Aov, HaveNamesAndChannels) {
    EXPECT_EQ(aov_name(Aov::SampleCount), "sample_count");
    EXPECT_EQ(aov_name(Aov::Variance), "variance");
    EXPECT_EQ(aov_channels(Aov::Variance), 3);
    EXPECT_EQ(aov_channels(Aov::Depth), 1);
}

TEST(Aov, DescribeTheFirstSurface) {
    for (IntegratorKind integrator : kIntegrators) {
        RenderSettings settings = small_settings(integrator, 9, 64);
        settings.aovs = {Aov::Color, Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo, Aov::SampleCount};
        const RenderedImage image = render(half_wall(), settings);
        const double pixel = 2 * 4 * std::tan(30 * 3.14159265358979 / 180) / 9;  // width of a pixel on the wall
        for (int y = 0; y < 9; ++y) {
            for (int x = 0; x < 9; ++x) {
                EXPECT_EQ(at(image, Aov::SampleCount, x, y), 64);
                const float alpha = at(image, Aov::Alpha, x, y);
                if (x < 4) {
                    EXPECT_EQ(alpha, 0);
                    EXPECT_EQ(at(image, Aov::Depth, x, y), std::numeric_limits<float>::infinity());
                    EXPECT_EQ(at(image, Aov::Normal, x, y, 2), 0);
                    continue;
                }
                if (x > 4) EXPECT_EQ(alpha, 1);
                // The middle column's pixels are cut by the edge: 64 samples in or out, five standard deviations.
                if (x == 4) EXPECT_NEAR(alpha, 0.5 - 0.05 / pixel, 5 * 0.5 / 8);
                EXPECT_NEAR(at(image, Aov::Depth, x, y), 4, 1e-5);  // along the axis, not along the ray
                EXPECT_NEAR(at(image, Aov::Normal, x, y, 2), 1, 1e-6);
                EXPECT_NEAR(at(image, Aov::Albedo, x, y, 1), 0.4F * alpha, 1e-6);
            }
        }
        EXPECT_GT(at(image, Aov::Color, 7, 4, 2), 0);
        EXPECT_EQ(at(image, Aov::Color, 1, 4, 2), 0);
    }
}

/// Where a ray leaves the lens at a grazing angle, its depth is less than the float roundings of the point it finds,
/// which may lie on a face of any size: to the second order these do not count.
TEST(Aov, DepthOfAGrazingRayIsNotRoundedAway) {
    constexpr double kSize = 1e6;
    SceneBuilder b;
    b.quad({-kSize, -1, kSize / 3}, {2.1 * kSize, 0, 0.3 * kSize}, {0.2 * kSize, 0, -2 * kSize}, b.diffuse(0.5));
    b.camera({0, 0, 0}, {0, 0, -1}, 179.6);  // downwards, half a pixel from the edge, the depth is 0.004
    b.scene().cameras[0].horizontal_aperture = 1e-9;
    for (const IntegratorKind integrator : kIntegrators) {
        RenderSettings settings = small_settings(integrator, 1, 1);
        settings.height = 32;
        settings.filter.radius = 1e-6;
        settings.conform = ApertureConform::AdjustPixelAspect;
        settings.aovs = {Aov::Depth};
        const RenderedImage image = render(b.scene(), settings);
        for (int y = 16; y < 32; ++y) {
            const double depth = 16 / (y + 0.5 - 16) * std::tan(0.2 * 3.14159265358979 / 180);
            EXPECT_NEAR(at(image, Aov::Depth, 0, y) / depth, 1, 0.01) << y;
        }
    }
}

/// Rays leave a lens this wide for its focus at right angles to the view: how far they go forward is less than the
/// roundings of their directions.
TEST(Aov, DepthBehindAHugeLensIsNotNegative) {
    SceneBuilder b;
    b.sphere({0.1, 0.2, 0.3}, 100, b.diffuse(0.5));
    b.camera({0, 0, 0}, {0.3, 0.5, -1}, 40);
    b.lens(1, 1.1e-10);  // no steeper rays are taken
    RenderSettings settings = small_settings(IntegratorKind::Path, 8, 1);
    settings.aovs = {Aov::Depth};
    const RenderedImage image = render(b.scene(), settings);
    for (const float depth : image.find(Aov::Depth)->data) EXPECT_GE(depth, 0);
}

TEST(Aov, AskedForOrNotTheColourIsTheSame) {
    for (IntegratorKind integrator : kIntegrators) {
        RenderSettings settings = small_settings(integrator, 8, 2);
        const RenderedImage alone = render(diffuse_box(), settings);
        settings.aovs = {Aov::Variance, Aov::Albedo, Aov::Color, Aov::Depth};
        const RenderedImage among = render(diffuse_box(), settings);
        EXPECT_EQ(alone.find(Aov::Color)->data, among.find(Aov::Color)->data);
        EXPECT_EQ(alone.find(Aov::Depth), nullptr);
    }
}

constexpr PixelWindow kCrop{5, 3, 14, 16};

TEST(Crop, OfAPathTracedPictureIsBitForBitTheSame) {
    for (FilterKind kind : {FilterKind::Box, FilterKind::Gaussian}) {
        RenderSettings settings = small_settings(IntegratorKind::Path, 20, 4);
        settings.filter = {kind, 1.2};
        settings.aovs = {Aov::Color, Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo, Aov::Variance};
        const RenderedImage whole = render(diffuse_box(), settings);
        settings.crop = kCrop;
        const RenderedImage crop = render(diffuse_box(), settings);
        ASSERT_EQ(crop.width, 9);
        ASSERT_EQ(crop.height, 13);
        for (Aov aov : settings.aovs) {
            for (int y = 0; y < crop.height; ++y) {
                for (int x = 0; x < crop.width; ++x) {
                    for (int c = 0; c < aov_channels(aov); ++c) {
                        EXPECT_EQ(at(crop, aov, x, y, c), at(whole, aov, x + kCrop.x0, y + kCrop.y0, c));
                    }
                }
            }
        }
    }
}

// A crop traces light paths for its own pixels only, and those still spread over the whole picture.
TEST(Crop, OfAPictureOfLightPathsIsTheSameInTheMean) {
    for (IntegratorKind integrator : {IntegratorKind::Light, IntegratorKind::Bdpt}) {
        RenderSettings settings = small_settings(integrator, 20, 16);
        settings.filter = {FilterKind::Triangle, 1};
        const Replicas whole = render_replicas(diffuse_box(), settings, 16, 1).cut(kCrop);
        settings.crop = kCrop;
        const Replicas crop = render_replicas(diffuse_box(), settings, 16, 2);
        EXPECT_TRUE(same_picture(whole, crop));
    }
}

}  // namespace
}  // namespace etendue::test
