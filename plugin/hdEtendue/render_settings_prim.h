#pragma once

#include <pxr/imaging/hd/renderSettings.h>

#include "usd.h"

namespace etendue::hydra {

/// A RenderSettings prim: its attributes named etendue:... set the settings of that name while the prim is active.
class RenderSettingsPrim final : public HdRenderSettings {
public:
    explicit RenderSettingsPrim(const SdfPath& path) : HdRenderSettings(path) {}

protected:
    void _Sync(HdSceneDelegate* delegate, HdRenderParam* param, const HdDirtyBits* bits) override;
};

}  // namespace etendue::hydra
