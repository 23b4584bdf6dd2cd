#include "render_pass.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

#include <etendue/image_io.h>

#include <pxr/base/tf/diagnostic.h>
#include <pxr/imaging/hd/renderIndex.h>
#include <pxr/imaging/hd/renderPassState.h>

#include "aovs.h"
#include "render_buffer.h"
#include "settings.h"

namespace etendue::hydra {
namespace {

constexpr Aov kAllAovs[] = {Aov::Depth, Aov::Normal, Aov::Albedo, Aov::SampleCount, Aov::Variance};

RenderBuffer* buffer_of(const HdRenderPassAovBinding& binding) {
    return static_cast<RenderBuffer*>(binding.renderBuffer);
}

std::set<Aov> needed_aovs(const HdRenderPassAovBindingVector& bindings) {
    std::set<Aov> needed{Aov::Color, Aov::Alpha};
    for (const HdRenderPassAovBinding& binding : bindings) {
        const std::vector<Aov> sources = sources_of(binding.aovName);
        needed.insert(sources.begin(), sources.end());
    }
    return needed;
}

}  // namespace

RenderPass::RenderPass(HdRenderIndex* index, const HdRprimCollection& collection, RenderParam& param)
    : HdRenderPass(index, collection), param_(param) {
    param_.renderers().add(renderer_);
}

RenderPass::~RenderPass() { param_.renderers().remove(renderer_); }

void RenderPass::_Execute(const HdRenderPassStateSharedPtr& state, const TfTokenVector& render_tags) {
    const HdRenderPassAovBindingVector& bindings = state->GetAovBindings();
    Request request = read_request(*state, render_tags);
    const bool rebound = take_targets(bindings);
    if (rebound) clear(bindings);
    if (rebound || request != request_) {
        request_ = std::move(request);
        start(request_);
    }
    if (const std::optional<RenderView> fresh = renderer_.fresh_view()) {
        // Only now: until there is something to show, hosts show what was there.
        if (std::exchange(stale_, false)) clear(bindings);
        show(*fresh);
        if (renderer_.is_finished() && !renderer_.has_failed()) write(fresh->image);
    }
    converged_ = renderer_.is_finished();
    if (converged_ && std::exchange(stale_, false)) clear(bindings);
    for (const Target& target : targets_) target.buffer->set_converged(converged_);
}

bool RenderPass::take_targets(const HdRenderPassAovBindingVector& bindings) {
    std::vector<Target> targets;
    for (const HdRenderPassAovBinding& binding : bindings) {
        if (RenderBuffer* const buffer = buffer_of(binding)) {
            targets.push_back({buffer, binding.aovName, buffer->allocation()});
        }
    }
    if (targets == targets_) return false;
    targets_ = std::move(targets);
    return true;
}

RenderPass::Request RenderPass::read_request(const HdRenderPassState& state, const TfTokenVector& render_tags) const {
    Request request;
    request.scene_version = param_.store().version();
    request.settings_version = param_.delegate().GetRenderSettingsVersion();
    request.view = read_view(state);
    request.selection = {render_tags, GetRprimCollection().GetRootPaths(), GetRprimCollection().GetExcludePaths()};
    const HdRenderPassAovBindingVector& bindings = state.GetAovBindings();
    request.aovs = needed_aovs(bindings);
    request.identify = std::any_of(bindings.begin(), bindings.end(), [](const HdRenderPassAovBinding& binding) {
        return is_identifier(binding.aovName);
    });
    if (!output_file(param_.delegate()).empty()) request.aovs.insert(std::begin(kAllAovs), std::end(kAllAovs));
    return request;
}

void RenderPass::start(const Request& request) {
    stale_ = true;
    if (request.view.is_empty()) return renderer_.stop(false);
    try {
        renderer_.start(make_job(request));
    } catch (const std::exception& error) {
        renderer_.stop(false);
        TF_RUNTIME_ERROR("Etendue: %s", error.what());
    }
}

RenderJob RenderPass::make_job(const Request& request) {
    Assembled assembled = assemble(param_.store().contents(), request.selection, param_.warnings());
    assembled.scene.cameras.push_back(request.view.camera);
    RenderSettings settings = render_settings(param_.delegate());
    settings.width = request.view.width;
    settings.height = request.view.height;
    settings.crop = request.view.window;
    settings.conform = request.view.conform;
    settings.aovs.assign(request.aovs.begin(), request.aovs.end());
    return {std::move(assembled.scene), settings, std::move(assembled.prims), request.identify};
}

void RenderPass::clear(const HdRenderPassAovBindingVector& bindings) const {
    for (const HdRenderPassAovBinding& binding : bindings) {
        if (RenderBuffer* const buffer = buffer_of(binding)) buffer->clear(binding.clearValue);
    }
}

void RenderPass::show(const RenderView& fresh) const {
    for (const Target& target : targets_) write_aov(target.aov, fresh, request_.view, *target.buffer);
}

void RenderPass::write(const RenderedImage& image) const {
    const std::string file = output_file(param_.delegate());
    if (file.empty()) return;
    try {
        write_exr(file, image, {{"software", "Etendue"}});
    } catch (const std::exception& error) {
        TF_RUNTIME_ERROR("Etendue: %s", error.what());
    }
}

}  // namespace etendue::hydra
