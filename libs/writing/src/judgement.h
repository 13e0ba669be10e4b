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

/// Whether a dot is level or upright once it is turned by `turn_rad` from the model's.
[[nodiscard]] bool is_level_or_upright(const Samples& model, float turn_rad);

/// Compares a straight dot that is level or upright as if it were turned onto the model's.
/// @source 常用漢字表の字体・字形に関する指針 (2016): the first strokes of 言 and 主 may be level, slanted or
/// upright.
void ignore_slant(const Samples& model, StrokeDifference& difference, Residue& residue);

/// The largest deviation that is accepted: 1 at normal strictness. @pre strictness 0..1.
[[nodiscard]] double deviation_limit(double strictness);

}  // namespace nazori::writing
