#pragma once

#include "light/emission_texture.h"
#include "texture/texture_set.h"

namespace etendue {

/// One of the scene's textures as the image of a light. Texels outside the gamut count as black there: no light is
/// negative.
class TextureImage final : public EmissionImage {
public:
    TextureImage(const TextureSet& textures, int texture)
        : textures_(textures), texture_(texture), resolution_(textures.resolution(texture)) {}

    [[nodiscard]] Rgb at(const Vec2& st) const override { return emission(textures_.lookup(texture_, st.x, st.y)); }
    [[nodiscard]] Rgb texel(int x, int y) const override { return emission(textures_.texel(texture_, x, y)); }
    [[nodiscard]] int width() const override { return resolution_.width; }
    [[nodiscard]] int height() const override { return resolution_.height; }

private:
    static Rgb emission(const TextureSet::Value& value) {
        // Not std::max: a texel that is no number must stay one, to be found.
        const auto positive = [](double x) { return x < 0 ? 0 : x; };
        return {positive(value[0]), positive(value[1]), positive(value[2])};
    }

    const TextureSet& textures_;
    int texture_;
    TextureSet::Resolution resolution_;
};

}  // namespace etendue
