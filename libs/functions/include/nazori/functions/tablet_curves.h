// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "nazori/functions/tracing.h"
#include "nazori/geometry/frames.h"

namespace nazori::functions {

/// A piece of a curve at the position of its groove, to which a stylus can snap.
struct TabletCurve {
  int statement = 0;
  bool closed = false;                        ///< the last point is the first one again
  std::vector<geometry::TabletPoint> points;  ///< [m]; two or more
};

/// The position of a plate point on the tablet. Samples of a plate are the middles of its cells, while
/// samples of a height map span the tablet from edge to edge; the conversion accounts for this.
[[nodiscard]] geometry::TabletPoint tablet_place(PlatePoint at, int size, const geometry::TabletShape& shape);
/// The inverse: for a hand on the tablet.
[[nodiscard]] PlatePoint plate_place(geometry::TabletPoint at, int size, const geometry::TabletShape& shape);

/// The curves inside the window as polylines within `tolerance_m` of the tracing. Branches are cut at the
/// frame; bars of dense bands are left out, single points become two points a micrometre apart.
/// @param size  samples per side of the plate they belong to, >= 2.
[[nodiscard]] std::vector<TabletCurve> tablet_curves(const Tracing& tracing, int size,
                                                     const geometry::TabletShape& shape = {},
                                                     double tolerance_m = 20e-6);

/// A location on a curve.
struct CurvePlace {
  std::size_t branch = 0;  ///< index into Tracing::branches
  std::size_t piece = 0;   ///< between the points with this index and the next
  PlatePoint at;
  double distance = 0;  ///< from the query point, in plate units
};

/// The location on a traced curve nearest to a hand; nothing if there is no curve. The time is proportional
/// to the number of points: for the interface, not for the servo.
/// @param statement  only on this one; -1: on any.
[[nodiscard]] std::optional<CurvePlace> nearest_place(const Tracing& tracing, PlatePoint hand,
                                                      int statement = -1);
/// The location `distance` further along the same branch (below 0: back), in plate units; stops at the ends
/// of an open branch and continues round a closed one.
[[nodiscard]] CurvePlace step_along(const Tracing& tracing, const CurvePlace& from, double distance);

/// The feel of the grooves of one statement, to distinguish several: first by friction, then by texture.
struct CurveFeel {
  double friction = 0.05;     ///< coefficient of the friction cone in the groove
  double texture_period = 0;  ///< of the bumps on its floor, as a share of the plate's side; 0: smooth
};
/// The feel of the statement with this index; it repeats after four.
[[nodiscard]] CurveFeel feel_of(int statement);

}  // namespace nazori::functions
