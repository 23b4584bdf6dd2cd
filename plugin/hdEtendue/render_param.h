#pragma once

#include <pxr/imaging/hd/renderDelegate.h>

#include "renderers.h"
#include "scene_store.h"
#include "warnings.h"

namespace etendue::hydra {

/// What prims see of the render delegate.
class RenderParam final : public HdRenderParam {
public:
    explicit RenderParam(HdRenderDelegate& delegate) : delegate_(delegate) {}

    [[nodiscard]] SceneStore& store() { return store_; }
    [[nodiscard]] Warnings& warnings() { return warnings_; }
    [[nodiscard]] HdRenderDelegate& delegate() { return delegate_; }
    [[nodiscard]] Renderers& renderers() { return renderers_; }

private:
    HdRenderDelegate& delegate_;
    SceneStore store_;
    Warnings warnings_;
    Renderers renderers_;
};

[[nodiscard]] inline RenderParam& ours(HdRenderParam* param) { return *static_cast<RenderParam*>(param); }

}  // namespace etendue::hydra
