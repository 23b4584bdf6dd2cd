#include "mesh_topology.h"

#include <algorithm>
#include <numeric>

namespace etendue::hydra {
namespace {

/// Why the faces cannot be rendered, empty when they can.
std::string complaint(const Topology& topology, std::size_t point_count) {
    if (topology.counts.empty()) return "it has no faces";
    if (*std::min_element(topology.counts.begin(), topology.counts.end()) < 0) {
        return "a face has a negative number of corners";
    }
    const auto corners = std::accumulate(topology.counts.begin(), topology.counts.end(), std::int64_t{0});
    if (corners != static_cast<std::int64_t>(topology.indices.size())) {
        return "faceVertexCounts add up to " + std::to_string(corners) + " but there are " +
               std::to_string(topology.indices.size()) + " faceVertexIndices";
    }
    for (const std::int32_t index : topology.indices) {
        if (index < 0 || static_cast<std::size_t>(index) >= point_count) {
            return "index " + std::to_string(index) + " is out of range for " + std::to_string(point_count) + " points";
        }
    }
    return {};
}

void drop(Topology& topology, const VtIntArray& faces) {
    for (const int face : faces.AsConst()) {
        if (face >= 0 && static_cast<std::size_t>(face) < topology.kept.size()) {
            topology.kept[static_cast<std::size_t>(face)] = false;
        }
    }
}

void drop_thin_faces(Warnings& warnings, const SdfPath& path, Topology& topology) {
    for (std::size_t face = 0; face < topology.counts.size(); ++face) {
        if (topology.counts[face] >= 3) continue;
        topology.kept[face] = false;
        warnings.warn("faces of fewer than three corners", path, "faces of fewer than three corners are left out");
    }
}

}  // namespace

std::vector<std::int32_t> Topology::kept_faces() const {
    if (std::find(kept.begin(), kept.end(), false) == kept.end()) return {};
    std::vector<std::int32_t> all(counts.size());
    std::iota(all.begin(), all.end(), 0);
    return kept_of_faces(all);
}

TopologyRead read_topology(Warnings& warnings, const SdfPath& path, const HdMeshTopology& source,
                           std::size_t point_count) {
    TopologyRead read;
    Topology& topology = read.topology;
    const VtIntArray& counts = source.GetFaceVertexCounts();
    const VtIntArray& indices = source.GetFaceVertexIndices();
    topology.counts.assign(counts.cbegin(), counts.cend());
    topology.indices.assign(indices.cbegin(), indices.cend());
    topology.kept.assign(topology.counts.size(), true);
    read.reason = complaint(topology, point_count);
    if (!read.reason.empty()) return read;
    drop_thin_faces(warnings, path, topology);
    drop(topology, source.GetHoleIndices());
    drop(topology, source.GetInvisibleFaces());
    if (std::find(topology.kept.begin(), topology.kept.end(), true) == topology.kept.end()) {
        read.reason = "no face is left";
    }
    return read;
}

}  // namespace etendue::hydra
