// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/practice/stage_feedback.h"
#include "nazori/practice/tablet_control.h"

namespace nazori::practice {

/// How to begin tracing, with what the tablet shows now.
[[nodiscard]] StageFeedback tracing_invitation(const TabletControl& tablet);

/// What an event of the ink means to a learner; nothing where it is not worth a sentence. @param stroke
/// from 1.
[[nodiscard]] std::optional<StageFeedback> tracing_feedback(TraceEvent event, int stroke,
                                                            const TabletControl& tablet);

/// Whether the event is a mistake. Going on where a bit of an earlier stroke is missing is none.
[[nodiscard]] bool is_mistake(TraceEvent event, const TabletControl& tablet);

/// Whether snapping is on, and whether it has an effect.
[[nodiscard]] StageFeedback snapping_feedback(const TabletControl& tablet);

/// Which stroke is shown.
[[nodiscard]] StageFeedback shown_stroke_feedback(const TabletControl& tablet);

}  // namespace nazori::practice
