#pragma once

#include <pxr/imaging/hd/renderSettings.h>

#include "usd.h"

namespace etendue::hydra {

/// A RenderSettings prim: while it is active, its attributes named etendue:... set the settings of that name, which
/// stay as they are when it no longer is.
class RenderSettingsPrim final : public HdRenderSettings {
public:
    explicit RenderSettingsPrim(const SdfPath& path) : HdRenderSettings(path) {}

protected:
    void _Sync(HdSceneDelegate* delegate, HdRenderParam* param, const HdDirtyBits* bits) override;

private:
    [[nodiscard]] bool is_active(HdSceneDelegate& delegate) const;
};

}  // namespace etendue::hydra
