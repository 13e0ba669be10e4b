// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/practice/learner.h"
#include "nazori/practice/session_feedback.h"

namespace nazori::practice {

/// Takes back what the learner did last. Thread: that of the learner.
/// @return what is to be announced: undone, nothing_to_undo or not_writable; nullopt where the learner has
/// reported an error.
[[nodiscard]] std::optional<SessionFeedback> undo_last(Learner& learner);

}  // namespace nazori::practice
