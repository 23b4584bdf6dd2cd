#include "render_settings_prim.h"

#include <pxr/imaging/hd/renderIndex.h>
#include <pxr/imaging/hd/sceneDelegate.h>
#include <pxr/imaging/hd/utils.h>

#include "render_param.h"

namespace etendue::hydra {

void RenderSettingsPrim::_Sync(HdSceneDelegate* delegate, HdRenderParam* param, const HdDirtyBits* /*bits*/) {
    if (!is_active(*delegate)) return;
    for (const auto& [name, value] : GetNamespacedSettings()) {
        ours(param).delegate().SetRenderSetting(TfToken(name), value);
    }
}

bool RenderSettingsPrim::is_active(HdSceneDelegate& delegate) const {
    if (IsActive()) return true;
    // Hosts of 25.08 say which one it is, but do not tell the prim.
    SdfPath active;
    return HdUtils::HasActiveRenderSettingsPrim(delegate.GetRenderIndex().GetTerminalSceneIndex(), &active) &&
           active == GetId();
}

}  // namespace etendue::hydra
