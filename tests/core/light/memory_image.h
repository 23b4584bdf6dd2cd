#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "light/emission_texture.h"

namespace etendue::test {

/// Texels, row by row from the top, bilinearly filtered.
class MemoryImage final : public EmissionImage {
public:
    MemoryImage(int width, int height, bool wraps) : width_(width), height_(height), wraps_(wraps) {
        texels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    }

    [[nodiscard]] Rgb& texel(int x, int y) { return texels_[index(x, y)]; }
    [[nodiscard]] Rgb texel(int x, int y) const override { return texels_[index(x, y)]; }
    [[nodiscard]] int width() const override { return width_; }
    [[nodiscard]] int height() const override { return height_; }
    [[nodiscard]] Rgb at(const Vec2& st) const override {
        const double x = st.x * width_ - 0.5;
        const double y = (1 - st.y) * height_ - 0.5;
        const double fx = x - std::floor(x);
        const double fy = y - std::floor(y);
        const auto x0 = static_cast<int>(std::floor(x));
        const auto y0 = static_cast<int>(std::floor(y));
        return lerp(fy, lerp(fx, at_texel(x0, y0), at_texel(x0 + 1, y0)),
                    lerp(fx, at_texel(x0, y0 + 1), at_texel(x0 + 1, y0 + 1)));
    }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] Rgb at_texel(int x, int y) const {
        const int column = wraps_ ? (x + width_) % width_ : std::clamp(x, 0, width_ - 1);
        return texels_[index(column, std::clamp(y, 0, height_ - 1))];
    }

    int width_;
    int height_;
    bool wraps_;
    std::vector<Rgb> texels_;
};

/// Dim, coloured texels of every brightness; no two alike.
inline MemoryImage mottled_image(int width, int height, bool wraps) {
    MemoryImage image(width, height, wraps);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double v = 0.1 + 0.9 * std::fmod(0.618 * x + 0.377 * y, 1.0);
            image.texel(x, y) = {v, 0.7 * v + 0.1, 1.2 - v};
        }
    }
    return image;
}

/// The same with a bright texel of its own colour, and black ones all about another. At least 5 x 5 texels.
inline MemoryImage sunny_image(int width, int height, bool wraps) {
    MemoryImage image = mottled_image(width, height, wraps);
    image.texel(width / 4, height / 3) = {900, 700, 400};
    for (int y = height / 2; y < height / 2 + 3; ++y) {
        for (int x = width / 2; x < width / 2 + 3; ++x) image.texel(x, y) = Rgb();
    }
    return image;
}

}  // namespace etendue::test
