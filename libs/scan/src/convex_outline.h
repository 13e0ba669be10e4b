// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "connected.h"
#include "nazori/scan/sheet.h"

namespace nazori::scan {

/// The corners of a convex piece of a picture, clockwise as it is seen.
using ConvexOutline = std::vector<PhotoPoint>;

/// The smallest convex outline around pixels. @param pixels  at least one.
[[nodiscard]] ConvexOutline outline_of(const std::vector<Pixel>& pixels);

/// In pixels.
[[nodiscard]] double area_of(const ConvexOutline& outline);

/// The quadrilateral whose sides run along an outline that is one with rounded or ragged corners, around from
/// the corner that is nearest to the upper left.
/// @param share  of its area that the outline must fill.
[[nodiscard]] std::optional<std::array<PhotoPoint, 4>> quadrilateral_in(const ConvexOutline& outline,
                                                                        double share);

/// The pixels of one row that lie inside an outline.
struct RowInside {
  int row = 0;
  int first = 0;
  int last = 0;
};
/// All rows of a picture that have such pixels, from the top.
[[nodiscard]] std::vector<RowInside> rows_inside(const ConvexOutline& outline, int width, int height);

}  // namespace nazori::scan
