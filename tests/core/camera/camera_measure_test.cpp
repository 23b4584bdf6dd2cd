// Camera rays, samples of the lens and light that finds the lens measure the same thing. Seeds are fixed;
// test::agrees states the false alarm rate.

#include <cmath>

#include <gtest/gtest.h>

#include "camera/camera.h"
#include "core/camera/camera_cases.h"
#include "math/constants.h"
#include "math/frame.h"
#include "math/rng.h"
#include "math/sampling.h"
#include "support/estimate.h"

namespace etendue {
namespace {

using test::Estimate;
using test::kHeight;
using test::kWidth;

class CameraMeasure : public testing::TestWithParam<test::CameraCase> {
protected:
    const Camera camera{GetParam().desc, kWidth, kHeight, GetParam().conform};
    const double scale = GetParam().desc.exposure_scale;

    static Vec2 random_raster(Rng& rng) {
        const Vec2 u = rng.next_2d();
        return {u.x * kWidth, u.y * kHeight};
    }
};

TEST_P(CameraMeasure, RayAndLensSampleAreOneAnother) {
    Rng rng(1, 0, 0);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 raster = random_raster(rng);
        const Vec2 u_lens = rng.next_2d();
        const CameraRay ray = camera.generate_ray(raster, u_lens);
        const double distance = 0.1 + 20 * rng.next_1d();
        const auto lens = camera.sample_lens(ray.origin + ray.direction * distance, u_lens);
        ASSERT_TRUE(lens);
        EXPECT_NEAR(lens->raster.x, raster.x, 1e-9);
        EXPECT_NEAR(lens->raster.y, raster.y, 1e-9);
        EXPECT_LT(length(lens->origin - ray.origin), 1e-12);
        EXPECT_LT(length(lens->direction - ray.direction), 1e-12);
        EXPECT_NEAR(lens->distance / distance, 1, 1e-12);
        EXPECT_NEAR(lens->pdf_dir / ray.pdf_dir, 1, 1e-12);
        EXPECT_NEAR(camera.pdf_dir(ray.origin, ray.direction) / ray.pdf_dir, 1, 1e-15);
        EXPECT_EQ(lens->pdf_lens, ray.pdf_lens);
        EXPECT_EQ(ray.weight, scale);
        // We |cos| / (d^2 pdf_lens) with We |cos| = scale pdf_lens pdf_dir.
        EXPECT_NEAR(lens->weight * distance * distance / (scale * ray.pdf_dir), 1, 1e-12);
    }
}

TEST_P(CameraMeasure, LensHitIsTheRayBackwards) {
    Rng rng(2, 0, 0);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 raster = random_raster(rng);
        const CameraRay ray = camera.generate_ray(raster, rng.next_2d());
        const double distance = 0.1 + 20 * rng.next_1d();
        const Vec3 far = ray.origin + ray.direction * distance;
        const auto hit = camera.hit_lens(far, -ray.direction, kInfinity);
        ASSERT_EQ(hit.has_value(), camera.has_lens());
        if (!hit) continue;
        EXPECT_LT(length(hit->p - ray.origin), 1e-11);
        EXPECT_NEAR(hit->distance / distance, 1, 1e-12);
        EXPECT_NEAR(hit->raster.x, raster.x, 1e-9);
        EXPECT_NEAR(hit->raster.y, raster.y, 1e-9);
        EXPECT_EQ(hit->pdf_lens, ray.pdf_lens);
        EXPECT_NEAR(hit->pdf_dir / ray.pdf_dir, 1, 1e-12);
        const double cos = dot(ray.direction, camera.forward());
        EXPECT_NEAR(hit->importance * cos / (scale * ray.pdf_lens * ray.pdf_dir), 1, 1e-12);
        EXPECT_FALSE(camera.hit_lens(far, -ray.direction, distance * 0.999));                 // blocked before
        EXPECT_FALSE(camera.hit_lens(ray.origin - ray.direction, ray.direction, kInfinity));  // from the back
        EXPECT_FALSE(camera.hit_lens(far, ray.direction, kInfinity));                         // away from it
    }
}

TEST_P(CameraMeasure, LensHasAnEdge) {
    const Vec3 outward = Frame::from_normal(camera.forward()).s;
    for (const double radius : {1.24, 1.26}) {
        const Vec3 on_plane = test::kPosition + outward * radius;
        const Vec3 w = normalize(-camera.forward() + outward * 0.3);
        const bool hit = camera.hit_lens(on_plane - w * 5, w, kInfinity).has_value();
        EXPECT_EQ(hit, camera.has_lens() && radius < test::kLensRadius);
    }
}

