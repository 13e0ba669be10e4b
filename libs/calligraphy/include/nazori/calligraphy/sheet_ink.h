// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nazori/calligraphy/ruling.h"
#include "nazori/paint/sheet.h"

namespace nazori::calligraphy {

/// Which cells of a sheet have ink, or belong to strokes. Row 0 is at the top.
struct SheetInk {
  int size = 0;                     ///< cells a side
  std::vector<std::uint8_t> cells;  ///< 1: ink; row by row

  [[nodiscard]] double cell_m() const { return paint::Sheet::kSide_m / size; }
  [[nodiscard]] bool has(int column, int row) const {
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                 static_cast<std::size_t>(column)] != 0;
  }
  /// The middle of a cell.
  [[nodiscard]] geometry::PaperPoint place(int column, int row) const {
    return {(column + 0.5) * cell_m() - paint::Sheet::kSide_m / 2,
            paint::Sheet::kSide_m / 2 - (row + 0.5) * cell_m()};
  }
};

/// The cells with enough pigment, of whatever layer, to be seen.
[[nodiscard]] SheetInk ink_on(const paint::Sheet& sheet);
/// The cells whose middle lies in strokes. @param size  cells a side. @param wider_m  the strokes are
/// broader to each side by this.
[[nodiscard]] SheetInk ink_of(std::span<const ModelStroke> strokes, int size, double wider_m = 0);

}  // namespace nazori::calligraphy
