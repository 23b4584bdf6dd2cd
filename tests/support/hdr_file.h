#pragma once

#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

#include "math/rgb.h"

namespace etendue::test {

/// Writes a Radiance picture, uncompressed; `texel` is asked row by row from the top. Of each texel the eight highest
/// bits of its brightest channel are kept, of the others the same bits.
inline void write_hdr(const std::string& file, int width, int height, const std::function<Rgb(int, int)>& texel) {
    std::ofstream out(file, std::ios::binary);
    out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " << height << " +X " << width << "\n";
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Rgb color = texel(x, y);
            int exponent = 0;
            (void)std::frexp(max_component(color), &exponent);
            const double scale = std::ldexp(256, -exponent);
            for (const double channel : {color.r * scale, color.g * scale, color.b * scale}) {
                out.put(static_cast<char>(static_cast<std::uint8_t>(channel)));
            }
            out.put(static_cast<char>(static_cast<std::uint8_t>(exponent + 128)));
        }
    }
    if (!out) throw std::runtime_error("cannot write " + file);
}

}  // namespace etendue::test
