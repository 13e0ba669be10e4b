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

/// Least squares over the strokes that are matched; the model as it stands where none is.
[[nodiscard]] ModelFit fit_model(const std::vector<HandStroke>& written, const writing::Grade& grade,
                                 std::span<const haptics::StrokePath> model);

/// A stroke of the model as a line over the writing. @param opacity 0..1
[[nodiscard]] view::WrittenStroke model_line(const haptics::StrokePath& stroke, const ModelFit& fit,
                                             double opacity);

/// What colour and sign each written stroke gets: a fault is wrong, advice or an accepted slip nearly.
[[nodiscard]] std::vector<view::Verdict> verdicts(const writing::Grade& grade, std::size_t strokes);

/// Strokes of the model that no written stroke is, from 0.
[[nodiscard]] std::vector<int> missing_strokes(const writing::Grade& grade, int model_strokes);

}  // namespace nazori::practice
