#include "mesh_primvars.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <pxr/base/gf/vec2d.h>
#include <pxr/base/gf/vec2f.h>
#include <pxr/base/gf/vec2h.h>
#include <pxr/base/vt/array.h>
#include <pxr/imaging/hd/extComputationUtils.h>

#include "convert.h"

namespace etendue::hydra {
namespace {

constexpr std::array kInterpolations{HdInterpolationConstant, HdInterpolationUniform, HdInterpolationVarying,
                                     HdInterpolationVertex, HdInterpolationFaceVarying};

template <class T>
struct Flat {
    std::vector<T> values;
    Interpolation interpolation = Interpolation::Vertex;
};

/// Number of values that the interpolation asks for.
std::size_t expected_count(HdInterpolation interpolation, const Topology& topology, std::size_t point_count) {
    switch (interpolation) {
        case HdInterpolationUniform:
            return topology.counts.size();
        case HdInterpolationVarying:
        case HdInterpolationVertex:
            return point_count;
        case HdInterpolationFaceVarying:
            return topology.indices.size();
        default:
            return 1;
    }
}

/// What belongs to kept faces.
template <class T>
Flat<T> on_kept_faces(const std::vector<T>& values, HdInterpolation interpolation, const Topology& topology) {
    switch (interpolation) {
        case HdInterpolationUniform:
            return {topology.kept_of_faces(values), Interpolation::Uniform};
        case HdInterpolationFaceVarying:
            return {topology.kept_of_corners(values), Interpolation::FaceVarying};
        case HdInterpolationVarying:  // on a mesh: one value per point, too
        case HdInterpolationVertex:
            return {values, Interpolation::Vertex};
        default:
            return {values, Interpolation::Constant};
    }
}

template <std::size_t N>
std::optional<Flat<std::array<float, N>>> flat(Warnings& warnings, const SdfPath& path, const std::string& name,
                                               const PrimvarValue& primvar, const Topology& topology,
                                               std::size_t point_count) {
    const auto values = vectors<N>(primvar.value);
    const std::size_t expected = expected_count(primvar.interpolation, topology, point_count);
    const auto complain = [&](const std::string& reason) {
        warnings.warn("primvar " + path.GetString() + " " + name, path, "'" + name + "' is ignored: " + reason);
    };
    if (values.size() != expected) {
        complain(std::to_string(values.size()) + " values where its interpolation needs " + std::to_string(expected));
        return std::nullopt;
    }
    const auto finite = [](const auto& row) {
        return std::all_of(row.begin(), row.end(), [](float v) { return std::isfinite(v); });
    };
    if (!std::all_of(values.begin(), values.end(), finite)) {
        complain("not all of its values are finite numbers");
        return std::nullopt;
    }
    return on_kept_faces(values, primvar.interpolation, topology);
}

bool can_be_coordinates(const PrimvarValue& primvar) {
    const VtValue& value = primvar.value;
    return primvar.role == HdPrimvarRoleTokens->textureCoordinate || value.IsHolding<VtVec2fArray>() ||
           value.IsHolding<VtVec2dArray>() || value.IsHolding<VtVec2hArray>();
}

using Vector = std::array<double, 3>;

/// Twice the vector area of a face, by Newell's sum over its edges.
Vector twice_area(const std::vector<Float3>& points, const std::int32_t* corners, std::int32_t count) {
    Vector sum{};
    for (std::int32_t i = 0; i < count; ++i) {
        const Float3& p = points[static_cast<std::size_t>(corners[i])];
        const Float3& q = points[static_cast<std::size_t>(corners[(i + 1) % count])];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = (k + 1) % 3;
            const std::size_t b = (k + 2) % 3;
            sum[k] += static_cast<double>(p[a]) * q[b] - static_cast<double>(p[b]) * q[a];
        }
    }
    return sum;
}

/// What the host computes, such as the points of a skinned mesh.
void add_computed(HdSceneDelegate& delegate, const SdfPath& path, std::map<TfToken, PrimvarValue>& primvars) {
    for (const HdInterpolation interpolation : kInterpolations) {
        const HdExtComputationPrimvarDescriptorVector descriptors =
            delegate.GetExtComputationPrimvarDescriptors(path, interpolation);
        if (descriptors.empty()) continue;
        const auto values = HdExtComputationUtils::GetComputedPrimvarValues(descriptors, &delegate);
        for (const HdExtComputationPrimvarDescriptor& descriptor : descriptors) {
            const auto value = values.find(descriptor.name);
            if (value != values.end()) primvars[descriptor.name] = {value->second, interpolation, descriptor.role};
        }
    }
}

}  // namespace

std::map<TfToken, PrimvarValue> read_primvars(HdSceneDelegate& delegate, const SdfPath& path) {
    std::map<TfToken, PrimvarValue> primvars;
    for (const HdInterpolation interpolation : kInterpolations) {
        for (const HdPrimvarDescriptor& descriptor : delegate.GetPrimvarDescriptors(path, interpolation)) {
            primvars[descriptor.name] = {delegate.Get(path, descriptor.name), interpolation, descriptor.role};
        }
    }
    add_computed(delegate, path, primvars);
    return primvars;
}

std::optional<Normals> read_normals(Warnings& warnings, const SdfPath& path, const PrimvarValue& primvar,
                                    const Topology& topology, std::size_t point_count) {
    auto values = flat<3>(warnings, path, "normals", primvar, topology, point_count);
    if (!values) return std::nullopt;
    return Normals{std::move(values->values), values->interpolation};
}

std::map<std::string, TextureCoordinates> read_coordinates(Warnings& warnings, const SdfPath& path,
                                                           const std::map<TfToken, PrimvarValue>& primvars,
                                                           const Topology& topology, std::size_t point_count) {
    std::map<std::string, TextureCoordinates> out;
    for (const auto& [name, primvar] : primvars) {
        if (!can_be_coordinates(primvar)) continue;
        auto values = flat<2>(warnings, path, name.GetString(), primvar, topology, point_count);
        if (values) out[name.GetString()] = {std::move(values->values), values->interpolation};
    }
    return out;
}

std::vector<Float3> smooth_normals(const std::vector<Float3>& points, const Topology& topology, bool left_handed) {
    std::vector<Vector> sums(points.size());
    const std::int32_t* corners = topology.indices.data();
    for (const std::int32_t count : topology.counts) {
        const Vector area = twice_area(points, corners, count);
        for (std::int32_t i = 0; i < count; ++i) {
            Vector& sum = sums[static_cast<std::size_t>(corners[i])];
            for (std::size_t k = 0; k < 3; ++k) sum[k] += area[k];
        }
        corners += count;
    }
    std::vector<Float3> normals(points.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double length = std::hypot(sums[i][0], sums[i][1], sums[i][2]) * (left_handed ? -1 : 1);
        if (length == 0) continue;
        for (std::size_t k = 0; k < 3; ++k) normals[i][k] = static_cast<float>(sums[i][k] / length);
    }
    return normals;
}

}  // namespace etendue::hydra
