#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <pxr/usd/sdf/path.h>

#include <etendue/scene_description.h>

#include "usd.h"

namespace etendue::hydra {

/// Texture coordinates as one primvar has them.
struct TextureCoordinates {
    std::vector<Float2> values;
    Interpolation interpolation = Interpolation::Vertex;

    [[nodiscard]] bool operator==(const TextureCoordinates&) const = default;
};

/// The heavy part of a shape, shared between edits that leave it alone, so that renders know it again. Which texture
/// coordinates a mesh needs, its material says, which may change later.
class Geometry {
public:
    explicit Geometry(GeometryDesc desc) : shape_(std::move(desc)) {}

    std::map<std::string, TextureCoordinates> coordinates;
    /// What MeshDesc::face_materials index; the first stands for the material of the whole prim.
    std::vector<SdfPath> subset_materials;
    /// Which of the authored faces the mesh has; empty: all.
    std::vector<std::int32_t> faces;

    /// With the coordinates of that name; none if it is not one of `coordinates`. One answer is kept, and given again
    /// to the same question. From any thread.
    [[nodiscard]] SharedGeometry with_coordinates(const std::string& name) const;
    /// With whichever coordinates.
    [[nodiscard]] SharedGeometry shape() const;
    /// `now` as the host has just told it, or `before` when that says the same: hosts tell much again that has not
    /// changed.
    [[nodiscard]] static std::shared_ptr<const Geometry> kept(std::shared_ptr<const Geometry> before,
                                                              std::shared_ptr<const Geometry> now);

private:
    [[nodiscard]] bool same_as(const Geometry& other) const;
    [[nodiscard]] std::string current_name() const;

    mutable std::mutex mutex_;
    mutable SharedGeometry shape_;
    mutable std::string has_;  ///< the name of its coordinates
};

}  // namespace etendue::hydra
