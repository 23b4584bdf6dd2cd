#pragma once

#include <array>
#include <string>
#include <vector>

#include <etendue/scene_description.h>

#include <pxr/base/gf/matrix4d.h>
#include <pxr/base/tf/token.h>
#include <pxr/base/vt/value.h>

#include "usd.h"

namespace etendue::hydra {

/// For column vectors: USD's matrices are for row vectors.
[[nodiscard]] Matrix4 column_matrix(const GfMatrix4d& matrix);

/// The components of a bool, number or vector of numbers, of any of USD's precisions; empty for everything else.
[[nodiscard]] std::vector<double> numbers(const VtValue& value);

/// The first of numbers(), or the fallback.
[[nodiscard]] double number_or(const VtValue& value, double fallback);

/// The first three of numbers(), a single one thrice, or the fallback.
[[nodiscard]] Color color_or(const VtValue& value, const Color& fallback);

/// The text of a token, string or number, else empty.
[[nodiscard]] std::string text(const VtValue& value);

/// Values of an array of vectors, or of a single one, with N components at least; empty for everything else. Excess
/// components are dropped.
template <std::size_t N>
[[nodiscard]] std::vector<std::array<float, N>> vectors(const VtValue& value);

}  // namespace etendue::hydra