TEST_P(CameraMeasure, NothingBehind) {
    const Vec3 behind = test::kPosition - camera.forward() * 3;
    EXPECT_FALSE(camera.sample_lens(behind, {0.3, 0.4}));
    EXPECT_FALSE(camera.sample_lens(test::kPosition, {0.3, 0.4}));
    EXPECT_EQ(camera.pdf_dir(test::kPosition, -camera.forward()), 0);
}

/// Uniform directions of a cone about the pixel's ray: the fraction in the pixel, weighed by pdf_dir, is one.
TEST_P(CameraMeasure, DirectionDensityIntegratesToOneOverAPixel) {
    Rng rng(3, 0, 0);
    for (const Vec2& corner : {Vec2{0, 0}, Vec2{31, 17}, Vec2{63, 39}, Vec2{-20, 50}}) {  // the last lies outside
        const Vec2 u_lens{0.8, 0.3};
        const CameraRay middle = camera.generate_ray({corner.x + 0.5, corner.y + 0.5}, u_lens);
        double one_minus_cos = 0;
        for (const Vec2& c : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}}) {
            const Vec3 d = camera.generate_ray({corner.x + c.x, corner.y + c.y}, u_lens).direction - middle.direction;
            one_minus_cos = std::max(one_minus_cos, length_squared(d) / 2 * 1.01);
        }
        const Frame frame = Frame::from_normal(middle.direction);
        Estimate integral;
        for (int i = 0; i < test::samples(400'000); ++i) {
            const Vec3 w = frame.to_world(sample_uniform_cone(rng.next_2d(), one_minus_cos));
            const Vec2 raster = camera.sample_lens(middle.origin + w, u_lens)->raster;
            const bool inside =
                raster.x >= corner.x && raster.x < corner.x + 1 && raster.y >= corner.y && raster.y < corner.y + 1;
            integral.add(inside ? camera.pdf_dir(middle.origin, w) * 2 * kPi * one_minus_cos : 0);
        }
        EXPECT_TRUE(test::agrees(integral, 1)) << corner.x;
    }
}

/// Towards infinity is the limit of a far point: the weight times the squared distance, the place on the film.
TEST_P(CameraMeasure, TowardsInfinityIsTheLimitOfFarPoints) {
    Rng rng(7, 0, 0);
    for (int i = 0; i < 500; ++i) {
        const Vec2 u_lens = rng.next_2d();
        const Vec3 w = camera.generate_ray(random_raster(rng), {0.5, 0.5}).direction;
        const double distance = 1e8;
        const auto far = camera.sample_lens(camera.position() + w * distance, u_lens);
        const auto infinite = camera.sample_lens_towards(w, u_lens);
        ASSERT_TRUE(far && infinite);
        EXPECT_EQ(infinite->distance, kInfinity);
        EXPECT_EQ(infinite->origin, far->origin);
        EXPECT_NEAR(infinite->raster.x, far->raster.x, 1e-5);
        EXPECT_NEAR(infinite->raster.y, far->raster.y, 1e-5);
        EXPECT_NEAR(infinite->weight / (far->weight * distance * distance), 1, 1e-6);
        EXPECT_NEAR(infinite->pdf_dir / far->pdf_dir, 1, 1e-6);
        EXPECT_EQ(infinite->pdf_lens, far->pdf_lens);
        EXPECT_FALSE(camera.sample_lens_towards(-w, u_lens));
    }
}

