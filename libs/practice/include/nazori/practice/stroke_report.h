// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/practice/stage_feedback.h"

namespace nazori::practice {

/// What there is to say of the stroke that was written last.
struct StrokeReport {
  StageFeedback feedback;
  bool is_mistake = false;
  bool can_be_tried_again = false;  ///< a mistake that another stroke in its place would put right
};

/// @param grade  about `written` strokes, the last of which is meant; it may lag behind.
/// @param of_model  strokes of the model.
[[nodiscard]] StrokeReport report_on_last_stroke(const writing::Grade& grade, int written, int of_model);

/// The stroke of the model that had to come as the last one of those `written`, from 0.
[[nodiscard]] int expected_stroke(const writing::Grade& grade, int written, int of_model);

}  // namespace nazori::practice
