#pragma once

#include <pxr/imaging/hd/material.h>

#include "usd.h"

namespace etendue::hydra {

/// Keeps the network; it is translated where it is used, when a render starts.
class Material final : public HdMaterial {
public:
    explicit Material(const SdfPath& path) : HdMaterial(path) {}

    [[nodiscard]] HdDirtyBits GetInitialDirtyBitsMask() const override { return AllDirty; }
    void Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits) override;
    void Finalize(HdRenderParam* param) override;
};

}  // namespace etendue::hydra
