// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/session_steps.h"

#include <algorithm>
#include <chrono>

namespace nazori::practice {

SessionProgress progress_of(const StudySession& session) {
  SessionProgress progress;
  if (!session.is_running()) return progress;
  progress.done = session.done();
  progress.total = session.total();
  progress.at = std::min(progress.done + 1, progress.total);
  constexpr std::chrono::milliseconds kHalfMinute{30'000};
  if (session.time_left() >= kHalfMinute)
    progress.minutes_left =
        static_cast<int>(std::chrono::ceil<std::chrono::minutes>(session.time_left()).count());
  return progress;
}

NextStep next_step(const StudySession& session, bool has_unjudged) {
  if (!session.is_running()) return NextStep::none;
  if (has_unjudged) return NextStep::finish_writing;
  if (session.is_away()) return NextStep::go_back;
  switch (session.state()) {
    case SessionState::judged:
      return NextStep::rate;
    case SessionState::offered:
      return session.is_over() ? NextStep::next_character : NextStep::stage;
    case SessionState::doing:
      return session.asks_from_memory() ? NextStep::finish_writing : NextStep::none;
    case SessionState::idle:
      break;
  }
  return NextStep::none;
}

FoldedPanels folded_panels(const StudySession& session) {
  if (!session.is_running() || session.is_away()) return {};
  // The lesson of a difficult character shows its parts and its hardest strokes beside the tablet.
  const bool is_lesson = session.is_leech_lesson() && !session.asks_from_memory();
  return {true, session.state() != SessionState::judged && !is_lesson};
}

}  // namespace nazori::practice
