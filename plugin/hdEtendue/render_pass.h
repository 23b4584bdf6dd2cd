#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include <pxr/imaging/hd/renderPass.h>

#include <etendue/render_settings.h>

#include "assemble.h"
#include "render_param.h"
#include "renderer.h"
#include "view.h"

namespace etendue::hydra {

class RenderBuffer;

/// Renders in the background and copies what there is into the host's buffers whenever the host executes the pass. The
/// render reads a copy of the scene, so edits need not wait for it: the next execution starts anew.
class RenderPass final : public HdRenderPass {
public:
    RenderPass(HdRenderIndex* index, const HdRprimCollection& collection, RenderParam& param);
    ~RenderPass() override;

    [[nodiscard]] bool IsConverged() const override { return converged_; }

protected:
    void _Execute(const HdRenderPassStateSharedPtr& state, const TfTokenVector& render_tags) override;

private:
    /// All that a picture depends on.
    struct Request {
        std::uint64_t scene_version = 0;
        unsigned int settings_version = 0;
        View view;
        Selection selection;
        std::set<Aov> aovs;
        bool identify = false;

        [[nodiscard]] bool operator==(const Request&) const = default;
    };
    /// A buffer as it was when it was last written.
    struct Target {
        RenderBuffer* buffer = nullptr;
        TfToken aov;
        std::uint64_t allocation = 0;

        [[nodiscard]] bool operator==(const Target&) const = default;
    };

    [[nodiscard]] Request read_request(const HdRenderPassState& state, const TfTokenVector& render_tags) const;
    /// Whether they are other ones than last time.
    [[nodiscard]] bool take_targets(const HdRenderPassAovBindingVector& bindings);
    void start(const Request& request);
    [[nodiscard]] RenderJob make_job(const Request& request);
    void clear(const HdRenderPassAovBindingVector& bindings) const;
    void show(const RenderView& fresh) const;
    void write(const RenderedImage& image) const;

    RenderParam& param_;
    Renderer renderer_;
    Request request_;
    std::vector<Target> targets_;
    bool stale_ = false;  ///< whether the buffers show an earlier request
    bool converged_ = false;
};

}  // namespace etendue::hydra
