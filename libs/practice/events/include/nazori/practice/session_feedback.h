// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/practice/learner_event.h"
#include "nazori/study/card.h"

namespace nazori::practice {

/// What a study session waits for.
enum class SessionState : std::uint8_t {
  idle,     ///< no session
  doing,    ///< the learner is at a stage
  offered,  ///< the stage is done and saved; StudySession::go_on() goes to the next
  judged,   ///< written from memory: StudySession::rate() saves it
};

/// What a study session has to announce.
struct SessionFeedback {
  enum class Kind : std::uint8_t {
    // Why nothing is done.
    not_writable,     ///< nothing can be saved: `trouble`, where it is known
    no_plan,          ///< a session cannot start, for what is due cannot be read: `error`
    plan_lost,        ///< the session ends, for what is due cannot be read: `error`
    nothing_due,      ///< a session cannot start
    nothing_to_undo,  ///< nothing was ever done
    // What was done.
    all_done,   ///< the session has ended: nothing is left
    ended,      ///< the session has ended before that
    rated,      ///< the first of `characters`, as `rating`; it comes again as `card` says
    set_apart,  ///< the first of `characters` was forgotten too often and is out of the reviews
    undone,     ///< an action of `entry` about `characters`
    postponed,  ///< the first of `characters`, to tomorrow
    paused,     ///< the first of `characters`
    reset,      ///< the first of `characters` is new again
  };

  Kind kind = Kind::ended;
  std::vector<char32_t> characters;
  study::Stage stage = study::Stage::memory;  ///< `brush`: of the reviews with the brush
  study::Rating rating = study::Rating::good;
  study::Card card;    ///< after the rating
  study::Time now{};   ///< of the rating
  study::Day today{};  ///< of the rating
  study::EntryKind entry = study::EntryKind::writing;
  base::Error error;
  std::optional<LearnerEvent> trouble;
};

}  // namespace nazori::practice
