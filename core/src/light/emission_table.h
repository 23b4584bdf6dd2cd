#pragma once

#include <cstddef>
#include <vector>

#include "light/emission_texture.h"
#include "math/distribution_2d.h"

namespace etendue {

/// How much a row of texels adds to the integral over its own strip of the image, and the rows next to it, of which
/// the bilinear filter mixes in up to a half there. In the measure that the strip has for the light.
struct RowWeights {
    double above = 0;
    double own = 0;
    double below = 0;
};

/// A light's image cut into cells, chosen by the exact integral of the filtered image over each: a cell is never
/// missed where any of it shines. A cell is a texel, or a square of texels in images too large for a table of all.
class EmissionTable {
public:
    /// `rows` has an entry for each row of texels, from the top. Beyond the left and right edge the image goes on from
    /// the other one when `wraps`, else its border does. Throws SceneError when a texel is not finite.
    EmissionTable(const EmissionImage& image, const std::vector<RowWeights>& rows, bool wraps);

    /// Integral of the image; columns share a row's measure equally.
    [[nodiscard]] const Rgb& integral() const { return integral_; }

    /// A rectangle of the image, [x0, x1) x [y0, y1) with y from the top, both in [0, 1].
    struct Cell {
        std::size_t column = 0;
        std::size_t row = 0;
        double x0 = 0;
        double x1 = 1;
        double y0 = 0;
        double y1 = 1;
        double pmf = 0;
    };
    struct Sample {
        Cell cell;
        Vec2 u;  ///< uniform in the unit square
    };
    /// Needs an image that is not black.
    [[nodiscard]] Sample sample(const Vec2& u) const;
    [[nodiscard]] Cell cell_at(double x, double y) const;
    [[nodiscard]] std::size_t memory_used() const { return cells_.memory_used(); }

private:
    [[nodiscard]] Cell cell(std::size_t column, std::size_t row) const;

    int width_;
    int height_;
    int texels_per_cell_;  ///< along either axis
    Distribution2d cells_;
    Rgb integral_;
};

/// Rows of an image that covers a flat area of size 1.
[[nodiscard]] std::vector<RowWeights> flat_rows(int height);

/// Rows of a latlong image that covers the sphere, by solid angle.
[[nodiscard]] std::vector<RowWeights> latlong_rows(int height);

}  // namespace etendue
