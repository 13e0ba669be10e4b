// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arc_tracer.h"
#include "point_list.h"

namespace nazori::functions {

/// Adds the points of one arc of a statement: zeros, y intercepts, extrema, inflections, cusps, and, of arcs
/// with a parameter of their own, places where it crosses itself.
void add_points_of(const Arc& arc, int statement, PointList& list);

/// The zeros of `f` between `low` and `high`, each factor for itself, so that touching zeros are found as
/// exactly as others. Without those in gaps of `f`; rising.
[[nodiscard]] std::vector<double> zeros_of(const Expression& f, Variable v, double low, double high,
                                           int most_boxes = 60'000);

}  // namespace nazori::functions
