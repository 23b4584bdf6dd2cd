#include "aovs.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>

#include <pxr/base/gf/vec3d.h>
#include <pxr/base/gf/vec3f.h>
#include <pxr/base/gf/vec4f.h>
#include <pxr/imaging/hd/tokens.h>

namespace etendue::hydra {
namespace {

/// Up to four components of one pixel; `count` 0: no value.
struct Pixel {
    std::array<double, 4> components{};
    std::size_t count = 0;
};
using Source = std::function<Pixel(std::size_t pixel)>;

struct Kind {
    HdFormat format;
    VtValue clear;
    std::vector<Aov> sources;
    /// Needs all of the sources in the image. Empty as long as there are no identifiers.
    Source (*make)(const RenderView& fresh, const View& view);
};

const float* data_of(const RenderedImage& image, Aov aov) { return image.find(aov)->data.data(); }

template <std::vector<std::int32_t> Identifiers::* Member>
Source identifier(const RenderView& fresh, const View& /*view*/) {
    if (!fresh.identifiers) return {};
    return [ids = (*fresh.identifiers.*Member).data()](std::size_t i) -> Pixel {
        return {{static_cast<double>(ids[i])}, 1};
    };
}

Source color(const RenderView& fresh, const View& /*view*/) {
    return [rgb = data_of(fresh.image, Aov::Color), alpha = data_of(fresh.image, Aov::Alpha)](std::size_t i) -> Pixel {
        return {{rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2], alpha[i]}, 4};
    };
}

template <Aov Name>
Source scalar(const RenderView& fresh, const View& /*view*/) {
    return [values = data_of(fresh.image, Name)](std::size_t i) -> Pixel { return {{values[i]}, 1}; };
}

template <Aov Name>
Source triple(const RenderView& fresh, const View& /*view*/) {
    return [rgb = data_of(fresh.image, Name)](std::size_t i) -> Pixel {
        return {{rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]}, 3};
    };
}

Source camera_depth(const RenderView& fresh, const View& /*view*/) {
    return [depth = data_of(fresh.image, Aov::Depth)](std::size_t i) -> Pixel {
        if (!std::isfinite(depth[i])) return {};
        return {{depth[i]}, 1};
    };
}

/// Window depth, 0 at the near clipping plane and 1 at the far one, which is what hosts composite with.
Source clip_depth(const RenderView& fresh, const View& view) {
    return [depth = data_of(fresh.image, Aov::Depth), projection = view.projection](std::size_t i) -> Pixel {
        if (!std::isfinite(depth[i])) return {};
        const GfVec3d clip = projection.Transform(GfVec3d(0, 0, -depth[i]));
        return {{clip[2] / 2 + 0.5}, 1};
    };
}

Pixel unit(const GfVec3f& normal) {
    const float length = normal.GetLength();
    if (length == 0) return {};
    return {{normal[0] / length, normal[1] / length, normal[2] / length}, 3};
}

Source normal(const RenderView& fresh, const View& /*view*/) {
    return
        [n = data_of(fresh.image, Aov::Normal)](std::size_t i) { return unit({n[3 * i], n[3 * i + 1], n[3 * i + 2]}); };
}

Source eye_normal(const RenderView& fresh, const View& view) {
    return [n = data_of(fresh.image, Aov::Normal), to_view = view.world_to_view](std::size_t i) {
        return unit(GfVec3f(to_view.TransformDir(GfVec3d(n[3 * i], n[3 * i + 1], n[3 * i + 2]))));
    };
}

const std::map<std::string, Kind>& kinds() {
    static const std::map<std::string, Kind> all{
        {"color", {HdFormatFloat32Vec4, VtValue(GfVec4f(0)), {Aov::Color, Aov::Alpha}, color}},
        {"depth", {HdFormatFloat32, VtValue(1.0F), {Aov::Depth}, clip_depth}},
        {"cameraDepth", {HdFormatFloat32, VtValue(0.0F), {Aov::Depth}, camera_depth}},
        {"normal", {HdFormatFloat32Vec3, VtValue(GfVec3f(0)), {Aov::Normal}, normal}},
        {"Neye", {HdFormatFloat32Vec3, VtValue(GfVec3f(0)), {Aov::Normal}, eye_normal}},
        {"albedo", {HdFormatFloat32Vec3, VtValue(GfVec3f(0)), {Aov::Albedo}, triple<Aov::Albedo>}},
        {"variance", {HdFormatFloat32Vec3, VtValue(GfVec3f(0)), {Aov::Variance}, triple<Aov::Variance>}},
        {"alpha", {HdFormatFloat32, VtValue(0.0F), {Aov::Alpha}, scalar<Aov::Alpha>}},
        {"sampleCount", {HdFormatFloat32, VtValue(0.0F), {Aov::SampleCount}, scalar<Aov::SampleCount>}},
        {"primId", {HdFormatInt32, VtValue(-1), {}, identifier<&Identifiers::prims>}},
        {"instanceId", {HdFormatInt32, VtValue(-1), {}, identifier<&Identifiers::instances>}},
        {"elementId", {HdFormatInt32, VtValue(-1), {}, identifier<&Identifiers::elements>}}};
    return all;
}

}  // namespace

bool is_identifier(const TfToken& name) {
    return name == HdAovTokens->primId || name == HdAovTokens->instanceId || name == HdAovTokens->elementId;
}

HdAovDescriptor describe_aov(const TfToken& name) {
    const auto kind = kinds().find(name.GetString());
    if (kind == kinds().end()) return {};
    return {kind->second.format, false, kind->second.clear};
}

std::vector<Aov> sources_of(const TfToken& name) {
    const auto kind = kinds().find(name.GetString());
    return kind == kinds().end() ? std::vector<Aov>{} : kind->second.sources;
}

void write_aov(const TfToken& name, const RenderView& fresh, const View& view, RenderBuffer& buffer) {
    const auto kind = kinds().find(name.GetString());
    if (kind == kinds().end()) return;
    const Source source = kind->second.make(fresh, view);
    if (!source) return;
    const RenderedImage& image = fresh.image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Pixel pixel = source(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                       static_cast<std::size_t>(x));
            if (pixel.count > 0) {
                buffer.write(view.buffer_x + x, view.buffer_y + y, pixel.components.data(), pixel.count);
            }
        }
    }
}

}  // namespace etendue::hydra
