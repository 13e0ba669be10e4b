// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/practice/stage_feedback.h"
#include "nazori/widgets/words/feedback.h"

namespace nazori::ui {

/// The sign and colour of what a stage reports.
[[nodiscard]] inline Feedback to_feedback(practice::Tone tone) {
  switch (tone) {
    case practice::Tone::good:
      return Feedback::good;
    case practice::Tone::advice:
      return Feedback::advice;
    case practice::Tone::wrong:
      return Feedback::wrong;
    case practice::Tone::hint:
      break;
  }
  return Feedback::hint;
}

}  // namespace nazori::ui
