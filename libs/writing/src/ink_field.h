// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "stroke_picture.h"

namespace nazori::writing {

/// Where the ink of a drawing lies and how it slants: 16 x 16 cells of 4 slants (0, 45, 90 and 135 degrees),
/// each from 0 (no ink) towards 1 (full), the slants of a cell beside each other, the cells row by row. It
/// does not depend on the number, order and direction of strokes, nor on place and size.
inline constexpr std::size_t kFieldCells = 16;
inline constexpr std::size_t kFieldSlants = 4;
inline constexpr std::size_t kFieldSize = kFieldCells * kFieldCells * kFieldSlants;
/// After the cells: how wide the drawing is for its height, how slim in either way, and how much ink it has.
inline constexpr std::size_t kFieldSums = 3;

using InkField = std::array<float, kFieldSize + kFieldSums>;

/// All numbers are finite; strokes without length leave no ink.
[[nodiscard]] InkField make_field(std::span<const FlatLine> strokes);

}  // namespace nazori::writing
