// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arc_tracer.h"
#include "point_list.h"

namespace nazori::functions {

/// Adds the points of one arc of a statement: zeros, y intercepts, extrema, inflections, cusps, and, of arcs
/// with a parameter of their own, places where it crosses itself.
void add_points_of(const Arc& arc, int statement, PointList& list);

}  // namespace nazori::functions
