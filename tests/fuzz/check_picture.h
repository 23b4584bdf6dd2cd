#pragma once

#include <etendue/film_view.h>

#include "fuzz/trial.h"

namespace etendue::test {

/// Throws a Finding when a pixel or a figure is not what pictures are made of: not finite, negative, an alpha beyond 1,
/// a contribution that could not be added; or when the picture is known and is another one.
void check_picture(const RenderedImage& image, const Trial& trial);

/// Throws a Finding unless both are the same bit for bit.
void check_same(const RenderedImage& a, const RenderedImage& b);

}  // namespace etendue::test
