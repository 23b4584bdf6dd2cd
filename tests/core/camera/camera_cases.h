#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "camera/camera.h"

namespace etendue::test {

inline constexpr Vec3 kPosition{1, -2, 0.5};
inline constexpr double kLensRadius = 1.25;

/// Rotated about every axis (entries 2/3, 1/3) and moved to kPosition.
inline Matrix4 placed(double scale) {
    const double a = scale / 3;
    Matrix4 m;
    m.m = {2 * a, -2 * a, a, kPosition.x, a, 2 * a, 2 * a, kPosition.y, -2 * a, -a, 2 * a, kPosition.z, 0, 0, 0, 1};
    return m;
}

/// A wide view through a wide lens (kLensRadius) that is in focus at 6 units.
inline CameraDesc thin_lens() {
    CameraDesc desc;
    desc.name = "/lens";
    desc.world_from_camera = placed(1);
    desc.horizontal_aperture = 60;
    desc.vertical_aperture = 45;
    desc.horizontal_aperture_offset = 5;
    desc.vertical_aperture_offset = -3;
    desc.f_stop = 2;
    desc.focus_distance = 6;
    desc.exposure_scale = 1.7;
    return desc;
}

inline CameraDesc pinhole() {
    CameraDesc desc = thin_lens();
    desc.name = "/pinhole";
    desc.f_stop = 0;
    return desc;
}

/// A lens is asked for, and not had.
inline CameraDesc orthographic() {
    CameraDesc desc = thin_lens();
    desc.name = "/orthographic";
    desc.projection = CameraProjection::Orthographic;
    return desc;
}

inline constexpr int kWidth = 64;
inline constexpr int kHeight = 40;

struct CameraCase {
    std::string name;
    CameraDesc desc;
    ApertureConform conform = ApertureConform::ExpandAperture;
};

/// How a failing test shows its case.
inline void PrintTo(const CameraCase& camera_case, std::ostream* out) { *out << camera_case.name; }

inline std::string case_name(const testing::TestParamInfo<CameraCase>& param) { return param.param.name; }

inline std::vector<CameraCase> cameras() {
    return {{"Pinhole", pinhole()},
            {"PinholeStretched", pinhole(), ApertureConform::AdjustPixelAspect},
            {"ThinLens", thin_lens()},
            {"ThinLensStretched", thin_lens(), ApertureConform::AdjustPixelAspect}};
}

}  // namespace etendue::test
