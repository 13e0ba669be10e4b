// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/practice/stage_feedback.h"
#include "nazori/practice/tablet_control.h"

namespace nazori::practice {

/// The instruction for beginning to trace, given what the tablet shows now.
[[nodiscard]] StageFeedback tracing_invitation(const TabletControl& tablet);

/// The feedback for an event of the ink; nothing where none is needed. @param stroke from 1.
[[nodiscard]] std::optional<StageFeedback> tracing_feedback(TraceEvent event, int stroke,
                                                            const TabletControl& tablet);

/// Whether the event is a mistake. Going on although the end of an earlier stroke is missing is not a
/// mistake.
[[nodiscard]] bool is_mistake(TraceEvent event, const TabletControl& tablet);

/// Whether snapping is on, and whether it has an effect.
[[nodiscard]] StageFeedback snapping_feedback(const TabletControl& tablet);

/// Which stroke is shown.
[[nodiscard]] StageFeedback shown_stroke_feedback(const TabletControl& tablet);

}  // namespace nazori::practice
