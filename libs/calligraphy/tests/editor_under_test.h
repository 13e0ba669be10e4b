// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/calligraphy/sheet_editor.h"

namespace nazori::calligraphy::test {

/// On a small sheet, which is faster.
inline SheetEditor editor() { return std::move(SheetEditor::create("hanshi", 128).value()); }

/// Draws a straight stroke after all that was written before.
inline void line(SheetEditor& e, geometry::PaperPoint from, geometry::PaperPoint to,
                 std::optional<double> pressure = 0.6, double seconds = 0.8) {
  constexpr int kSamples = 40;
  // Times only have to grow.
  static double begins_s = 0;
  begins_s += 10;
  for (int i = 0; i <= kSamples; ++i) {
    brush::PenSample sample;
    sample.time_s = begins_s + seconds * i / kSamples;
    sample.at = from + (to - from) * (static_cast<double>(i) / kSamples);
    sample.pressure = pressure;
    e.move_pen(sample);
  }
  e.lift_pen();
}

inline bool is_painted(const SheetEditor& e, int column, int row) {
  const paint::Cell cell = e.sheet().at(column, row);
  paint::TotalAmount pigment = cell.covered;
  for (std::size_t k = 0; k < paint::kSlots; ++k)
    pigment += paint::TotalAmount{cell.moving[k]} + cell.fixed[k];
  return pigment > paint::kOne / 50;
}

inline bool painted(const SheetEditor& e, geometry::PaperPoint at) {
  const double cell = e.sheet().cell_m();
  const int half = e.sheet().size() / 2;
  return is_painted(e, half + static_cast<int>(at.x / cell), half - static_cast<int>(at.y / cell));
}

inline int painted_cells(const SheetEditor& e) {
  int cells = 0;
  for (int row = 0; row < e.sheet().size(); ++row)
    for (int column = 0; column < e.sheet().size(); ++column) cells += is_painted(e, column, row) ? 1 : 0;
  return cells;
}

}  // namespace nazori::calligraphy::test
