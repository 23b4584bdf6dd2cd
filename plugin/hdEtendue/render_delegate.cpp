#include "render_delegate.h"

#include <algorithm>

#include <pxr/base/tf/diagnostic.h>
#include <pxr/imaging/hd/camera.h>
#include <pxr/imaging/hd/extComputation.h>
#include <pxr/imaging/hd/resourceRegistry.h>
#include <pxr/imaging/hd/tokens.h>

#include "aovs.h"
#include "implicit.h"
#include "instancer.h"
#include "light.h"
#include "material.h"
#include "mesh.h"
#include "render_buffer.h"
#include "render_pass.h"
#include "render_settings_prim.h"
#include "settings.h"
#include "unsupported.h"

namespace etendue::hydra {
namespace {

bool contains(const TfTokenVector& types, const TfToken& type) {
    return std::find(types.begin(), types.end(), type) != types.end();
}

TfTokenVector joined(std::initializer_list<TfTokenVector> lists) {
    TfTokenVector out;
    for (const TfTokenVector& list : lists) out.insert(out.end(), list.begin(), list.end());
    return out;
}

}  // namespace

RenderDelegate::RenderDelegate(const HdRenderSettingsMap& settings)
    : HdRenderDelegate(settings),
      param_(*this),
      registry_(std::make_shared<HdResourceRegistry>()),
      descriptors_(setting_descriptors()) {
    _PopulateDefaultSettings(descriptors_);
}

const TfTokenVector& RenderDelegate::GetSupportedRprimTypes() const {
    static const TfTokenVector types = joined({{HdPrimTypeTokens->mesh}, Implicit::types(), Unsupported::types()});
    return types;
}

const TfTokenVector& RenderDelegate::GetSupportedSprimTypes() const {
    static const TfTokenVector types = joined(
        {{HdPrimTypeTokens->camera, HdPrimTypeTokens->material, HdPrimTypeTokens->extComputation}, Light::types()});
    return types;
}

const TfTokenVector& RenderDelegate::GetSupportedBprimTypes() const {
    static const TfTokenVector types{HdPrimTypeTokens->renderBuffer, HdPrimTypeTokens->renderSettings};
    return types;
}

TfTokenVector RenderDelegate::GetRenderSettingsNamespaces() const { return {TfToken("etendue")}; }

VtDictionary RenderDelegate::GetRenderStats() const {
    VtDictionary stats;
    param_.renderers().for_each([&stats](const Renderer& renderer) {
        const Renderer::Status status = renderer.status();
        stats["percentDone"] = VtValue(100 * status.progress.fraction);
        stats["numCompletedSamples"] = VtValue(static_cast<int>(status.progress.passes_done));
        stats["totalClockTime"] = VtValue(status.progress.seconds);
        stats["rays"] = VtValue(static_cast<double>(status.statistics.rays));
        stats["finished"] = VtValue(status.progress.finished);
    });
    return stats;
}

bool RenderDelegate::IsPaused() const { return param_.renderers().is_paused(); }

bool RenderDelegate::Pause() {
    param_.renderers().set_paused(true);
    return true;
}

bool RenderDelegate::Resume() {
    param_.renderers().set_paused(false);
    return true;
}

bool RenderDelegate::IsStopped() const {
    bool stopped = true;
    param_.renderers().for_each([&stopped](const Renderer& renderer) { stopped = stopped && renderer.is_finished(); });
    return stopped;
}

bool RenderDelegate::Stop(bool blocking) {
    param_.renderers().for_each([blocking](Renderer& renderer) { renderer.stop(blocking); });
    return true;
}

bool RenderDelegate::Restart() {
    param_.renderers().for_each([](Renderer& renderer) { renderer.forget(); });
    param_.store().touch();
    return true;
}

HdRenderPassSharedPtr RenderDelegate::CreateRenderPass(HdRenderIndex* index, const HdRprimCollection& collection) {
    return std::make_shared<RenderPass>(index, collection, param_);
}

HdInstancer* RenderDelegate::CreateInstancer(HdSceneDelegate* delegate, const SdfPath& path) {
    return new Instancer(delegate, path);
}

HdRprim* RenderDelegate::CreateRprim(const TfToken& type, const SdfPath& path) {
    if (type == HdPrimTypeTokens->mesh) return new Mesh(path);
    if (contains(Implicit::types(), type)) return new Implicit(path, type);
    if (contains(Unsupported::types(), type)) return new Unsupported(path, type);
    TF_CODING_ERROR("Unknown type of rprim %s", type.GetText());
    return nullptr;
}

HdSprim* RenderDelegate::CreateSprim(const TfToken& type, const SdfPath& path) {
    if (type == HdPrimTypeTokens->camera) return new HdCamera(path);
    if (type == HdPrimTypeTokens->material) return new Material(path);
    if (type == HdPrimTypeTokens->extComputation) return new HdExtComputation(path);
    if (contains(Light::types(), type)) return new Light(path, type);
    TF_CODING_ERROR("Unknown type of sprim %s", type.GetText());
    return nullptr;
}

HdSprim* RenderDelegate::CreateFallbackSprim(const TfToken& type) { return CreateSprim(type, SdfPath::EmptyPath()); }

HdBprim* RenderDelegate::CreateBprim(const TfToken& type, const SdfPath& path) {
    if (type == HdPrimTypeTokens->renderBuffer) return new RenderBuffer(path);
    if (type == HdPrimTypeTokens->renderSettings) return new RenderSettingsPrim(path);
    TF_CODING_ERROR("Unknown type of bprim %s", type.GetText());
    return nullptr;
}

HdBprim* RenderDelegate::CreateFallbackBprim(const TfToken& type) { return CreateBprim(type, SdfPath::EmptyPath()); }

TfToken RenderDelegate::GetMaterialBindingPurpose() const { return HdTokens->full; }

TfTokenVector RenderDelegate::GetMaterialRenderContexts() const { return {TfToken("mtlx"), TfToken()}; }

HdAovDescriptor RenderDelegate::GetDefaultAovDescriptor(const TfToken& name) const { return describe_aov(name); }

}  // namespace etendue::hydra
