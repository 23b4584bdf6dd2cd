#include "camera/camera.h"

#include <cmath>
#include <limits>
#include <string>

#include <etendue/error.h>

#include "geometry/ray.h"
#include "math/constants.h"
#include "math/sampling.h"

namespace etendue {
namespace {

[[noreturn]] void fail(const CameraDesc& camera, const std::string& what) {
    throw SceneError("camera '" + camera.name + "': " + what);
}

void require_positive(const CameraDesc& camera, double value, const char* attribute) {
    if (!std::isfinite(value) || value <= 0) fail(camera, std::string(attribute) + " must be positive");
}

void require_not_negative(const CameraDesc& camera, double value, const char* attribute) {
    if (!std::isfinite(value) || value < 0) fail(camera, std::string(attribute) + " must not be negative");
}

void check_attributes(const CameraDesc& camera, int width, int height) {
    require_positive(camera, camera.horizontal_aperture, "horizontal aperture");
    require_positive(camera, camera.vertical_aperture, "vertical aperture");
    if (camera.projection == CameraProjection::Perspective) {
        require_positive(camera, camera.focal_length, "focal length");
    }
    require_not_negative(camera, camera.f_stop, "f-stop");
    require_not_negative(camera, camera.focus_distance, "focus distance");
    require_not_negative(camera, camera.exposure_scale, "exposure scale");
    // Times a lamp's radiance it must not overflow, and no picture shows more.
    if (camera.exposure_scale > std::numeric_limits<float>::max()) {
        fail(camera, "exposure scale is more than a float can hold");
    }
    if (!std::isfinite(camera.horizontal_aperture_offset) || !std::isfinite(camera.vertical_aperture_offset)) {
        fail(camera, "aperture offset is not finite");
    }
    if (width <= 0 || height <= 0) {
        throw SettingsError("camera '" + camera.name + "': the image must be at least one pixel wide and high");
    }
}

Transform checked_transform(const CameraDesc& camera) {
    try {
        return Transform(camera.world_from_camera);
    } catch (const SceneError& error) {
        fail(camera, error.what());
    }
}

/// Of a ray's slope to the viewing axis: a direction keeps its cosine to six digits there. At 1e16 its sign is lost.
constexpr double kSteepest = 1e10;

struct Aperture {
    double width;
    double height;
};

/// The part of the plane that the image shows, about an unchanged centre (UsdRenderSettingsBase
/// aspectRatioConformPolicy).
Aperture conformed(const Aperture& aperture, double image_aspect, ApertureConform conform) {
    const Aperture width_adjusted{aperture.height * image_aspect, aperture.height};
    const Aperture height_adjusted{aperture.width, aperture.width / image_aspect};
    const bool image_is_wider = image_aspect > aperture.width / aperture.height;
    switch (conform) {
        case ApertureConform::ExpandAperture:
            return image_is_wider ? width_adjusted : height_adjusted;
        case ApertureConform::CropAperture:
            return image_is_wider ? height_adjusted : width_adjusted;
        case ApertureConform::AdjustApertureWidth:
            return width_adjusted;
        case ApertureConform::AdjustApertureHeight:
            return height_adjusted;
        case ApertureConform::AdjustPixelAspect:
            break;  // pixels are stretched until the image is the aperture
    }
    return aperture;
}

}  // namespace

bool has_lens(const CameraDesc& desc) {
    // Focus distance 0 is the schema's "not set": without a focus there is no lens.
    return desc.projection == CameraProjection::Perspective && desc.f_stop > 0 && desc.focus_distance > 0;
}

Camera::Camera(const CameraDesc& desc, int width, int height, ApertureConform conform) {
    check_attributes(desc, width, height);

    // Only the directions of the camera's -Z and +Y matter: scale and shear are taken out and a mirroring transform
    // yields an unmirrored picture (as GfFrustum does). Lens and focus distance are authored in world units.
    const Transform world_from_camera = checked_transform(desc);
    position_ = world_from_camera.translation();
    forward_ = normalize(world_from_camera.vector({0, 0, -1}));
    right_ = normalize(cross(forward_, world_from_camera.vector({0, 1, 0})));
    up_ = cross(right_, forward_);

    const Aperture aperture =
        conformed({desc.horizontal_aperture, desc.vertical_aperture}, static_cast<double>(width) / height, conform);
    orthographic_ = desc.projection == CameraProjection::Orthographic;
    constexpr double kUnitsPerTenth = 0.1;
    // Aperture and focal length share their unit, so the plane at distance 1 needs none.
    const double plane_per_aperture = orthographic_ ? kUnitsPerTenth : 1 / desc.focal_length;
    plane_left_ = (desc.horizontal_aperture_offset - aperture.width / 2) * plane_per_aperture;
    plane_top_ = (desc.vertical_aperture_offset + aperture.height / 2) * plane_per_aperture;
    plane_per_pixel_x_ = aperture.width * plane_per_aperture / width;
    plane_per_pixel_y_ = aperture.height * plane_per_aperture / height;

    if (etendue::has_lens(desc)) {
        lens_radius_ = desc.focal_length * kUnitsPerTenth / (2 * desc.f_stop);
        focus_distance_ = desc.focus_distance;
    }
    exposure_scale_ = desc.exposure_scale;
    check_reach(desc, width, height);
}

void Camera::check_reach(const CameraDesc& desc, int width, int height) const {
    const Vec3 window{plane_left_, plane_top_, 0};
    const Vec3 opposite{plane_left_ + plane_per_pixel_x_ * width, plane_top_ - plane_per_pixel_y_ * height, 0};
    const double widest = orthographic_ ? kFarthest : kSteepest;
    if (!(max_component(max(abs(window), abs(opposite))) <= widest)) {
        fail(desc, "it sees too much: aperture over focal length");
    }
    if (!within_reach(position_)) fail(desc, "it is too far away");
    if (!(lens_radius_ <= kFarthest)) fail(desc, "its lens is too large: focal length over f-stop");
    if (!(focus_distance_ <= kFarthest)) fail(desc, "focus distance is too large");
    // Rays from the lens to the plane in focus need a direction, and one off the lens.
    constexpr double kLeastFocus = 1e-100;
    if (has_lens() && !(focus_distance_ >= kLeastFocus && lens_radius_ <= focus_distance_ * kSteepest)) {
        fail(desc, "focus distance is too small for its lens");
    }
    if (!(plane_per_pixel_x_ * plane_per_pixel_y_ > 0)) fail(desc, "it sees too little: aperture over focal length");
}

double Camera::pdf_lens() const { return has_lens() ? 1 / (kPi * lens_radius_ * lens_radius_) : 1; }

Vec3 Camera::lens_point(const Vec2& u_lens) const {
    if (!has_lens()) return position_;
    const Vec2 d = sample_concentric_disk(u_lens);
    return position_ + (right_ * d.x + up_ * d.y) * lens_radius_;
}

CameraRay Camera::generate_ray(const Vec2& raster, const Vec2& u_lens) const {
    const double x = plane_left_ + raster.x * plane_per_pixel_x_;
    const double y = plane_top_ - raster.y * plane_per_pixel_y_;
    CameraRay ray;
    if (orthographic_) {
        ray.origin = position_ + right_ * x + up_ * y;
        ray.direction = forward_;
    } else {
        const Vec3 focus = (forward_ + right_ * x + up_ * y) * focus_distance_;  // relative to the lens centre
        ray.origin = lens_point(u_lens);
        ray.direction = normalize(focus - (ray.origin - position_));
    }
    ray.weight = exposure_scale_;
    ray.pdf_lens = pdf_lens();
    ray.pdf_dir = pdf_dir(ray.origin, ray.direction);
    return ray;
}

double Camera::pdf_dir(const Vec3&, const Vec3& direction) const {
    // Raster area is area on the plane in focus, and a solid angle cuts D^2 dw / cos^3 out of a plane at distance D,
    // from whichever point of the lens; the plane at distance 1 is D^2 times smaller.
    const double cos = dot(direction, forward_);
    if (cos <= 0) return 0;
    if (orthographic_) return 1 / (plane_per_pixel_x_ * plane_per_pixel_y_);
    return 1 / (cos * cos * cos * plane_per_pixel_x_ * plane_per_pixel_y_);
}

Vec2 Camera::raster_of(const Vec3& z0, const Vec3& direction) const {
    Vec3 on_plane = z0 - position_;
    if (!orthographic_) on_plane = on_plane / focus_distance_ + direction / dot(direction, forward_);
    return {(dot(on_plane, right_) - plane_left_) / plane_per_pixel_x_,
            (plane_top_ - dot(on_plane, up_)) / plane_per_pixel_y_};
}

std::optional<LensSample> Camera::sample_lens(const Vec3& p, const Vec2& u_lens) const {
    if (depth(p) <= 0) return {};
    if (orthographic_) return sample_plane(p);
    const Vec3 origin = lens_point(u_lens);
    const Vec3 d = p - origin;
    const double distance = length(d);
    std::optional<LensSample> sample = lens_sample(origin, d / distance);
    if (!sample) return {};  // rounding, for points almost on the lens
    sample->distance = distance;
    sample->weight /= distance * distance;
    return sample;
}

std::optional<LensSample> Camera::sample_plane(const Vec3& p) const {
    std::optional<LensSample> sample = lens_sample(p - forward_ * depth(p), forward_);
    sample->distance = depth(p);
    return sample;
}

std::optional<LensSample> Camera::sample_lens_towards(const Vec3& direction, const Vec2& u_lens) const {
    if (orthographic_) return {};
    return lens_sample(lens_point(u_lens), direction);
}

std::optional<LensSample> Camera::lens_sample(const Vec3& origin, const Vec3& direction) const {
    if (dot(direction, forward_) <= 0) return {};
    LensSample sample;
    sample.origin = origin;
    sample.direction = direction;
    sample.distance = kInfinity;
    sample.raster = raster_of(origin, direction);
    sample.pdf_lens = pdf_lens();
    sample.pdf_dir = pdf_dir(origin, direction);
    // We |cos| = scale pdf_lens pdf_dir, so that a camera ray weighs the exposure scale.
    sample.weight = exposure_scale_ * sample.pdf_dir;
    return sample;
}

std::optional<LensHit> Camera::hit_lens(const Vec3& origin, const Vec3& direction, double t_max) const {
    const double cos = -dot(direction, forward_);
    if (!has_lens() || cos <= 0) return {};
    const double t = depth(origin) / cos;
    if (t <= 0 || t >= t_max) return {};
    LensHit hit;
    hit.p = origin + direction * t;
    if (length_squared(hit.p - position_) > lens_radius_ * lens_radius_) return {};
    hit.distance = t;
    hit.raster = raster_of(hit.p, -direction);
    hit.pdf_lens = pdf_lens();
    hit.pdf_dir = pdf_dir(hit.p, -direction);
    hit.importance = exposure_scale_ * hit.pdf_lens * hit.pdf_dir / cos;
    return hit;
}

}  // namespace etendue
