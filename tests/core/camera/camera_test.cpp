// What the attributes of a UsdGeomCamera mean, and where its rays go.

#include "camera/camera.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <etendue/error.h>

#include "core/camera/camera_cases.h"
#include "math/constants.h"
#include "math/rng.h"

namespace etendue {
namespace {

using enum ApertureConform;

/// Window on the plane at distance 1, as fractions of distance: x of the left and right edge, y of bottom and top.
struct Window {
    double left, right, bottom, top;
};

Window window(const CameraDesc& desc, int width, int height, ApertureConform conform) {
    const Camera camera(desc, width, height, conform);
    const Vec3 top_left = camera.generate_ray({0, 0}, {}).direction;
    const Vec3 bottom_right = camera.generate_ray({double(width), double(height)}, {}).direction;
    return {top_left.x / -top_left.z, bottom_right.x / -bottom_right.z, bottom_right.y / -bottom_right.z,
            top_left.y / -top_left.z};
}

double degrees_between(const Vec3& a, const Vec3& b) { return std::acos(dot(a, b)) * 180 / kPi; }

TEST(Camera, DefaultFieldOfView) {
    const Camera camera(CameraDesc{}, 640, 480, AdjustPixelAspect);
    const auto direction = [&](double x, double y) { return camera.generate_ray({x, y}, {}).direction; };
    EXPECT_NEAR(degrees_between(direction(0, 240), direction(640, 240)), 23.67, 0.005);
    EXPECT_NEAR(degrees_between(direction(320, 0), direction(320, 480)), 17.39, 0.005);
}

TEST(Camera, LooksDownMinusZWithYUpAndPixelZeroTopLeft) {
    const Camera camera(CameraDesc{}, 640, 480, ExpandAperture);
    EXPECT_LT(length(camera.generate_ray({320, 240}, {}).direction - Vec3{0, 0, -1}), 1e-15);
    const Vec3 first = camera.generate_ray({0.5, 0.5}, {}).direction;
    EXPECT_LT(first.x, 0);
    EXPECT_GT(first.y, 0);
    EXPECT_EQ(camera.forward(), (Vec3{0, 0, -1}));
    EXPECT_EQ(camera.depth({3, 4, -7}), 7);
    EXPECT_FALSE(camera.has_lens());
}

TEST(Camera, ConformPolicies) {
    CameraDesc desc;
    desc.focal_length = 10;
    desc.horizontal_aperture = 40;  // aspect 2
    desc.vertical_aperture = 20;
    const auto size = [&](int width, int height, ApertureConform conform) {
        const Window w = window(desc, width, height, conform);
        return Vec2{w.right - w.left, w.top - w.bottom};
    };
    struct Case {
        int width, height;
        ApertureConform conform;
        double expected_width, expected_height;
    };
    for (const Case& c : {Case{300, 100, ExpandAperture, 6, 2}, Case{100, 100, ExpandAperture, 4, 4},
                          Case{300, 100, CropAperture, 4, 4 / 3.0}, Case{100, 100, CropAperture, 2, 2},
                          Case{300, 100, AdjustApertureWidth, 6, 2}, Case{100, 100, AdjustApertureWidth, 2, 2},
                          Case{300, 100, AdjustApertureHeight, 4, 4 / 3.0}, Case{100, 100, AdjustApertureHeight, 4, 4},
                          Case{300, 100, AdjustPixelAspect, 4, 2}, Case{100, 100, AdjustPixelAspect, 4, 2},
                          Case{200, 100, ExpandAperture, 4, 2}, Case{200, 100, CropAperture, 4, 2}}) {
        const Vec2 actual = size(c.width, c.height, c.conform);
        EXPECT_NEAR(actual.x, c.expected_width, 1e-12) << static_cast<int>(c.conform) << ' ' << c.width;
        EXPECT_NEAR(actual.y, c.expected_height, 1e-12) << static_cast<int>(c.conform) << ' ' << c.width;
    }
}

TEST(Camera, PositiveOffsetsShiftTheWindowToPlusXAndPlusY) {
    CameraDesc desc;
    desc.focal_length = 10;
    desc.horizontal_aperture = 20;
    desc.vertical_aperture = 10;
    desc.horizontal_aperture_offset = 3;
    desc.vertical_aperture_offset = 2;
    // Conforming widens about the shifted centre.
    const Window w = window(desc, 300, 100, ExpandAperture);
    EXPECT_NEAR(w.left, 0.3 - 1.5, 1e-12);
    EXPECT_NEAR(w.right, 0.3 + 1.5, 1e-12);
    EXPECT_NEAR(w.bottom, 0.2 - 0.5, 1e-12);
    EXPECT_NEAR(w.top, 0.2 + 0.5, 1e-12);
}

TEST(Camera, ScaleShearAndMirrorDoNotCount) {
    CameraDesc desc;
    desc.world_from_camera = test::placed(1);
    const Camera plain(desc, 64, 48, ExpandAperture);
    desc.world_from_camera = test::placed(250);
    const Camera scaled(desc, 64, 48, ExpandAperture);
    desc.world_from_camera = test::placed(1);
    for (const std::size_t row : {0u, 4u, 8u}) desc.world_from_camera.m[row] *= -1;  // mirrored in x
    const Camera mirrored(desc, 64, 48, ExpandAperture);
    for (const Vec2& raster : {Vec2{0, 0}, Vec2{10, 40}, Vec2{63, 1}}) {
        const Vec3 direction = plain.generate_ray(raster, {}).direction;
        EXPECT_LT(length(scaled.generate_ray(raster, {}).direction - direction), 1e-14);
        EXPECT_LT(length(mirrored.generate_ray(raster, {}).direction - direction), 1e-14);
    }
    // Whatever +Y is sheared by along -Z, forward stays and up is upright.
    CameraDesc sheared;
    sheared.world_from_camera.m[9] = 0.7;  // z += 0.7 y
    const Camera camera(sheared, 64, 48, ExpandAperture);
    EXPECT_LT(length(camera.generate_ray({32, 24}, {}).direction - Vec3{0, 0, -1}), 1e-14);
    EXPECT_NEAR(camera.generate_ray({32, 0}, {}).direction.x, 0, 1e-14);
}

TEST(Camera, LensRadiusIsInSceneUnits) {
    // 50 tenths at f/2: 5 / (2 * 2) = 1.25 units.
    const Camera camera(test::thin_lens(), 64, 48, ExpandAperture);
    ASSERT_TRUE(camera.has_lens());
    const CameraRay ray = camera.generate_ray({32, 24}, {0.5, 0.5});
    EXPECT_NEAR(ray.pdf_lens, 1 / (kPi * test::kLensRadius * test::kLensRadius), 1e-12);
    const CameraRay edge = camera.generate_ray({32, 24}, {1 - 1e-12, 0.5});
    EXPECT_NEAR(length(edge.origin - ray.origin), test::kLensRadius, 1e-9);
    EXPECT_NEAR(camera.depth(edge.origin), 0, 1e-12);
}

TEST(Camera, StopWithoutFocusIsAPinhole) {
    CameraDesc desc = test::thin_lens();
    desc.focus_distance = 0;
    EXPECT_FALSE(Camera(desc, 64, 48, ExpandAperture).has_lens());
}

TEST(Camera, RaysThroughOneRasterPointMeetInTheFocusPlane) {
    const CameraDesc desc = test::thin_lens();
    const Camera camera(desc, 64, 48, ExpandAperture);
    const Vec2 raster{12.3, 40.7};
    const auto in_focus = [&](const Vec2& u) {
        const CameraRay ray = camera.generate_ray(raster, u);
        return ray.origin + ray.direction * (desc.focus_distance / dot(ray.direction, camera.forward()));
    };
    const Vec3 center = in_focus({0.5, 0.5});
    EXPECT_NEAR(camera.depth(center), desc.focus_distance, 1e-12);
    Rng rng(1, 0, 0);
    for (int i = 0; i < 100; ++i) EXPECT_LT(length(in_focus(rng.next_2d()) - center), 1e-12);
}

TEST(Camera, ErrorsNameTheCamera) {
    const auto expect_error = [](auto&& change) {
        CameraDesc desc;
        desc.name = "/World/Shot";
        change(desc);
        try {
            const Camera camera(desc, 64, 48, ExpandAperture);
            ADD_FAILURE() << "no error";
        } catch (const SceneError& error) {
            EXPECT_NE(std::string(error.what()).find("/World/Shot"), std::string::npos) << error.what();
        }
    };
    expect_error([](CameraDesc& c) { c.focal_length = 0; });
    expect_error([](CameraDesc& c) { c.horizontal_aperture = -1; });
    expect_error([](CameraDesc& c) { c.vertical_aperture = std::numeric_limits<double>::quiet_NaN(); });
    expect_error([](CameraDesc& c) { c.vertical_aperture_offset = std::numeric_limits<double>::infinity(); });
    expect_error([](CameraDesc& c) { c.f_stop = -1; });
    expect_error([](CameraDesc& c) { c.focus_distance = -2; });
    expect_error([](CameraDesc& c) { c.exposure_scale = -2; });
    expect_error([](CameraDesc& c) { c.exposure_scale = 1e39; });  // more than a float can hold
    expect_error([](CameraDesc& c) { c.world_from_camera.m[5] = 0; });
    // Slopes that a direction does not hold.
    expect_error([](CameraDesc& c) { c.focal_length = 1e-10; });
    expect_error([](CameraDesc& c) { c.vertical_aperture_offset = 1e18; });
    expect_error([](CameraDesc& c) {
        c.f_stop = 1e-11;
        c.focus_distance = 1;
    });
    // What Embree cannot trace.
    expect_error([](CameraDesc& c) { c.world_from_camera.m[3] = 2e18; });
    expect_error([](CameraDesc& c) { c.horizontal_aperture = 1e21; });
    expect_error([](CameraDesc& c) { c.focal_length = 1e300; });
    expect_error([](CameraDesc& c) {
        c.f_stop = 1e-20;
        c.focus_distance = 1;
    });
    expect_error([](CameraDesc& c) {
        c.f_stop = 2;
        c.focus_distance = 1e20;
    });
    for (const double focus_distance : {1e-19, 5e-324}) {
        expect_error([=](CameraDesc& c) {
            c.f_stop = 2;
            c.focus_distance = focus_distance;
        });
    }
    EXPECT_THROW(Camera(CameraDesc{}, 0, 48, ExpandAperture), SettingsError);
}

}  // namespace
}  // namespace etendue
