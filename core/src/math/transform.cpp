#include "math/transform.h"

#include <cmath>
#include <limits>

#include <etendue/error.h>

namespace etendue {

Transform::Transform(const Matrix4& matrix) {
    const auto& m = matrix.m;
    for (double value : m) {
        if (!std::isfinite(value)) throw SceneError("transform is not finite");
    }
    const double w = 1 / m[15];
    if (m[12] != 0 || m[13] != 0 || m[14] != 0 || !std::isfinite(w)) throw SceneError("transform is not affine");
    m_ = {Vec3{m[0], m[1], m[2]} * w, Vec3{m[4], m[5], m[6]} * w, Vec3{m[8], m[9], m[10]} * w};
    translation_ = Vec3{m[3], m[7], m[11]} * w;
    // Columns of the inverse are cross products of the rows over the determinant.
    const Vec3 c0 = cross(m_[1], m_[2]);
    const Vec3 c1 = cross(m_[2], m_[0]);
    const Vec3 c2 = cross(m_[0], m_[1]);
    determinant_ = dot(m_[0], c0);
    // A matrix that flattens space has a determinant of rounding errors, not of 0, unless it does so along an axis.
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * length(m_[0]) * length(m_[1]) * length(m_[2]);
    if (!(std::abs(determinant_) > rounding) || !std::isfinite(determinant_) || !std::isfinite(1 / determinant_)) {
        throw SceneError("transform is singular");
    }
    const double d = 1 / determinant_;
    inv_ = {Vec3{c0.x, c1.x, c2.x} * d, Vec3{c0.y, c1.y, c2.y} * d, Vec3{c0.z, c1.z, c2.z} * d};
    // Normals go by the inverse, and what it makes of them must have a length.
    if (!std::isfinite(length(inv_[0]) + length(inv_[1]) + length(inv_[2]))) throw SceneError("transform is singular");
}

Transform Transform::inverse() const { return {inv_, m_, -apply(inv_, translation_), 1 / determinant_}; }

Vec3 Transform::magnitude(const Vec3& p) const { return vector_magnitude(p) + abs(translation_); }

Vec3 Transform::vector_magnitude(const Vec3& v) const {
    const Vec3 a = abs(v);
    return {dot(abs(m_[0]), a), dot(abs(m_[1]), a), dot(abs(m_[2]), a)};
}

std::array<float, 12> Transform::to_float3x4() const {
    std::array<float, 12> out{};
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            out[static_cast<std::size_t>(column * 3 + row)] =
                static_cast<float>(m_[static_cast<std::size_t>(row)][column]);
        }
    }
    for (int row = 0; row < 3; ++row) out[static_cast<std::size_t>(9 + row)] = static_cast<float>(translation_[row]);
    return out;
}

Transform operator*(const Transform& c_from_b, const Transform& b_from_a) {
    const auto rows_times = [](const Transform::Rows& a, const Transform::Rows& b) {
        const auto row = [&b](const Vec3& r) { return b[0] * r.x + b[1] * r.y + b[2] * r.z; };
        return Transform::Rows{row(a[0]), row(a[1]), row(a[2])};
    };
    return {rows_times(c_from_b.m_, b_from_a.m_), rows_times(b_from_a.inv_, c_from_b.inv_),
            c_from_b.point(b_from_a.translation_), c_from_b.determinant_ * b_from_a.determinant_};
}

bool is_placement(const Matrix4& matrix) {
    try {
        const Transform checked(matrix);
        return true;
    } catch (const SceneError&) {
        return false;
    }
}

}  // namespace etendue
