// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// A zero of a function of one variable.
struct Root {
  double at = 0;
  bool crosses = true;  ///< false: touches zero without a proven change of sign
};

struct Roots {
  std::vector<Root> roots;  ///< rising
  int undecided = 0;        ///< narrow pieces where a zero is neither proven nor excluded
  bool has_ranges = false;  ///< also zero throughout some range, as floor(x) is
};

/// All zeros of `f` in [low, high], by bisection with intervals: single ones are proven, double ones are
/// accepted where rounding makes them indistinguishable from zero. Poles and jumps are never zeros. If there
/// are many more than 12,000 zeros, only the first are found, and one piece is undecided.
/// @param most_boxes  limit of the work: four for each zero of a sine, and a quarter more.
[[nodiscard]] Roots find_roots(const Expression& f, Variable v, double low, double high,
                               int most_boxes = 60'000);

}  // namespace nazori::functions
