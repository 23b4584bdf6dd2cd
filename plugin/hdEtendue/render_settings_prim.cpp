#include "render_settings_prim.h"

#include "render_param.h"

namespace etendue::hydra {

void RenderSettingsPrim::_Sync(HdSceneDelegate* /*delegate*/, HdRenderParam* param, const HdDirtyBits* /*bits*/) {
    if (!IsActive()) return;
    for (const auto& [name, value] : GetNamespacedSettings()) {
        ours(param).delegate().SetRenderSetting(TfToken(name), value);
    }
}

}  // namespace etendue::hydra
