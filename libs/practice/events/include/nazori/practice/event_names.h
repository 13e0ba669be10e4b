// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "nazori/practice/session_feedback.h"
#include "nazori/practice/stage_feedback.h"

namespace nazori::practice {

/// Names for data formats, never translated and never changed: "stroke_written". Any thread.
[[nodiscard]] std::string_view name_of(StageEvent event);
/// Of what a stage reports: that of its event, or the stage's own.
[[nodiscard]] std::string_view name_of(const StageFeedback& what);
/// "hint", "good", "advice", "wrong".
[[nodiscard]] std::string_view name_of(Tone tone);
/// "rated".
[[nodiscard]] std::string_view name_of(SessionFeedback::Kind kind);
/// "idle", "doing", "offered", "judged".
[[nodiscard]] std::string_view name_of(SessionState state);

}  // namespace nazori::practice
