// Textures on rect lights: which way up, and how they are sampled.

#include <memory>

#include <gtest/gtest.h>

#include "core/light/light_cases.h"
#include "core/light/memory_image.h"
#include "math/rng.h"
#include "support/chi2.h"
#include "support/estimate.h"

namespace etendue {
namespace {

LightDesc rect(const Matrix4& world_from_light = {}) {
    LightDesc desc;
    desc.name = "/World/Screen";
    desc.kind = LightKind::Rect;
    desc.width = 4;
    desc.height = 2;
    desc.world_from_light = world_from_light;
    desc.texture_file = "screen.exr";  // it stands for the image given with it
    return desc;
}

std::unique_ptr<Light> screen(const test::MemoryImage& image, const Matrix4& world_from_light = {}) {
    return make_light(rect(world_from_light), test::kBounds, std::make_shared<test::MemoryImage>(image));
}

/// Seen from -Z with +Y up, +X is at the left: there the picture begins.
TEST(RectImage, IsUprightToWhoSeesItShine) {
    test::MemoryImage image(2, 2, false);
    image.texel(0, 0) = {1, 0, 0};
    image.texel(1, 0) = {0, 1, 0};
    image.texel(0, 1) = {0, 0, 1};
    const auto light = screen(image);
    Rng rng(81, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const LightPoint y = light->sample_emission(rng.next_2d(), {0.5, 0.5}).y;
        const Rgb seen = light->radiance(y, {0, 0, -1});
        if (y.p.x > 1 && y.p.y > 0.5) EXPECT_EQ(seen, Rgb(1, 0, 0));   // upper left
        if (y.p.x < -1 && y.p.y > 0.5) EXPECT_EQ(seen, Rgb(0, 1, 0));  // upper right
        if (y.p.x > 1 && y.p.y < -0.5) EXPECT_EQ(seen, Rgb(0, 0, 1));  // lower left
        if (y.p.x < -1 && y.p.y < -0.5) EXPECT_EQ(seen, Rgb());
    }
}

/// The traced shape carries the same coordinates.
TEST(RectImage, ShapeAndSamplesAgree) {
    const auto shape = make_light_shape(rect(test::general()));
    const auto& mesh = std::get<TriangleMesh>(*shape);
    const auto light = screen(test::mottled_image(8, 4, false), test::general());
    Rng rng(82, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const LightPoint y = light->sample_emission(rng.next_2d(), {0.5, 0.5}).y;
        // The mesh's st is affine in its points.
        const Vec3 e1 = mesh.point(0, 1) - mesh.point(0, 0);
        const Vec3 e2 = mesh.point(0, 2) - mesh.point(0, 0);
        const Vec3 n = cross(e1, e2);
        const Vec3 q = y.p - mesh.point(0, 0);
        const double b1 = dot(cross(q, e2), n) / length_squared(n);
        const double b2 = dot(cross(e1, q), n) / length_squared(n);
        const auto st = [&](std::size_t axis) {
            const double at0 = mesh.corner_st(0, 0)[axis];
            return at0 + b1 * (mesh.corner_st(0, 1)[axis] - at0) + b2 * (mesh.corner_st(0, 2)[axis] - at0);
        };
        ASSERT_NEAR(st(0), y.st.x, 1e-6);
        ASSERT_NEAR(st(1), y.st.y, 1e-6);
    }
}

TEST(RectImage, PointsFollowTheirDensity) {
    for (const Vec2& size : {Vec2{8, 6}, Vec2{5, 7}}) {
        const auto columns = static_cast<int>(size.x);
        const auto rows = static_cast<int>(size.y);
        const auto light = screen(test::sunny_image(columns, rows, false), test::general());
        const double area = 8 * length(cross(Transform(test::general()).vector({1, 0, 0}),
                                             Transform(test::general()).vector({0, 1, 0})));
        const auto density = [&](const Vec2& at) {
            LightPoint y;
            y.n = {0, 0, -1};
            y.st = {at.x, 1 - at.y};
            return light->pdf_emission(y, {0, 0, -1}).pdf_point * area;
        };
        const auto sampler = [&](Rng& rng) -> std::optional<Vec2> {
            const Vec2 st = light->sample_emission(rng.next_2d(), {0.5, 0.5}).y.st;
            return Vec2{st.x, 1 - st.y};
        };
        const test::Grid grid{test::even_edges(0, 1, columns), test::even_edges(0, 1, rows)};
        EXPECT_TRUE(test::passes(test::chi2_plane(sampler, density, grid, {100'000, test::sidak(1e-4, 2), 9})));
    }
}

TEST(RectImage, PowerIsTheMeanOfTheImage) {
    test::MemoryImage image = test::mottled_image(6, 4, false);
    Rgb sum;
    constexpr int kSteps = 240;  // the filter is linear between multiples of a half texel: midpoints are exact
    for (int y = 0; y < kSteps; ++y) {
        for (int x = 0; x < kSteps; ++x) sum += image.at({(x + 0.5) / kSteps, (y + 0.5) / kSteps});
    }
    const double mean = sum.g / (kSteps * kSteps);
    EXPECT_NEAR(screen(image)->power().g / (8 * kPi * mean), 1, 1e-12);
}

TEST(RectImage, BlackImagesAreDark) { EXPECT_TRUE(is_black(screen(test::MemoryImage(3, 2, false))->power())); }

}  // namespace
}  // namespace etendue
