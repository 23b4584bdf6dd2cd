#include "mesh_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <pxr/imaging/hd/tokens.h>
#include <pxr/imaging/pxOsd/tokens.h>

#include "convert.h"
#include "mesh_topology.h"

namespace etendue::hydra {
namespace {

std::vector<Float3> read_points(const std::map<TfToken, PrimvarValue>& primvars) {
    const auto points = primvars.find(HdTokens->points);
    return points == primvars.end() ? std::vector<Float3>{} : vectors<3>(points->second.value);
}

/// Why the points cannot be rendered, empty when they can.
std::string complaint(const std::vector<Float3>& points) {
    if (points.empty()) return "it has no points";
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Float3& p = points[i];
        if (!std::all_of(p.begin(), p.end(), [](float v) { return std::isfinite(v); })) {
            return "point " + std::to_string(i) + " is not finite";
        }
    }
    return {};
}

void set_normals(Warnings& warnings, const SdfPath& path, const TfToken& scheme,
                 const std::map<TfToken, PrimvarValue>& primvars, const Topology& topology, MeshDesc& mesh) {
    const auto authored = primvars.find(HdTokens->normals);
    if (authored != primvars.end()) {
        if (auto normals = read_normals(warnings, path, authored->second, topology, mesh.points.size())) {
            mesh.normals = std::move(normals->values);
            mesh.normals_interpolation = normals->interpolation;
        }
    }
    if (scheme != PxOsdOpenSubdivTokens->catmullClark && scheme != PxOsdOpenSubdivTokens->loop) return;
    const std::string used = mesh.normals.empty() ? "smooth normals" : "its authored normals";
    warnings.warn("subdivision " + scheme.GetString() + " with " + used, path,
                  "subdivisionScheme '" + scheme.GetString() +
                      "' is not supported; the control cage is rendered with " + used +
                      " (author subdivisionScheme 'none' for a polygon mesh)");
    if (mesh.normals.empty()) mesh.normals = smooth_normals(mesh.points, topology, mesh.left_handed);
}

/// Fills the materials of faces from their subsets; the first of those returned stands for faces in none.
std::vector<SdfPath> set_subsets(Warnings& warnings, const HdMeshTopology& source, const Topology& topology,
                                 MeshDesc& mesh) {
    if (source.GetGeomSubsets().empty()) return {};
    std::vector<std::int32_t> faces(topology.counts.size(), 0);
    std::vector<SdfPath> materials(1);
    for (const HdGeomSubset& subset : source.GetGeomSubsets()) {
        if (subset.materialId.IsEmpty()) continue;
        const auto slot = static_cast<std::int32_t>(materials.size());
        materials.push_back(subset.materialId);
        for (const int face : subset.indices.AsConst()) {
            if (face >= 0 && static_cast<std::size_t>(face) < faces.size()) {
                faces[static_cast<std::size_t>(face)] = slot;
            } else {
                warnings.warn("subset indices " + subset.id.GetString(), subset.id,
                              "face indices out of range are ignored");
            }
        }
    }
    mesh.face_materials = topology.kept_of_faces(faces);
    return materials;
}

}  // namespace

std::shared_ptr<const Geometry> read_mesh_geometry(Warnings& warnings, HdSceneDelegate& delegate, const SdfPath& path,
                                                   const std::map<TfToken, PrimvarValue>& primvars) {
    const HdMeshTopology source = delegate.GetMeshTopology(path);
    MeshDesc mesh;
    mesh.points = read_points(primvars);
    std::string reason = complaint(mesh.points);
    TopologyRead read;
    if (reason.empty()) {
        read = read_topology(warnings, path, source, mesh.points.size());
        reason = read.reason;
    }
    if (!reason.empty()) {
        warnings.warn("unusable mesh " + path.GetString(), path, "the mesh is skipped: " + reason);
        return nullptr;
    }
    const Topology& topology = read.topology;
    mesh.face_vertex_counts = topology.kept_of_faces(topology.counts);
    mesh.face_vertex_indices = topology.kept_of_corners(topology.indices);
    mesh.left_handed = source.GetOrientation() == HdTokens->leftHanded;
    set_normals(warnings, path, source.GetScheme(), primvars, topology, mesh);
    std::vector<SdfPath> subset_materials = set_subsets(warnings, source, topology, mesh);
    auto coordinates = read_coordinates(warnings, path, primvars, topology, mesh.points.size());
    auto geometry = std::make_shared<Geometry>(std::move(mesh));
    geometry->coordinates = std::move(coordinates);
    geometry->subset_materials = std::move(subset_materials);
    geometry->faces = topology.kept_faces();
    return geometry;
}

}  // namespace etendue::hydra
