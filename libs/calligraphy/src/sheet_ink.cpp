// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/sheet_ink.h"

#include <algorithm>
#include <cmath>

#include "stroke_field.h"

namespace nazori::calligraphy {
namespace {

constexpr paint::Amount kVisible = paint::kOne / 12;

}  // namespace

SheetInk ink_on(const paint::Sheet& sheet) {
  SheetInk ink{sheet.size(), {}};
  ink.cells.reserve(static_cast<std::size_t>(ink.size) * static_cast<std::size_t>(ink.size));
  for (int row = 0; row < ink.size; ++row) {
    for (int column = 0; column < ink.size; ++column) {
      const paint::Cell cell = sheet.at(column, row);
      paint::TotalAmount pigment = cell.covered;
      for (std::size_t k = 0; k < paint::kSlots; ++k)
        pigment += paint::TotalAmount{cell.moving[k]} + cell.fixed[k];
      ink.cells.push_back(pigment >= kVisible ? 1 : 0);
    }
  }
  return ink;
}

SheetInk ink_of(std::span<const ModelStroke> strokes, int size, double wider_m) {
  SheetInk ink{size, {}};
  ink.cells.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0);
  for (ModelStroke stroke : strokes) {
    if (stroke.points.empty()) continue;
    for (double& r : stroke.half_width_m) r += wider_m;
    const StrokeField field = field_of(stroke, ink.cell_m());
    // The lattice lies on the edges of cells, half a cell from their middles.
    const double left = field.corner.x + paint::Sheet::kSide_m / 2;
    const double low = field.corner.y + paint::Sheet::kSide_m / 2;
    const int first_column = static_cast<int>(std::lround(left / ink.cell_m()));
    const int last_row = size - 1 - static_cast<int>(std::lround(low / ink.cell_m()));
    for (int y = 0; y + 1 < field.rows; ++y) {
      for (int x = 0; x + 1 < field.columns; ++x) {
        const int column = first_column + x, row = last_row - y;
        if (column < 0 || row < 0 || column >= size || row >= size) continue;
        const float below = field.at(x, y) / 4 + field.at(x + 1, y) / 4;
        const float above = field.at(x, y + 1) / 4 + field.at(x + 1, y + 1) / 4;
        if (below + above < 0)
          ink.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                    static_cast<std::size_t>(column)] = 1;
      }
    }
  }
  return ink;
}

}  // namespace nazori::calligraphy
