#pragma once

#include "math/rgb.h"
#include "math/vec.h"

namespace etendue {

/// What varies the emission over a surface; a light multiplies it by its own radiance. Must not be negative.
class EmissionTexture {
public:
    virtual ~EmissionTexture() = default;
    [[nodiscard]] virtual Rgb at(const Vec2& st) const = 0;
};

/// The same as texels, bilinearly filtered. st = (0, 0) is the lower left corner; texel (0, 0) the upper left one.
class EmissionImage : public EmissionTexture {
public:
    [[nodiscard]] virtual int width() const = 0;
    [[nodiscard]] virtual int height() const = 0;
    /// Exactly that texel, as no st could ask for it.
    [[nodiscard]] virtual Rgb texel(int x, int y) const = 0;
};

}  // namespace etendue
