// SPDX-License-Identifier: Apache-2.0
#include "undo_last.h"

namespace nazori::practice {

std::optional<SessionFeedback> undo_last(Learner& learner) {
  SessionFeedback event;
  if (!learner.can_write()) {
    event.kind = SessionFeedback::Kind::not_writable;
    event.trouble = learner.trouble();
    return event;
  }
  const auto undone = learner.store().undo();
  if (!learner.report(undone)) return std::nullopt;
  if (!*undone) {
    event.kind = SessionFeedback::Kind::nothing_to_undo;
    return event;
  }
  event.kind = SessionFeedback::Kind::undone;
  event.characters = (*undone)->characters;
  event.entry = (*undone)->kind;
  return event;
}

}  // namespace nazori::practice
