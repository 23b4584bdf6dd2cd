#pragma once

#include <map>

#include <pxr/imaging/hd/rprim.h>
#include <pxr/imaging/hd/sceneDelegate.h>

#include "mesh_primvars.h"
#include "scene_store.h"

namespace etendue::hydra {

/// Takes over what all shapes have in common and `bits` say has changed: transform, visibility, purpose, material and
/// instances. The rprim's own visibility and instancer are up to date before.
void sync_shape(HdSceneDelegate& delegate, HdRprim& rprim, HdDirtyBits bits, ShapeRecord& record);

/// displayColor and displayOpacity; a mean, after a warning, where they vary.
void sync_display(Warnings& warnings, const SdfPath& path, const std::map<TfToken, PrimvarValue>& primvars,
                  ShapeRecord& record);

}  // namespace etendue::hydra
