#pragma once

#include <memory>

#include <pxr/imaging/hd/sceneDelegate.h>

#include "mesh_primvars.h"
#include "scene_store.h"
#include "warnings.h"

namespace etendue::hydra {

/// The mesh as the scene delegate has it; null, after a warning that names the prim and the reason, when it cannot be
/// rendered.
[[nodiscard]] std::shared_ptr<const Geometry> read_mesh_geometry(Warnings& warnings, HdSceneDelegate& delegate,
                                                                 const SdfPath& path,
                                                                 const std::map<TfToken, PrimvarValue>& primvars);

}  // namespace etendue::hydra
