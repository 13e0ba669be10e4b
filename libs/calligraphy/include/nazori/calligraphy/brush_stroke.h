// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "nazori/brush/pen.h"
#include "nazori/calligraphy/ruling.h"
#include "nazori/geometry/bristle_segment.h"

namespace nazori::calligraphy {

/// What decided how broad a stroke is.
enum class WidthFrom : std::uint8_t {
  hand,     ///< the pressure of a pen, or the height of a force-feedback device
  speed,    ///< a mouse or finger has no pressure: it was guessed from the speed
  nothing,  ///< likewise, and the pressure was always the same
};

/// The pen and the band of ink under it at one moment of a stroke. Lengths in metres on the sheet.
struct BrushPoint {
  double time_s = 0;  ///< on the clock of the pen
  geometry::PaperPoint pen;
  geometry::PaperPoint at;              ///< middle of the band that the hair touches
  double half_width_m = 0;              ///< of that band, across the stroke
  std::optional<double> pressure = {};  ///< 0..1, of a pen that reports it
  double lean_rad = 0;                  ///< of the holder from upright
  double lean_to_rad = 0;               ///< side to which its upper end leans, from x to y
  WidthFrom width_from = WidthFrom::hand;
};

/// A stroke as a brush wrote it, from its start to its end.
using BrushStroke = std::vector<BrushPoint>;

/// What a move of the pen adds to a stroke. @param swept  what the bristles swept in this move; the stroke
/// does not change where it is empty. @param guesses  whether a pressure that is missing is guessed.
void add_point(BrushStroke& stroke, const brush::PenSample& sample,
               std::span<const geometry::BristleSegment> swept, bool guesses = true);

/// What decided the width of most of the stroke; of an empty one the hand.
[[nodiscard]] WidthFrom width_from(const BrushStroke& stroke);

/// The ink of a stroke without its texture: the middle line and half of the width at each of its points.
[[nodiscard]] ModelStroke shape_of(const BrushStroke& stroke);

/// Closed lines around the ink of a stroke, exact to 0.02 mm; holes turn the other way (clockwise).
/// @param stroke  as a disc at each point that moves and grows to the next one.
[[nodiscard]] std::vector<geometry::Polyline<geometry::PaperFrame>> outline_of(const ModelStroke& stroke);

}  // namespace nazori::calligraphy
