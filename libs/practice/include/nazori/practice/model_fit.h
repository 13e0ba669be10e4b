// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nazori/haptics/haptic_scene.h"
#include "nazori/practice/pen_recorder.h"
#include "nazori/view/tablet_view.h"
#include "nazori/writing/grade.h"

namespace nazori::practice {

/// The model moved and sized to lie over what was written.
struct ModelFit {
  double scale = 1;
  double x_m = 0;
  double y_m = 0;
  [[nodiscard]] geometry::TabletPoint apply(geometry::TabletPoint p) const {
    return {p.x * scale + x_m, p.y * scale + y_m};
  }
};

/// Least-squares fit over the matched strokes; the unchanged model if none is matched.
[[nodiscard]] ModelFit fit_model(const std::vector<HandStroke>& written, const writing::Grade& grade,
                                 std::span<const haptics::StrokePath> model);

/// A stroke of the model as a line drawn over the writing. @param opacity 0..1. @param share  0..1 of its
/// length that is drawn, from its start.
[[nodiscard]] view::InkedStroke model_line(const haptics::StrokePath& stroke, const ModelFit& fit,
                                           double opacity, double share = 1);

/// The colour and sign of each written stroke: `wrong` for a mistake, `nearly` for advice or an accepted
/// deviation.
[[nodiscard]] std::vector<view::Verdict> verdicts(const writing::Grade& grade, std::size_t strokes);

/// Strokes of the model without a written stroke, from 0.
[[nodiscard]] std::vector<int> missing_strokes(const writing::Grade& grade, int model_strokes);

}  // namespace nazori::practice
