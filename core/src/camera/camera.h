#pragma once

#include <optional>

#include <etendue/scene_description.h>

#include "math/transform.h"
#include "math/vec.h"

namespace etendue {

/// The first ray of a camera subpath.
struct CameraRay {
    Vec3 origin;          ///< z0, on the lens
    Vec3 direction;       ///< unit, into the scene
    double weight = 1;    ///< We |cos| / (pdf_lens pdf_dir): the exposure scale
    double pdf_lens = 1;  ///< per area; 1 for a pinhole
    /// For a raster density of one sample per pixel area: per solid angle; of an orthographic camera, whose direction
    /// is no choice, per area perpendicular to it.
    double pdf_dir = 0;
};

/// A point on the lens joined to a point of the scene (strategies t = 1).
struct LensSample {
    Vec3 origin;     ///< z0
    Vec3 direction;  ///< unit, from z0 to the point
    double distance = 0;
    Vec2 raster;        ///< continuous pixel coordinates, y down; may lie outside the image
    double weight = 0;  ///< We |cos z0| / (d^2 pdf_lens), without d^2 for an orthographic camera
    double pdf_lens = 1;
    double pdf_dir = 0;  ///< as CameraRay::pdf_dir
};

/// A light path that found the lens (strategies t = 0).
struct LensHit {
    Vec3 p;
    double distance = 0;
    Vec2 raster;
    double importance = 0;  ///< We(z0 -> towards where the light came from), without cosine
    double pdf_lens = 0;
    double pdf_dir = 0;
};

/// Whether the camera has a lens of finite size: light can find it, and things out of focus blur.
[[nodiscard]] bool has_lens(const CameraDesc& desc);

/// Pinhole, thin-lens or orthographic camera. An orthographic one is the counterpart of a distant light without extent:
/// its rays have one direction, and a point of the scene is seen from one point of its plane. Joining points to it
/// (t = 1) works as for a pinhole, with areas perpendicular to the direction in place of solid angles. Light from
/// infinity joins to it with probability zero, and light never finds it by chance (t = 0).
/// We is normalised per pixel: the mean radiance over a pixel's filter is the
/// pixel's value, times the exposure scale. pdf_dir and We extend beyond the image's edge, for filters that reach
/// across it.
class Camera {
public:
    /// Gives UsdGeomCamera its meaning: apertures, offsets, conform policy, tenths of units. Scale, shear and mirroring
    /// of the transform do not count. An f-stop without a focus distance makes a pinhole; orthographic cameras heed
    /// neither, nor the focal length. Throws SceneError or SettingsError naming the camera.
    Camera(const CameraDesc& desc, int width, int height, ApertureConform conform);

    [[nodiscard]] CameraRay generate_ray(const Vec2& raster, const Vec2& u_lens) const;
    /// Empty when `p` is behind the lens, or the orthographic camera's plane.
    [[nodiscard]] std::optional<LensSample> sample_lens(const Vec3& p, const Vec2& u_lens) const;
    /// The same for something infinitely far along the unit `direction`: the distance is infinite and the weight
    /// We |cos z0| / pdf_lens. Empty for an orthographic camera.
    [[nodiscard]] std::optional<LensSample> sample_lens_towards(const Vec3& direction, const Vec2& u_lens) const;
    /// Density with which the camera sends a ray from z0 along `direction`, as CameraRay::pdf_dir; 0 backwards.
    [[nodiscard]] double pdf_dir(const Vec3& z0, const Vec3& direction) const;
    /// Where a ray from `origin` along the unit `direction` crosses the lens from the front, nearer than t_max. Empty
    /// without a lens.
    [[nodiscard]] std::optional<LensHit> hit_lens(const Vec3& origin, const Vec3& direction, double t_max) const;

    /// Moves the camera.
    void stand_at(const Vec3& position) { position_ = position; }

    [[nodiscard]] bool has_lens() const { return lens_radius_ > 0; }
    [[nodiscard]] bool orthographic() const { return orthographic_; }
    [[nodiscard]] const Vec3& forward() const { return forward_; }
    /// Centre of the lens.
    [[nodiscard]] const Vec3& position() const { return position_; }
    /// Distance along the viewing axis.
    [[nodiscard]] double depth(const Vec3& p) const { return dot(p - position_, forward_); }

private:
    /// What Embree could not trace.
    void check_reach(const CameraDesc& desc, int width, int height) const;
    /// Continuous pixel coordinates of the ray z0 + t direction.
    [[nodiscard]] Vec2 raster_of(const Vec3& z0, const Vec3& direction) const;
    /// The point of the orthographic camera's plane that sees p.
    [[nodiscard]] std::optional<LensSample> sample_plane(const Vec3& p) const;
    [[nodiscard]] Vec3 lens_point(const Vec2& u_lens) const;
    /// A sample at infinity; empty backwards.
    [[nodiscard]] std::optional<LensSample> lens_sample(const Vec3& origin, const Vec3& direction) const;
    [[nodiscard]] double pdf_lens() const;  ///< per area; 1 for a pinhole

    Vec3 position_;
    Vec3 right_;
    Vec3 up_;
    Vec3 forward_;
    double lens_radius_ = 0;     ///< scene units
    double focus_distance_ = 1;  ///< scene units, along the axis
    double exposure_scale_ = 1;
    bool orthographic_ = false;
    double plane_left_ = 0;  ///< image window on the plane at distance 1; of an orthographic camera in scene units
    double plane_top_ = 0;
    double plane_per_pixel_x_ = 0;
    double plane_per_pixel_y_ = 0;
};

}  // namespace etendue
