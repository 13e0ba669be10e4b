// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <vector>

#include "nazori/study/learner_store.h"

namespace nazori::study {

/// Why a character comes.
enum class TaskKind : std::uint8_t {
  step,    ///< in its (re)learning steps: due at a minute
  review,  ///< due on a day
  fresh,   ///< new, or begun and not yet written from memory
};

/// Something to do.
struct StudyTask {
  TaskKind kind = TaskKind::review;
  char32_t character = 0;
  Stage stage = Stage::memory;  ///< that the lesson proposes
  Time due{};                   ///< step: the minute; else the beginning of the day it was due
  double retrievability = 0;    ///< chance that it is still known; 0 for new ones

  friend bool operator==(const StudyTask&, const StudyTask&) = default;
};

/// How a backlog is worked off: what is still best known first, so many a day, with nothing new until it is
/// done.
struct GentlePlan {
  int overdue = 0;  ///< reviews and unfinished steps that have piled up
  int per_day = 0;  ///< reviews asked for today
  int days = 0;     ///< study days until all is caught up, today included
  Day last_day{};   ///< the last of them

  friend bool operator==(const GentlePlan&, const GentlePlan&) = default;
};

/// What today holds.
struct DayPlan {
  Day day{};
  std::vector<StudyTask> now;          ///< to be done now, first things first
  std::vector<StudyTask> later_today;  ///< steps that fall due later today, the next one first
  std::vector<char32_t> leeches;       ///< set apart; their lesson is offered, never forced
  int reviews_done = 0;                ///< characters reviewed today that had been met before
  int new_done = 0;                    ///< characters met first today
  int held_back = 0;                   ///< of what is due, what the day's limit keeps for another day
  std::optional<GentlePlan> gentle;
  std::chrono::milliseconds estimate{0};  ///< time for all of `now`

  [[nodiscard]] int count(TaskKind kind) const;  ///< in `now`
};

/// Days without any review after which a return is a return, and days the limit is lowered then.
inline constexpr int kDaysAway = 7;
inline constexpr int kDaysOfReturn = 3;

/// Plans the present day of a learner.
///
/// Steps of minutes come first, as they fall due (up to 20 minutes early when nothing else is left), then
/// reviews, then new characters. Reviews, with the steps that earlier days left unfinished, are at most
/// `reviews_per_day`, those done today counted; steps of today's own work always come. When more are due, the
/// best known come first: of what can be kept, most is kept. After `kDaysAway` days without a
/// review the limit is 50 %, 75 % and 90 % on the first three days back. While reviews are held back nothing
/// new is added. Paused, postponed and set apart characters do not come.
/// @param learning_order  all characters the learner wants, in order: CharacterLists::in_learning_order().
/// @source descending retrievability for backlogs: simulations of open-spaced-repetition, "Review Sort
/// Orders".
[[nodiscard]] base::Result<DayPlan> plan_day(const LearnerStore& learner,
                                             std::span<const char32_t> learning_order);

/// The chance that a character is known now: FSRS's retrievability after the study days since its last
/// review.
[[nodiscard]] double retrievability_now(const Card& card, const Fsrs& fsrs, Day today);

}  // namespace nazori::study
