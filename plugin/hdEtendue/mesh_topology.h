#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <pxr/imaging/hd/meshTopology.h>

#include "usd.h"
#include "warnings.h"

namespace etendue::hydra {

/// Faces as authored, and which of them are rendered.
struct Topology {
    std::vector<std::int32_t> counts;
    std::vector<std::int32_t> indices;
    std::vector<bool> kept;  ///< per face

    /// Elements of `values` that belong to kept faces: one per face, or one per corner.
    template <class T>
    [[nodiscard]] std::vector<T> kept_of_faces(const std::vector<T>& values) const;
    template <class T>
    [[nodiscard]] std::vector<T> kept_of_corners(const std::vector<T>& values) const;
    /// The numbers of kept faces; empty when all are kept.
    [[nodiscard]] std::vector<std::int32_t> kept_faces() const;
};

/// Checks the topology against the number of points; faces of fewer than three corners, holes and invisible faces are
/// not kept. Otherwise `reason` says why the mesh cannot be rendered.
struct TopologyRead {
    Topology topology;
    std::string reason;  ///< empty when usable
};
[[nodiscard]] TopologyRead read_topology(Warnings& warnings, const SdfPath& path, const HdMeshTopology& source,
                                         std::size_t point_count);

template <class T>
std::vector<T> Topology::kept_of_faces(const std::vector<T>& values) const {
    std::vector<T> out;
    for (std::size_t face = 0; face < counts.size(); ++face) {
        if (kept[face]) out.push_back(values[face]);
    }
    return out;
}

template <class T>
std::vector<T> Topology::kept_of_corners(const std::vector<T>& values) const {
    std::vector<T> out;
    auto corner = values.begin();
    for (std::size_t face = 0; face < counts.size(); ++face) {
        const auto next = corner + counts[face];
        if (kept[face]) out.insert(out.end(), corner, next);
        corner = next;
    }
    return out;
}

}  // namespace etendue::hydra
