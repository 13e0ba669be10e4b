// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "alignment.h"
#include "course.h"
#include "model_inside.h"
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
                              const Residue& residue, const Course& course, float touch);

/// Whether a dot is level or upright once it is turned by `turn_rad` from the model's.
[[nodiscard]] bool is_level_or_upright(const Samples& model, float turn_rad);

/// Takes out the slant of a straight dot that is level or upright. @return whether it is one.
/// @source 常用漢字表の字体・字形に関する指針 (2016): the first strokes of 言 and 主 may be level, slanted or
/// upright.
[[nodiscard]] bool ignore_slant(const Samples& model, Residue& residue, StrokeDifference& difference,
                                Course& course);

/// A drawn stroke beside the model's stroke that it is judged by, or another way to write that.
struct JudgedStroke {
  Judgement judgement;
  StrokeDifference difference;
  Placement placement;
  Residue residue;
  Course course;
  Samples drawn;  ///< laid over the model, in its direction; without a slant that is free
  Samples model;
  Samples as_drawn;         ///< not laid over the model, in the model's direction
  double used_freedom = 0;  ///< share of the limit that a slant costs although it is free
};

/// Judges a drawn stroke, laid over the model, against the model's stroke, and against other ways to write
/// it: the best counts. A slant that is free costs a little: a strange stroke uses that freedom more often
/// than a right one. Its cost is not in the deviation.
[[nodiscard]] JudgedStroke judge_stroke(const Shape& laid, const Shape& model,
                                        std::span<const Shape> other_ways, const StrokeDifference& difference,
                                        const Placement& placement);

/// Judges the stroke of each link against the form it was aligned with.
[[nodiscard]] std::vector<JudgedStroke> judged_strokes(const Alignment& alignment,
                                                       std::span<const Shape> drawn, const Form& form);

/// The largest deviation that is accepted: 1 at normal strictness. @pre strictness 0..1.
[[nodiscard]] double deviation_limit(double strictness);

}  // namespace nazori::writing
