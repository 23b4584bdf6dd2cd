#pragma once

#include <pxr/imaging/hd/rprimCollection.h>

#include <etendue/scene_description.h>

#include "identifiers.h"
#include "scene_store.h"
#include "warnings.h"

namespace etendue::hydra {

/// Which shapes a render pass shows.
struct Selection {
    TfTokenVector render_tags;  ///< empty: all
    SdfPathVector roots;
    SdfPathVector excluded;

    [[nodiscard]] bool includes(const SdfPath& path, const TfToken& render_tag) const;
    [[nodiscard]] bool operator==(const Selection&) const = default;
};

struct Assembled {
    SceneDescription scene;  ///< without a camera
    PrimTable prims;
};

/// In the order of paths, so that equal contents give equal scenes.
[[nodiscard]] Assembled assemble(const SceneStore::Contents& contents, const Selection& selection, Warnings& warnings);

}  // namespace etendue::hydra
