// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shape.h"

namespace nazori::writing {

/// How a drawn stroke differs from one of the model, both in glyph units.
struct StrokeDifference {
  float offset_x = 0;  ///< of the centre
  float offset_y = 0;
  float shape = 0;       ///< root-mean-square distance of the samples after centring
  float proportion = 0;  ///< the same for the shapes scaled to length 1
  float length_log = 0;  ///< natural logarithm of drawn length / model length
  float model_length = 0;
  float steeper = 0;  ///< sine of the drawn stroke's slope minus the model's, 0 level, 1 upright
  float freedom = 1;  ///< Shape::freedom of the model stroke
  bool reversed = false;
  float cost = 0;  ///< sum of squared deviations in units of the natural variation
};

/// Below this cost a stroke counts as the stroke of the model, at normal strictness.
inline constexpr float kAcceptCost = 12.0F;

/// Strokes whose positions alone cost more than `far` are not examined further, whatever their shapes.
[[nodiscard]] StrokeDifference compare(const Shape& drawn, const Shape& model, float far);

}  // namespace nazori::writing
