// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "arc_tracer.h"
#include "one_variable.h"

namespace nazori::functions {

struct SelfCrossing {
  double x = 0;
  double y = 0;
  double parameter = 0;  ///< the smaller one
};

/// Where an arc crosses itself: places that it passes in two directions. Candidates come from the drawn line,
/// each is solved for both parameters. A curve that is drawn several times, or forth and back, does not cross
/// itself there.
[[nodiscard]] std::vector<SelfCrossing> self_crossings(const Arc& arc, int statement, const OneVariable& x,
                                                       const OneVariable& y, const OneVariable& slope_x,
                                                       const OneVariable& slope_y, const Tracing& tracing);

}  // namespace nazori::functions
