#include "bsdf/material_inputs.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

/// NaN gives `low`.
double bring_into(double x, double low, double high) { return x > low ? std::min(x, high) : low; }

Rgb look_up(const TextureSet& textures, const ColorInput& input, const Vec2& st) {
    if (input.texture < 0) return Rgb(input.value);
    const TextureSet::Value value = textures.lookup(input.texture, st.x, st.y);
    return {value[0], value[1], value[2]};
}

}  // namespace

Rgb InputReader::reflectance(const ColorInput& input) const {
    const Rgb c = look_up(textures_, input, st_);
    return {bring_into(c.r, 0, 1), bring_into(c.g, 0, 1), bring_into(c.b, 0, 1)};
}

Rgb InputReader::radiance(const ColorInput& input) const {
    constexpr double kHuge = 1e30;
    const Rgb c = look_up(textures_, input, st_);
    return {bring_into(c.r, 0, kHuge), bring_into(c.g, 0, kHuge), bring_into(c.b, 0, kHuge)};
}

double InputReader::number(const FloatInput& input, double high) const {
    const double value =
        input.texture < 0 ? input.value : textures_.lookup_channel(input.texture, st_.x, st_.y, input.channel);
    return bring_into(value, 0, high);
}

double InputReader::fraction(const FloatInput& input) const { return number(input, 1); }

double InputReader::alpha(const FloatInput& roughness) const {
    const double r = fraction(roughness);
    return r * r;
}

double usable_ior(double ior) { return ior >= 1e-3 && ior <= 1e3 ? ior : 1.5; }

}  // namespace etendue
