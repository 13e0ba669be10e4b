// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nazori/model/braille.h"
#include "nazori/model/plate.h"
#include "nazori/model/raised.h"

namespace nazori::model {

/// Distances of a plot on a plate or on paper.
struct PlotDistances {
  double edge_mm = 5;  ///< around everything
  double gap_mm = 3;   ///< between the square and its labels, and between labels
  double tick_mm = 4;  ///< length of a tick across an axis
};

/// Braille at its place.
struct PlacedBraille {
  std::vector<BrailleCell> cells;
  PlatePoint lower_left;  ///< of its box
};

/// Where the parts of a plot are [mm], as PlateFrame: the square with the curves, the labels of the ticks to
/// its left and below it, and the letters x and y at the ends of the axes.
struct PlotLayout {
  double width_mm = 0;
  double height_mm = 0;
  PlatePoint lower_left;  ///< of the square
  double side_mm = 0;
  std::vector<PlateLine> axes;  ///< with their ticks, also at the left and the lower side of the square
  std::vector<PlateLine>
      curves;  ///< in pieces: a curve that is dashed has gaps, one that is dotted is points
  std::vector<PlacedBraille> labels;
};

/// Lays a plot out. A label that would cover another is left out; zero and the ends come first.
[[nodiscard]] PlotLayout plot_layout(const RaisedPlot& plot, double side_mm,
                                     const PlotDistances& distances = {});

/// The number of a tick; no cells where it has none in braille or more than 6.
[[nodiscard]] std::vector<BrailleCell> cells_of(const RaisedTick& tick);

/// The order in which labels of one axis get their places: zero, the ends, the others. @return indices.
[[nodiscard]] std::vector<std::size_t> label_order(std::span<const RaisedTick> ticks);

}  // namespace nazori::model
