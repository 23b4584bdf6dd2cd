#include "light.h"

#include <map>

#include <pxr/base/gf/matrix4d.h>
#include <pxr/imaging/hd/sceneDelegate.h>
#include <pxr/imaging/hd/tokens.h>

#include "convert.h"
#include "light_params.h"
#include "render_param.h"

namespace etendue::hydra {
namespace {

LightKind kind_of(const TfToken& type) {
    static const std::map<TfToken, LightKind> kinds{
        {HdPrimTypeTokens->rectLight, LightKind::Rect},       {HdPrimTypeTokens->diskLight, LightKind::Disk},
        {HdPrimTypeTokens->sphereLight, LightKind::Sphere},   {HdPrimTypeTokens->cylinderLight, LightKind::Cylinder},
        {HdPrimTypeTokens->distantLight, LightKind::Distant}, {HdPrimTypeTokens->domeLight, LightKind::Dome}};
    return kinds.at(type);
}

/// What turns a dome's pole (Y) to its poleAxis.
GfMatrix4d dome_offset(const LightParams& params) {
    const VtValue offset = params.value("domeOffset");
    return offset.IsHolding<GfMatrix4d>() ? offset.UncheckedGet<GfMatrix4d>() : GfMatrix4d(1);
}

}  // namespace

const TfTokenVector& Light::types() {
    static const TfTokenVector all{HdPrimTypeTokens->rectLight,    HdPrimTypeTokens->diskLight,
                                   HdPrimTypeTokens->sphereLight,  HdPrimTypeTokens->cylinderLight,
                                   HdPrimTypeTokens->distantLight, HdPrimTypeTokens->domeLight};
    return all;
}

void Light::Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits) {
    if (*bits == Clean) return;
    RenderParam& shared = ours(param);
    const LightParams params(*delegate, shared.warnings(), GetId());
    LightRecord record;
    record.desc.name = GetId().GetString();
    record.desc.kind = kind_of(type_);
    GfMatrix4d transform = delegate->GetTransform(GetId());
    if (record.desc.kind == LightKind::Dome) transform = dome_offset(params) * transform;
    record.desc.world_from_light = column_matrix(transform);
    record.visible = delegate->GetVisible(GetId());
    params.fill_emission(record.desc);
    params.fill_size(record.desc);
    params.warn_unsupported();
    shared.store().set_light(GetId(), std::move(record));
    *bits = Clean;
}

void Light::Finalize(HdRenderParam* param) { ours(param).store().remove_light(GetId()); }

}  // namespace etendue::hydra
