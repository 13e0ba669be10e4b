// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nazori/carving/groove.h"
#include "nazori/geometry/point.h"

namespace nazori::author {

/// A point of a closed contour of straight lines and quadratic curves. Between two control points lies a
/// point of the curve that is not written, as in TrueType.
struct OutlinePoint {
  geometry::GlyphPoint at;
  bool on_curve = true;  ///< else a control point
};
/// Clockwise on the screen; the first point is on the curve.
using OutlineContour = std::vector<OutlinePoint>;

/// A round brush at one place of a groove.
struct Disc {
  geometry::GlyphPoint at;
  double radius = 0;  ///< [glyph units]
  friend bool operator==(const Disc&, const Disc&) = default;
};

/// How thin a line may become [glyph units].
struct RadiusFloor {
  double body = 0;  ///< least radius
  double tip = 0;   ///< at both ends, over 0; a dot has the radius of the body
  double run = 0;   ///< length over which the floor sinks to that of the tip; at most a quarter of the line
};

/// The discs of a groove. The area that a disc sweeps, growing or shrinking evenly from each to the next, is
/// that of the groove, but for the tolerance.
/// @param groove  at least one point, all of them finite. @param floor  least radius.
[[nodiscard]] std::vector<Disc> discs_of(const carving::Groove& groove, const RadiusFloor& floor,
                                         double tolerance);

/// How far a disc differs from the nearest one that is swept between two others: in place and radius
/// together. For geometry::needed_points().
[[nodiscard]] double distance_to_segment(const Disc& disc, const Disc& a, const Disc& b);

/// Few of the discs, which sweep the same area but for the tolerance. The first and the last stay.
/// @param block  every so many discs one stays in any case: so the time grows only with their number.
[[nodiscard]] std::vector<Disc> thinned_discs(std::span<const Disc> discs, double tolerance,
                                              std::size_t block = 512);

/// Outlines the area that discs sweep, with round ends and joins. Filled by the rule of non-zero winding, it
/// is that area but for the tolerance; contours may cross themselves and one another.
/// @param discs  at least one, each with a radius over 0.
void append_outline(std::span<const Disc> discs, double tolerance, std::vector<OutlineContour>& contours);

}  // namespace nazori::author
