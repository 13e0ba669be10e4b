// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/model/plate.h"

namespace nazori::model {

/// The cutter of a mill and how it moves.
struct MillSettings {
  double cutter_mm = 3;         ///< diameter of the ball, 0.2..20
  double step_over_mm = 0.2;    ///< between neighbouring lines of the last pass, 0.02..5
  double pass_depth_mm = 1.5;   ///< of what one pass takes off, 0.05..50
  double safe_mm = 5;           ///< height of rapid moves above the plate, 1..100
  double feed_mm_min = 800;     ///< speed along the groove, 10..20,000
  double plunge_mm_min = 250;   ///< speed straight down into the material, 10..20,000
  double spindle_rpm = 12'000;  ///< 0..60,000
};

/// A line along which the cutter moves to and fro, for a groove around it.
struct MillGuide {
  PlateLine line;            ///< at least one point
  double half_width_mm = 1;  ///< of the groove, > 0
};

/// A straight move of the tip of the cutter to a point: x and y of the plate, z above its upper face [mm].
struct MillMove {
  enum class Speed { rapid, feed, plunge };
  double x = 0;
  double y = 0;
  double z = 0;
  Speed speed = Speed::rapid;
};

/// The way of the tip of the cutter. It begins and ends at the safe height.
struct MillPath {
  std::vector<MillMove> moves;
  int passes = 0;            ///< the last one goes along the bottom, those before it take off layers
  double deepest_mm = 0;     ///< below the upper face
  double cut_length_mm = 0;  ///< of moves that are not rapid
  double minutes = 0;        ///< of those moves at their speeds
};

/// The way of a ball cutter through the grooves of a plate. At each place the ball goes as deep as it fits.
/// A groove that is narrower than the ball becomes shallower. Nothing is cut deeper than the groove. Up to
/// 0.01 mm of material stays on purpose, for the straight pieces of the way. Rapid moves are at the safe
/// height only.
/// @param guides  the middle lines of the grooves; none: the whole plate is cut line by line.
/// @return Errc::bad_argument for a setting out of range, or a plate without a groove.
/// @cost less than a second for a character of twenty strokes. Thread-safe: yes.
/// @source the ball on a height map: Choi and Jerard, Sculptured Surface Machining, 1998 (inverse tool
/// offset).
[[nodiscard]] base::Result<MillPath> mill_path(const Plate& plate, std::span<const MillGuide> guides,
                                               const MillSettings& settings = {});

/// G-code: millimetres (G21), absolute (G90), origin at the lower left corner of the upper face. ASCII with
/// one command a line; it starts the spindle, and ends at the safe height with the spindle stopped.
/// @param name  for the comment at the start; only its ASCII letters are kept.
/// @source ISO 6983-1; words that GRBL, LinuxCNC and Mach have in common.
[[nodiscard]] std::string to_gcode(const MillPath& path, const MillSettings& settings, std::string_view name);

}  // namespace nazori::model
