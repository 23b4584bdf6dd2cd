#include "convert.h"

#include <type_traits>

#include <pxr/base/gf/vec2d.h>
#include <pxr/base/gf/vec2f.h>
#include <pxr/base/gf/vec2h.h>
#include <pxr/base/gf/vec2i.h>
#include <pxr/base/gf/vec3d.h>
#include <pxr/base/gf/vec3f.h>
#include <pxr/base/gf/vec3h.h>
#include <pxr/base/gf/vec4d.h>
#include <pxr/base/gf/vec4f.h>
#include <pxr/base/gf/vec4h.h>
#include <pxr/base/vt/array.h>

namespace etendue::hydra {
namespace {

template <class Vector>
bool append_vector(const VtValue& value, std::vector<double>& out) {
    if (!value.IsHolding<Vector>()) return false;
    const auto& vector = value.UncheckedGet<Vector>();
    for (std::size_t i = 0; i < Vector::dimension; ++i) out.push_back(static_cast<double>(vector[i]));
    return true;
}

template <class... Vectors>
bool append_any(const VtValue& value, std::vector<double>& out) {
    return (append_vector<Vectors>(value, out) || ...);
}

template <std::size_t N, class Vector>
bool append_rows(const VtValue& value, std::vector<std::array<float, N>>& out) {
    if constexpr (Vector::dimension < N) {
        return false;
    } else {
        const auto append = [&out](const Vector& vector) {
            std::array<float, N> row{};
            for (std::size_t i = 0; i < N; ++i) row[i] = static_cast<float>(vector[i]);
            out.push_back(row);
        };
        if (value.IsHolding<VtArray<Vector>>()) {
            const auto& array = value.UncheckedGet<VtArray<Vector>>();
            out.reserve(array.size());
            for (const Vector& vector : array.AsConst()) append(vector);
            return true;
        }
        if (!value.IsHolding<Vector>()) return false;
        append(value.UncheckedGet<Vector>());
        return true;
    }
}

template <std::size_t N, class... Vectors>
bool append_any_rows(const VtValue& value, std::vector<std::array<float, N>>& out) {
    return (append_rows<N, Vectors>(value, out) || ...);
}

}  // namespace

Matrix4 column_matrix(const GfMatrix4d& matrix) {
    Matrix4 out;
    auto element = out.m.begin();
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) *element++ = matrix[column][row];
    }
    return out;
}

std::vector<double> numbers(const VtValue& value) {
    std::vector<double> out;
    if (value.IsHolding<bool>()) {
        out.push_back(value.UncheckedGet<bool>() ? 1 : 0);
    } else if (value.CanCast<double>() && !value.IsHolding<std::string>()) {
        const VtValue number = VtValue::Cast<double>(value);
        out.push_back(number.UncheckedGet<double>());
    } else {
        append_any<GfVec2f, GfVec3f, GfVec4f, GfVec2d, GfVec3d, GfVec4d, GfVec2h, GfVec3h, GfVec4h, GfVec2i>(value,
                                                                                                             out);
    }
    return out;
}

double number_or(const VtValue& value, double fallback) {
    const std::vector<double> all = numbers(value);
    return all.empty() ? fallback : all.front();
}

Color color_or(const VtValue& value, const Color& fallback) {
    const std::vector<double> all = numbers(value);
    if (all.size() >= 3) return {all[0], all[1], all[2]};
    if (all.size() == 1) return {all[0], all[0], all[0]};
    return fallback;
}

std::string text(const VtValue& value) {
    if (value.IsHolding<TfToken>()) return value.UncheckedGet<TfToken>().GetString();
    if (value.IsHolding<std::string>()) return value.UncheckedGet<std::string>();
    if (value.IsHolding<int>()) return std::to_string(value.UncheckedGet<int>());
    return {};
}

template <std::size_t N>
std::vector<std::array<float, N>> vectors(const VtValue& value) {
    std::vector<std::array<float, N>> out;
    append_any_rows<N, GfVec2f, GfVec3f, GfVec4f, GfVec2d, GfVec3d, GfVec4d, GfVec2h, GfVec3h, GfVec4h>(value, out);
    return out;
}

template std::vector<std::array<float, 2>> vectors<2>(const VtValue&);
template std::vector<std::array<float, 3>> vectors<3>(const VtValue&);

}  // namespace etendue::hydra
