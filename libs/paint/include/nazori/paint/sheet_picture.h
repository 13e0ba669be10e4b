// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "nazori/paint/sheet.h"
#include "nazori/surface/colour_picture.h"

namespace nazori::paint {

/// A sheet as a picture, one pixel for each cell, that is kept up to date tile by tile. Colours are mixed as
/// by Kubelka and Munk with Saunderson's correction, from tables: one by the amount for one pigment on bare
/// paper, one by three amounts for mixtures and for layers. Both stay within 2 of 255 levels of the formulas.
/// Thread rules: one thread.
class SheetPicture {
 public:
  SheetPicture();
  SheetPicture(SheetPicture&&) noexcept;
  SheetPicture& operator=(SheetPicture&&) noexcept;
  ~SheetPicture();

  /// Draws the tiles that changed since the last call with this sheet; all of them where sheet, paper or
  /// palette are others.
  /// @return the numbers of the tiles that were drawn, row by row; a tile is 32 x 32 pixels.
  const std::vector<int>& update(const Sheet& sheet);
  /// Side in pixels is the size of the sheet.
  [[nodiscard]] const surface::ColourPicture& picture() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// The colour of a cell from the formulas, without tables.
[[nodiscard]] ScreenColour colour_of(const Sheet& sheet, int column, int row);

}  // namespace nazori::paint
