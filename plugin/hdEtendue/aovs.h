#pragma once

#include <vector>

#include <pxr/base/tf/token.h>
#include <pxr/imaging/hd/aov.h>

#include <etendue/render_settings.h>

#include "render_buffer.h"
#include "renderer.h"
#include "view.h"

namespace etendue::hydra {

/// How hosts should make a buffer for the AOV; an invalid format for one that is not known.
[[nodiscard]] HdAovDescriptor describe_aov(const TfToken& name);

/// What core has to render for the AOV; empty when it cannot be made of what core has.
[[nodiscard]] std::vector<Aov> sources_of(const TfToken& name);

/// Whether it says which prim a pixel shows.
[[nodiscard]] bool is_identifier(const TfToken& name);

/// Writes the picture's window into the buffer. Where an AOV has no value (depth of nothing) the buffer keeps its own.
void write_aov(const TfToken& name, const RenderView& fresh, const View& view, RenderBuffer& buffer);

}  // namespace etendue::hydra
