// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nazori/carving/carve.h"
#include "nazori/carving/groove.h"
#include "nazori/geometry/point.h"
#include "nazori/kanji/stroke.h"

namespace nazori::carving {

/// A point on a stroke's centre line and the brush there, in samples of the grid.
struct Joint {
  double x = 0;
  double y = 0;
  double forward_x = 1;  ///< direction of writing, halfway between the segments before and after
  double forward_y = 0;
  double half_width = 0;
  double depth = 0;         ///< as a share of the brush's depth, [0, 1]
  bool needs_disc = false;  ///< the line bends more tightly here than the groove is wide
};

/// A part of a stroke whose bends are so gentle that no sample of its groove is close to two distant points
/// of it.
struct Piece {
  std::vector<Joint> joints;  ///< at least one
  bool round_start = true;    ///< a round cap, or cut straight because the stroke goes on without a corner
  bool round_end = true;
};

/// How finely a line is sampled.
enum class Detail {
  smooth,  ///< smoother than a fingertip can feel
  samples  ///< no finer than the samples of the grid, for files with more points than the grid can show
};

/// Makes the smooth line that the brush follows from the points of a stroke. Gentle bends become curves
/// through the points, and corners stay corners. Between corners the direction changes so little from joint
/// to joint that it feels like a curve.
/// @param size  side of the grid.
[[nodiscard]] std::vector<Piece> trace(const kanji::StrokeLine& line, const Brush& brush, int size,
                                       Detail detail = Detail::smooth);

/// The same for a groove, whose joints have its own depths. @param groove  at least one point.
[[nodiscard]] std::vector<Piece> trace(const Groove& groove, int size);

/// Angle [rad] by which a line turns at point `i`, measured over `reach` to both sides; 0 at its ends.
[[nodiscard]] double turn_at(std::span<const geometry::GlyphPoint> line, std::size_t i, double reach);

}  // namespace nazori::carving
