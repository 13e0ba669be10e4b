// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/expression.h"
#include "point_list.h"

namespace nazori::functions {

/// Adds the points of an equation F(x, y) = 0: intercepts, highest and lowest points, cusps, places where it
/// crosses itself, and single points.
/// @return whether cusps and crossings are complete: found from the equation, not from the drawn line.
bool add_points_of_equation(const Expression& f, int statement, PointList& list);

/// The product of the different factors of F, each once: it has the same zeros and changes its sign at all of
/// them, as far as algebra can tell.
[[nodiscard]] Expression square_free(const Expression& f);

}  // namespace nazori::functions
