#pragma once

#include <pxr/imaging/hd/light.h>

#include "scene_store.h"

namespace etendue::hydra {

/// A UsdLux light, attribute by attribute; core knows what they mean.
class Light final : public HdLight {
public:
    Light(const SdfPath& path, TfToken type) : HdLight(path), type_(std::move(type)) {}

    [[nodiscard]] HdDirtyBits GetInitialDirtyBitsMask() const override { return AllDirty; }
    void Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits) override;
    void Finalize(HdRenderParam* param) override;

    /// The types of prim that a Light can be.
    [[nodiscard]] static const TfTokenVector& types();

private:
    void sync_instances(HdSceneDelegate& delegate, HdDirtyBits* bits, LightRecord& record);

    TfToken type_;
};

}  // namespace etendue::hydra
