// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "arc_tracer.h"
#include "plane_tracer.h"

namespace nazori::functions {

/// An equation split by algebra into parts, each drawn in the most suitable way.
struct EquationParts {
  std::vector<Arc> arcs;                 ///< solved for one variable; vertical and horizontal lines
  std::vector<PlaneEquation> equations;  ///< the rest
  std::vector<std::vector<Expression>>
      areas;  ///< where these are not negative and `whole` is defined, the equation holds everywhere
  Expression whole;
  int undecided = 0;
};

/// @param low,high  the rectangle, x first.
[[nodiscard]] EquationParts split_equation(const Expression& left, const Expression& right,
                                           const std::array<double, 2>& low,
                                           const std::array<double, 2>& high);

}  // namespace nazori::functions
