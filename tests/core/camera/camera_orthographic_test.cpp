// The orthographic camera: its window, and that it has one direction and no lens.

#include <gtest/gtest.h>

#include "camera/camera.h"
#include "core/camera/camera_cases.h"
#include "math/constants.h"
#include "math/rng.h"

namespace etendue {
namespace {

using test::kHeight;
using test::kWidth;

TEST(Orthographic, ApertureIsTheWindowInTenthsOfUnits) {
    CameraDesc desc;
    desc.projection = CameraProjection::Orthographic;
    desc.horizontal_aperture = 40;
    desc.vertical_aperture = 20;
    desc.horizontal_aperture_offset = 3;
    desc.world_from_camera.m[0] = desc.world_from_camera.m[5] = desc.world_from_camera.m[10] = 7;  // does not count
    desc.focal_length = 0;                                                                         // nor does this
    // What GfCamera::GetFrustum() gives.
    const Camera camera(desc, 64, 32, ApertureConform::ExpandAperture);
    const CameraRay top_left = camera.generate_ray({0, 0}, {0.1, 0.2});
    const CameraRay bottom_right = camera.generate_ray({64, 32}, {0.3, 0.4});
    EXPECT_LT(length(top_left.origin - Vec3{-1.7, 1, 0}), 1e-14);
    EXPECT_LT(length(bottom_right.origin - Vec3{2.3, -1, 0}), 1e-14);
    EXPECT_EQ(top_left.direction, (Vec3{0, 0, -1}));
    EXPECT_EQ(bottom_right.direction, (Vec3{0, 0, -1}));
    // Conforming widens about the shifted centre.
    const Camera square(desc, 64, 64, ApertureConform::ExpandAperture);
    EXPECT_LT(length(square.generate_ray({0, 0}, {}).origin - Vec3{-1.7, 2, 0}), 1e-14);
}

class OrthographicCamera : public testing::Test {
protected:
    const Camera camera{test::orthographic(), kWidth, kHeight, ApertureConform::ExpandAperture};
    const double pixel_area = length(camera.generate_ray({1, 0}, {}).origin - camera.generate_ray({0, 0}, {}).origin) *
                              length(camera.generate_ray({0, 1}, {}).origin - camera.generate_ray({0, 0}, {}).origin);
};

TEST_F(OrthographicCamera, RayAndLensSampleAreOneAnother) {
    Rng rng(1, 0, 0);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 u = rng.next_2d();
        const Vec2 raster{u.x * kWidth, u.y * kHeight};
        const CameraRay ray = camera.generate_ray(raster, rng.next_2d());
        EXPECT_EQ(ray.direction, camera.forward());
        EXPECT_NEAR(camera.depth(ray.origin), 0, 1e-12);
        EXPECT_EQ(ray.weight, test::orthographic().exposure_scale);
        EXPECT_NEAR(ray.pdf_dir * pixel_area, 1, 1e-12);
        EXPECT_EQ(ray.pdf_lens, 1);
        const double distance = 0.1 + 20 * rng.next_1d();
        const auto lens = camera.sample_lens(ray.origin + ray.direction * distance, rng.next_2d());
        ASSERT_TRUE(lens);
        EXPECT_NEAR(lens->raster.x, raster.x, 1e-9);
        EXPECT_NEAR(lens->raster.y, raster.y, 1e-9);
        EXPECT_LT(length(lens->origin - ray.origin), 1e-11);
        EXPECT_EQ(lens->direction, ray.direction);
        EXPECT_NEAR(lens->distance, distance, 1e-11);
        EXPECT_EQ(lens->pdf_dir, ray.pdf_dir);
        EXPECT_EQ(lens->pdf_lens, 1);
        EXPECT_NEAR(lens->weight * pixel_area / ray.weight, 1, 1e-12);
    }
}

TEST_F(OrthographicCamera, NothingFindsIt) {
    const Vec3 before = test::kPosition + camera.forward() * 2;
    EXPECT_FALSE(camera.has_lens());
    EXPECT_FALSE(camera.hit_lens(before, -camera.forward(), kInfinity));
    EXPECT_FALSE(camera.sample_lens_towards(camera.forward(), {0.5, 0.5}));
    EXPECT_FALSE(camera.sample_lens(test::kPosition - camera.forward() * 2, {0.5, 0.5}));
    EXPECT_FALSE(camera.sample_lens(test::kPosition, {0.5, 0.5}));
    EXPECT_EQ(camera.pdf_dir(test::kPosition, -camera.forward()), 0);
}

}  // namespace
}  // namespace etendue
