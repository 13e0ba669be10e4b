// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "nazori/model/plate.h"

namespace nazori::model {

/// The sizes of braille.
struct BrailleSize {
  double dot_width_mm = 1.25;
  double dot_height_mm = 0.5;
  double dot_distance_mm = 2.5;   ///< of dots in a cell, from centre to centre
  double cell_distance_mm = 6.0;  ///< of neighbouring cells in a line
};

/// One cell: bit 0 is dot 1 (upper left), bit 2 dot 3 (lower left), bit 3 dot 4 (upper right), bit 5 dot 6.
using BrailleCell = std::uint8_t;

/// Text as cells: digits with the sign for numbers before them, small letters a to z, minus, decimal point
/// and blanks. Japanese, English and most other braille write digits and minus in this way; the decimal
/// point is that of Japanese braille (dot 2).
/// @return nothing where a character has no cell here.
[[nodiscard]] std::optional<std::vector<BrailleCell>> braille_cells(std::string_view text);

/// Width and height from the outer edges of the dots [mm]; of a whole cell where dots are missing.
[[nodiscard]] double braille_width_mm(std::size_t cells, const BrailleSize& size = {});
[[nodiscard]] double braille_height_mm(const BrailleSize& size = {});

/// The middles of the dots. @param lower_left  as add_braille().
[[nodiscard]] std::vector<PlatePoint> braille_dots(std::span<const BrailleCell> cells, PlatePoint lower_left,
                                                   const BrailleSize& size = {});

/// Puts dots on the plate. @param lower_left  of the box of braille_width_mm() x braille_height_mm().
void add_braille(Plate& plate, const std::vector<BrailleCell>& cells, PlatePoint lower_left,
                 const BrailleSize& size = {});

}  // namespace nazori::model
