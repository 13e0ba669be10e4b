// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "nazori/scan/sheet.h"

namespace nazori::scan {

/// Pixels a side of a cell that was cut out of a photograph.
inline constexpr int kCellSide = 128;

/// A cell seen from above: how dark it is, 0 white paper to 1 black, row by row from the top.
using DarkCell = std::vector<float>;

/// What is dark in a cell: 0 or 1, row by row.
using InkCell = std::vector<std::uint8_t>;

/// A cell where it really lies: paper is not quite flat.
struct PlacedBox {
  print::MarkedBox box;
  double x_mm = 0;  ///< to add to the place of the box
  double y_mm = 0;
};

/// Moves each cell to where its outline is seen, beginning with the first and each time near its neighbour.
[[nodiscard]] std::vector<PlacedBox> place_boxes(const Photo& photo, const FoundSheet& sheet,
                                                 const std::vector<print::MarkedBox>& boxes);

[[nodiscard]] DarkCell cut_out(const Photo& photo, const PageMap& map, const PlacedBox& box);

/// How dark the guide lines of all cells are: ink on them must be darker.
[[nodiscard]] float guide_darkness(const std::vector<DarkCell>& cells, print::Guide guide);

/// Where somebody wrote. Outline and guide lines do not count.
[[nodiscard]] InkCell ink_of(const DarkCell& cell, const print::MarkedBox& box, print::Guide guide,
                             float guide_darkness);

}  // namespace nazori::scan
