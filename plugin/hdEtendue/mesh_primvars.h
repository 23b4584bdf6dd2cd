#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <pxr/imaging/hd/sceneDelegate.h>

#include "mesh_topology.h"
#include "scene_store.h"

namespace etendue::hydra {

/// A primvar's value without indices, and how it lies on its prim.
struct PrimvarValue {
    VtValue value;
    HdInterpolation interpolation = HdInterpolationConstant;
    TfToken role;
};

/// All primvars of a prim but those of its instancer, by name.
[[nodiscard]] std::map<TfToken, PrimvarValue> read_primvars(HdSceneDelegate& delegate, const SdfPath& path);

/// Values for MeshDesc::normals, and theirs; empty, after a warning, when they do not fit the mesh.
struct Normals {
    std::vector<Float3> values;
    Interpolation interpolation = Interpolation::Vertex;
};
[[nodiscard]] std::optional<Normals> read_normals(Warnings& warnings, const SdfPath& path, const PrimvarValue& primvar,
                                                  const Topology& topology, std::size_t point_count);

/// All primvars that can serve as texture coordinates, by name.
[[nodiscard]] std::map<std::string, TextureCoordinates> read_coordinates(
    Warnings& warnings, const SdfPath& path, const std::map<TfToken, PrimvarValue>& primvars, const Topology& topology,
    std::size_t point_count);

/// Unit normals at the points: the area-weighted mean of the faces around each, which point where the faces do.
[[nodiscard]] std::vector<Float3> smooth_normals(const std::vector<Float3>& points, const Topology& topology,
                                                 bool left_handed);

}  // namespace etendue::hydra
