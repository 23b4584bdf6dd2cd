#pragma once

namespace etendue {

/// What a point of the picture shows, by the description that the session was made of.
struct PickedSurface {
    int shape = -1;     ///< index into SceneDescription::shapes, or of an instance into its group's; -1: a light
    int instance = -1;  ///< index into SceneDescription::instances; -1: none
    /// A mesh's faces are cut into triangles in their order, n corners into n - 2. 0 on an exact surface.
    int triangle = 0;
};

}  // namespace etendue
