#pragma once

#include <array>

#include <etendue/scene_description.h>

#include "math/vec.h"

namespace etendue {

/// Affine map of column vectors with its inverse; `b_from_a` names read target-from-source.
class Transform {
public:
    Transform() = default;
    /// Throws SceneError when the matrix is singular, not affine or not finite.
    explicit Transform(const Matrix4& matrix);

    [[nodiscard]] Vec3 point(const Vec3& p) const { return apply(m_, p) + translation_; }
    [[nodiscard]] Vec3 vector(const Vec3& v) const { return apply(m_, v); }
    /// Normals go by the inverse transpose; not normalised.
    [[nodiscard]] Vec3 normal(const Vec3& n) const { return apply_transposed(inv_, n); }
    [[nodiscard]] Vec3 inverse_point(const Vec3& p) const { return apply(inv_, p - translation_); }
    [[nodiscard]] Vec3 inverse_vector(const Vec3& v) const { return apply(inv_, v); }
    [[nodiscard]] Vec3 inverse_normal(const Vec3& n) const { return apply_transposed(m_, n); }

    [[nodiscard]] Transform inverse() const;
    [[nodiscard]] bool flips_handedness() const { return determinant_ < 0; }
    [[nodiscard]] double determinant() const { return determinant_; }
    [[nodiscard]] const Vec3& translation() const { return translation_; }
    /// Sum over |M_ij| |p_j| + |t_i|: bounds the rounding error of a transformed point, per axis.
    [[nodiscard]] Vec3 magnitude(const Vec3& p) const;
    /// Sum over |M_ij| |v_j|: the same for a vector.
    [[nodiscard]] Vec3 vector_magnitude(const Vec3& v) const;
    /// Column-major 3 x 4, as Embree takes it.
    [[nodiscard]] std::array<float, 12> to_float3x4() const;

    friend Transform operator*(const Transform& c_from_b, const Transform& b_from_a);
    [[nodiscard]] bool operator==(const Transform&) const = default;

private:
    using Rows = std::array<Vec3, 3>;
    Transform(const Rows& m, const Rows& inv, const Vec3& translation, double determinant)
        : m_(m), inv_(inv), translation_(translation), determinant_(determinant) {}
    static Vec3 apply(const Rows& m, const Vec3& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }
    static Vec3 apply_transposed(const Rows& m, const Vec3& v) { return m[0] * v.x + m[1] * v.y + m[2] * v.z; }

    Rows m_{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Rows inv_{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Vec3 translation_;
    double determinant_ = 1;
};

}  // namespace etendue
