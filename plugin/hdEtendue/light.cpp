#include "light.h"

#include <map>

#include <pxr/base/gf/matrix4d.h>
#include <pxr/imaging/hd/sceneDelegate.h>
#include <pxr/imaging/hd/tokens.h>

#include "instancer.h"
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
    record.transform = delegate->GetTransform(GetId());
    if (record.desc.kind == LightKind::Dome) record.transform = dome_offset(params) * record.transform;
    sync_instances(*delegate, bits, record);
    record.visible = delegate->GetVisible(GetId());
    params.fill_emission(record.desc);
    params.fill_size(record.desc);
    params.warn_unsupported();
    shared.store().set_light(GetId(), std::move(record));
    *bits = Clean;
}

void Light::sync_instances(HdSceneDelegate& delegate, HdDirtyBits* bits, LightRecord& record) {
    _UpdateInstancer(&delegate, bits);
    record.instanced = !GetInstancerId().IsEmpty();
    if (!record.instanced) return;
    HdRenderIndex& index = delegate.GetRenderIndex();
    HdInstancer::_SyncInstancerAndParents(index, GetInstancerId());
    record.instances = instance_transforms(index, GetInstancerId(), GetId());
}

void Light::Finalize(HdRenderParam* param) { ours(param).store().remove_light(GetId()); }

}  // namespace etendue::hydra
