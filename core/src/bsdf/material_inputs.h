#pragma once

#include <etendue/scene_description.h>

#include "math/rgb.h"
#include "math/vec.h"
#include "texture/texture_set.h"

namespace etendue {

/// A material's inputs at one point. Values outside their range are brought into it, NaN becomes its lower end.
class InputReader {
public:
    InputReader(const TextureSet& textures, const Vec2& st) : textures_(textures), st_(st) {}

    /// Colour in [0, 1].
    [[nodiscard]] Rgb reflectance(const ColorInput& input) const;
    /// Colour, 0 or more.
    [[nodiscard]] Rgb radiance(const ColorInput& input) const;
    /// Number in [0, 1].
    [[nodiscard]] double fraction(const FloatInput& input) const;
    /// Number in [0, high].
    [[nodiscard]] double number(const FloatInput& input, double high) const;
    /// GGX alpha of a perceptual roughness.
    [[nodiscard]] double alpha(const FloatInput& roughness) const;

private:
    const TextureSet& textures_;
    Vec2 st_;
};

/// An index of refraction that arithmetic can bear: authored values that make no sense become 1.5.
[[nodiscard]] double usable_ior(double ior);

}  // namespace etendue