/// A sun that covers part of the image: by camera rays that fall into its cone and by joining its directions.
TEST_P(CameraMeasure, CameraRaysAndDirectionsFromInfinityAgree) {
    const double one_minus_cos = 0.02;
    const Frame sun = Frame::from_normal(camera.generate_ray({20, 28}, {0.5, 0.5}).direction);
    Rng rng(8, 0, 0);
    Estimate rays;
    Estimate joined;
    for (int i = 0; i < test::samples(400'000); ++i) {
        const CameraRay ray = camera.generate_ray(random_raster(rng), rng.next_2d());
        const bool in_cone = length_squared(ray.direction - sun.n) < 2 * one_minus_cos;
        rays.add(in_cone ? ray.weight * kWidth * kHeight : 0);
        const Vec3 w = sun.to_world(sample_uniform_cone(rng.next_2d(), one_minus_cos));
        const auto lens = camera.sample_lens_towards(w, rng.next_2d());
        const bool in_window =
            lens && lens->raster.x >= 0 && lens->raster.x < kWidth && lens->raster.y >= 0 && lens->raster.y < kHeight;
        joined.add(in_window ? lens->weight * 2 * kPi * one_minus_cos : 0);
    }
    EXPECT_TRUE(test::agree(rays, joined, 0.006));
}

/// A small disk of unit radiance seen by the camera, measured in units of pixel values summed over the window
/// [0, kWidth] x [0, kHeight]: by camera rays, by joining its points to the lens, and by light that finds the lens.
class CameraFlux : public CameraMeasure {
protected:
    void SetUp() override {
        const CameraRay ray = camera.generate_ray({20, 28}, {0.5, 0.5});
        center = ray.origin + ray.direction * 4;  // nearer than the focus
        n = normalize(-ray.direction + Vec3{0.3, -0.2, 0.1});
    }
    [[nodiscard]] Vec3 point(const Vec2& u) const {
        const Vec2 d = sample_concentric_disk(u);
        return center + Frame::from_normal(n).to_world({d.x * kRadius, d.y * kRadius, 0});
    }
    static bool in_window(const Vec2& raster) {
        return raster.x >= 0 && raster.x < kWidth && raster.y >= 0 && raster.y < kHeight;
    }

    Estimate by_camera_rays() const {
        Rng rng(4, 0, 0);
        Estimate estimate;
        for (int i = 0; i < test::samples(1'000'000); ++i) {
            const Vec2 raster = random_raster(rng);
            const CameraRay ray = camera.generate_ray(raster, rng.next_2d());
            const double cos = -dot(ray.direction, n);
            const double t = cos > 0 ? dot(ray.origin - center, n) / cos : -1;
            const bool hit = t > 0 && length(ray.origin + ray.direction * t - center) < kRadius;
            estimate.add(hit ? ray.weight * kWidth * kHeight : 0);
        }
        return estimate;
    }
    Estimate by_lens_samples() const {
        Rng rng(5, 0, 0);
        Estimate estimate;
        for (int i = 0; i < test::samples(200'000); ++i) {
            const Vec3 p = point(rng.next_2d());
            const auto lens = camera.sample_lens(p, rng.next_2d());
            const double cos = lens ? std::max(0.0, -dot(lens->direction, n)) : 0;
            estimate.add(lens && in_window(lens->raster) ? lens->weight * cos * kArea : 0);
        }
        return estimate;
    }
    Estimate by_lens_hits() const {
        Rng rng(6, 0, 0);
        Estimate estimate;
        const Frame frame = Frame::from_normal(n);
        for (int i = 0; i < test::samples(4'000'000); ++i) {
            const Vec3 p = point(rng.next_2d());
            const Vec3 w = frame.to_world(sample_cosine_hemisphere(rng.next_2d()));
            const auto hit = camera.hit_lens(p, w, kInfinity);
            // Le |cos| / pdf = pi area; importance times the cosine at the lens is what a pixel makes of it, since
            // a hit carries We without its own cosine: flux through the lens is dA |cos| dw.
            estimate.add(hit && in_window(hit->raster) ? kPi * kArea * hit->importance : 0);
        }
        return estimate;
    }

    static constexpr double kRadius = 0.8;
    static constexpr double kArea = kPi * kRadius * kRadius;
    Vec3 center;
    Vec3 n;
};

TEST_P(CameraFlux, CameraRaysLensSamplesAndLensHitsAgree) {
    const Estimate rays = by_camera_rays();
    const Estimate joined = by_lens_samples();
    EXPECT_TRUE(test::agree(rays, joined, 0.005));
    if (camera.has_lens()) {
        EXPECT_TRUE(test::agree(by_lens_hits(), joined, 0.006));
    }
}

INSTANTIATE_TEST_SUITE_P(Cameras, CameraMeasure, testing::ValuesIn(test::cameras()), test::case_name);
INSTANTIATE_TEST_SUITE_P(Cameras, CameraFlux, testing::ValuesIn(test::cameras()), test::case_name);
INSTANTIATE_TEST_SUITE_P(Orthographic, CameraFlux,
                         testing::Values(test::CameraCase{"Plain", test::orthographic()},
                                         test::CameraCase{"Stretched", test::orthographic(),
                                                          ApertureConform::AdjustPixelAspect}),
                         test::case_name);

}  // namespace
}  // namespace etendue
