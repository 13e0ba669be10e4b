// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// A common zero of several functions of two variables.
struct SystemRoot {
  double a = 0;
  double b = 0;
  /// The gradients of the first two functions differ in direction: proven to be the only zero around.
  bool simple = false;
};

struct SystemRoots {
  std::vector<SystemRoot> roots;
  bool complete = true;  ///< false where the limit of boxes was reached
};

/// The common zeros of `functions` (two or more) in a rectangle: boxes are dropped where an interval leaves
/// out zero, a simple zero of the first two is proven by Krawczyk's test, and where zeros are degenerate
/// (cusps, points of contact) the smallest boxes are joined and judged as one point.
/// @param most_boxes  limit of the work.
/// @source R. Krawczyk, Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken, 1969.
[[nodiscard]] SystemRoots solve_system(std::span<const Expression> functions,
                                       const std::array<Variable, 2>& variables,
                                       const std::array<double, 2>& low, const std::array<double, 2>& high,
                                       int most_boxes = 30'000);

}  // namespace nazori::functions
