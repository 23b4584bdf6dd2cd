#pragma once

#include <string>
#include <vector>

#include <etendue/scene_description.h>

#include "math/vec.h"

namespace etendue::test {

/// Builds small scenes for tests in a few lines. Everything is in world space unless a matrix says otherwise.
class SceneBuilder {
public:
    int material(const MaterialModel& model, const Color& emission = {0, 0, 0});
    int diffuse(double reflectance);

    int shape(const GeometryDesc& geometry, int material, const Matrix4& world_from_object = {});
    /// A parallelogram whose normal is u x v.
    int quad(const Vec3& corner, const Vec3& u, const Vec3& v, int material);
    int sphere(const Vec3& center, double radius, int material);
    /// Five walls of a box about the origin, open towards +z, normals inwards: half-width 1.
    void open_box(int material);

    int light(const LightDesc& light);
    /// Shines from `center` along `direction`; normalised: `intensity` is radiance times area.
    int rect_light(const Vec3& center, const Vec3& direction, double width, double height, double intensity);

    int camera(const Vec3& from, const Vec3& to, double field_of_view_degrees);
    /// The only camera from now on; sees a square of that width.
    void orthographic(const Vec3& from, const Vec3& to, double width);
    /// Gives the last camera a lens.
    void lens(double radius, double focus_distance);

    [[nodiscard]] const SceneDescription& scene() const { return scene_; }
    SceneDescription& scene() { return scene_; }

private:
    SceneDescription scene_;
};

[[nodiscard]] Matrix4 translation(const Vec3& t);
/// Places something that looks along its -z at `from`, looking at `to`.
[[nodiscard]] Matrix4 look_at(const Vec3& from, const Vec3& to);
/// A sphere of few faces, with smooth normals at its points when `smooth`.
[[nodiscard]] MeshDesc low_polygon_sphere(int columns, int rows, bool smooth);
/// A point light: zero radius, radiant intensity `intensity` / 4.
[[nodiscard]] LightDesc point_light(const Vec3& p, double intensity);

}  // namespace etendue::test
