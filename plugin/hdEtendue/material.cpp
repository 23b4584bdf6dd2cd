#include "material.h"

#include <pxr/imaging/hd/sceneDelegate.h>

#include "render_param.h"

namespace etendue::hydra {

void Material::Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits) {
    if (*bits & AllDirty) {
        HdMaterialNetwork2 network;
        const VtValue resource = delegate->GetMaterialResource(GetId());
        if (resource.IsHolding<HdMaterialNetworkMap>()) {
            network = HdConvertToHdMaterialNetwork2(resource.UncheckedGet<HdMaterialNetworkMap>());
        }
        ours(param).store().set_material(GetId(), std::move(network));
    }
    *bits = Clean;
}

void Material::Finalize(HdRenderParam* param) { ours(param).store().remove_material(GetId()); }

}  // namespace etendue::hydra
