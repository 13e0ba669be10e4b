// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/model/plate.h"
#include "nazori/model/raised.h"

namespace nazori::model {

/// How tablets are put on one plate.
struct TabletPlateSettings {
  double side_mm = 100;     ///< of the square of each tablet
  double margin_mm = 6;     ///< around the tablets
  double thickness_mm = 6;  ///< of the plate, without what is raised
  double depth_mm = 3;      ///< of the deepest groove; at least 1 mm less than the thickness
  bool vertical = false;    ///< several tablets stand below one another, not side by side
  int columns = 0;          ///< tablets in one row before the next row begins; 0: all, or one if vertical
  double gap_mm = 0;        ///< between neighbouring tablets, 0..100
  bool hanging_hole =
      true;  ///< a hole of 4 mm in a strip above the tablets, which also tells which side is up
  RaisedStrokeSettings strokes;
};

/// The lower left corners of the squares of tablets on their plate, in reading order.
[[nodiscard]] std::vector<PlatePoint> tablet_corners(std::size_t count, const TabletPlateSettings& settings);

/// A plate with the grooves of tablets, for a stylus or a pencil.
/// @param maps  one or more, in reading order.
/// @return Errc::bad_argument for no map, for a depth that would go through the plate, and as
/// Plate::create().
[[nodiscard]] base::Result<Plate> grooved_plate(std::span<const surface::HeightMap> maps,
                                                const TabletPlateSettings& settings = {});

struct RaisedTablets {
  Plate plate;
  std::vector<int> without_number;  ///< strokes (from 1, of any tablet) for whose number there was no room
};

/// A plate with raised lines, for fingers.
/// @param tablets  the strokes of one or more, in reading order; x and y are shares of the side, 0..1, y up.
/// @return Errc::bad_argument for no tablet, and as Plate::create().
[[nodiscard]] base::Result<RaisedTablets> raised_plate(std::span<const std::vector<RaisedStroke>> tablets,
                                                       const TabletPlateSettings& settings = {});

/// A mould for casting the plate: its negative with a border that holds the material.
/// @param border_mm  height of the border above the highest point.
[[nodiscard]] Plate mould_of(const Plate& plate, double border_mm = 5);

}  // namespace nazori::model
