#pragma once

#include <pxr/base/vt/types.h>
#include <pxr/imaging/hd/instancer.h>
#include <pxr/imaging/hd/renderIndex.h>
#include <pxr/imaging/hd/sceneDelegate.h>

#include "usd.h"

namespace etendue::hydra {

/// Copies of prototypes, which may themselves be instanced.
class Instancer final : public HdInstancer {
public:
    Instancer(HdSceneDelegate* delegate, const SdfPath& path) : HdInstancer(delegate, path) {}

    void Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits) override;

    /// World from the prototype's own world, per instance of `prototype`, those of the parents multiplied out.
    [[nodiscard]] VtMatrix4dArray transforms(const SdfPath& prototype);
};

/// transforms() of the instancer at `path`; empty when there is none.
[[nodiscard]] VtMatrix4dArray instance_transforms(HdRenderIndex& index, const SdfPath& path, const SdfPath& prototype);

}  // namespace etendue::hydra
