#pragma once

#include <array>
#include <string>

#include "material_network.h"

namespace etendue::hydra {

/// A primvar and the affine map applied to it, as TextureDesc::st_transform.
struct CoordinateSource {
    std::string primvar;
    std::array<double, 6> transform{1, 0, 0, 0, 1, 0};
};

/// Where the texture `node` is read: what feeds its `input`, and the tiling of the node itself.
[[nodiscard]] CoordinateSource texture_coordinates(Warnings& warnings, const NodeRef& node, const std::string& input);

}  // namespace etendue::hydra
