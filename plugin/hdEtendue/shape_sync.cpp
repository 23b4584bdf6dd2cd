#include "shape_sync.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <pxr/base/vt/array.h>
#include <pxr/imaging/hd/changeTracker.h>
#include <pxr/imaging/hd/renderIndex.h>
#include <pxr/imaging/hd/tokens.h>

#include "convert.h"
#include "instancer.h"

namespace etendue::hydra {
namespace {

const VtValue* find(const std::map<TfToken, PrimvarValue>& primvars, const TfToken& name) {
    const auto found = primvars.find(name);
    return found == primvars.end() ? nullptr : &found->second.value;
}

std::vector<double> opacities(const VtValue& value) {
    if (!value.IsHolding<VtFloatArray>()) return numbers(value);
    const VtFloatArray& array = value.UncheckedGet<VtFloatArray>();
    return {array.cbegin(), array.cend()};
}

std::optional<Color> mean_color(Warnings& warnings, const SdfPath& path, const VtValue& value) {
    const std::vector<Float3> colors = vectors<3>(value);
    if (colors.empty()) return std::nullopt;
    if (std::any_of(colors.begin(), colors.end(), [&](const Float3& color) { return color != colors.front(); })) {
        warnings.warn("varying displayColor", path, "displayColor varies over the surface; its mean is rendered");
    }
    Color mean{};
    for (const Float3& color : colors) {
        for (std::size_t i = 0; i < 3; ++i) mean[i] += color[i] / static_cast<double>(colors.size());
    }
    return mean;
}

double mean_opacity(Warnings& warnings, const SdfPath& path, const VtValue& value) {
    const std::vector<double> all = opacities(value);
    if (all.empty()) return 1;
    if (std::any_of(all.begin(), all.end(), [&](double opacity) { return opacity != all.front(); })) {
        warnings.warn("varying displayOpacity", path, "displayOpacity varies over the surface; its mean is rendered");
    }
    double sum = 0;
    for (const double opacity : all) sum += opacity;
    return std::clamp(sum / static_cast<double>(all.size()), 0.0, 1.0);
}

}  // namespace

void sync_shape(HdSceneDelegate& delegate, HdRprim& rprim, HdDirtyBits bits, ShapeRecord& record) {
    const SdfPath& path = rprim.GetId();
    record.prim_id = rprim.GetPrimId();
    if (HdChangeTracker::IsTransformDirty(bits, path)) record.transform = delegate.GetTransform(path);
    if (bits & HdChangeTracker::DirtyMaterialId) {
        rprim.SetMaterialId(delegate.GetMaterialId(path));
        record.material = rprim.GetMaterialId();
    }
    record.visible = rprim.IsVisible();
    record.render_tag = rprim.GetRenderTag();
    record.instanced = !rprim.GetInstancerId().IsEmpty();
    if (record.instanced && (bits & (HdChangeTracker::DirtyInstancer | HdChangeTracker::DirtyInstanceIndex |
                                     HdChangeTracker::DirtyTransform | HdChangeTracker::DirtyPrimvar))) {
        HdInstancer::_SyncInstancerAndParents(delegate.GetRenderIndex(), rprim.GetInstancerId());
        record.instances = instance_transforms(delegate.GetRenderIndex(), rprim.GetInstancerId(), path);
    }
}

void sync_display(Warnings& warnings, const SdfPath& path, const std::map<TfToken, PrimvarValue>& primvars,
                  ShapeRecord& record) {
    const VtValue* const color = find(primvars, HdTokens->displayColor);
    const VtValue* const opacity = find(primvars, HdTokens->displayOpacity);
    record.display_color = color == nullptr ? std::nullopt : mean_color(warnings, path, *color);
    record.display_opacity = opacity == nullptr ? 1 : mean_opacity(warnings, path, *opacity);
}

}  // namespace etendue::hydra
