// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/writing/grade.h"
#include "placement.h"
#include "residue.h"
#include "stroke_difference.h"

namespace nazori::writing {

/// All deviations of a stroke in one figure: 0 is the model, 1 the limit at normal strictness.
struct Judgement {
  double deviation = 0;
  double place = 0;  ///< the part that comes from the position
  Deviation most = Deviation::none;
};

[[nodiscard]] Judgement judge(const StrokeDifference& difference, const Placement& placement,
                              const Residue& residue, float touch);

/// The largest deviation that is accepted: 1 at normal strictness. @pre strictness 0..1.
[[nodiscard]] double deviation_limit(double strictness);

}  // namespace nazori::writing
