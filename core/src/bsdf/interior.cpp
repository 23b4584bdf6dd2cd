#include "bsdf/interior.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace etendue {
namespace {

double coefficient(double color, double depth) {
    return -std::log(std::clamp(color, std::numeric_limits<double>::min(), 1.0)) / depth;
}

Rgb absorption(const ColorInput& color, double depth) {
    if (!colors_the_inside(color, depth)) return {};
    return {coefficient(color.value[0], depth), coefficient(color.value[1], depth), coefficient(color.value[2], depth)};
}

bool is_all(const FloatInput& input) { return input.texture < 0 && input.value >= 1; }

template <typename Opaque>
std::optional<Rgb> interior(const Opaque&) {
    return {};
}

std::optional<Rgb> interior(const DielectricMaterial& m) {
    if (m.thin_walled) return {};
    return absorption(m.transmission_tint, m.transmission_depth);
}

std::optional<Rgb> interior(const OpenPbrMaterial& m) {
    if (m.transmission_weight.texture < 0 && !(m.transmission_weight.value > 0)) return {};
    if (m.geometry_thin_walled || is_all(m.base_metalness)) return {};
    return absorption(m.transmission_color, m.transmission_depth);
}

/// What is cut out, or only partly there, is no body.
std::optional<Rgb> interior(const PreviewSurfaceMaterial& m) {
    if (m.opacity_threshold > 0 || m.opacity_mode == PreviewOpacityMode::Presence) return {};
    if (is_all(m.opacity) || (!m.use_specular_workflow && is_all(m.metallic))) return {};
    return Rgb();
}

}  // namespace

std::optional<Rgb> interior_absorption(const MaterialDesc& material) {
    return std::visit([](const auto& model) { return interior(model); }, material.model);
}

}  // namespace etendue
