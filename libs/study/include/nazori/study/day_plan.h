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
  Time due{};                   ///< step: the minute; else the beginning of the due day
  double retrievability = 0;    ///< probability that it is still recalled; 0 for new ones

  friend bool operator==(const StudyTask&, const StudyTask&) = default;
};

/// The plan for a backlog: the best known characters first, a limited number per day, and nothing new until
/// it is done.
struct GentlePlan {
  int overdue = 0;  ///< reviews and unfinished steps that have piled up
  int per_day = 0;  ///< number of reviews for today
  int days = 0;     ///< study days until everything is caught up, today included
  Day last_day{};   ///< the last of them

  friend bool operator==(const GentlePlan&, const GentlePlan&) = default;
};

/// The plan of a day.
struct DayPlan {
  Day day{};
  std::vector<StudyTask> now;          ///< to be done now, in this order
  std::vector<StudyTask> later_today;  ///< steps that become due later today, in order of time
  std::vector<char32_t> brush;         ///< to be written with the brush now, in this order; not in `now`
  std::vector<char32_t> leeches;       ///< difficult characters; relearning is offered, never forced
  int reviews_done = 0;                ///< characters reviewed today that were introduced before today
  int new_done = 0;                    ///< characters introduced today
  int brush_done = 0;                  ///< characters written with the brush today
  int held_back = 0;                   ///< due characters that the day's limit moves to another day
  std::optional<GentlePlan> gentle;
  std::chrono::milliseconds estimate{0};  ///< time for all of `now`

  [[nodiscard]] int count(TaskKind kind) const;  ///< in `now`
};

/// Number of days without a review that count as an absence, and number of days with a lower limit after it.
inline constexpr int kDaysAway = 7;
inline constexpr int kDaysOfReturn = 3;

/// Plans the present day of a learner.
///
/// Steps of minutes come first, in order of time (up to 20 minutes early when nothing else is left), then
/// reviews, then new characters. The number of reviews, together with steps left unfinished on earlier days
/// and reviews already done today, is at most `reviews_per_day`; steps of today's own work always come. When
/// more are due, the best known come first, because this preserves the most knowledge. After `kDaysAway` days
/// without a review the limit is 50 %, 75 % and 90 % on the first three days back. While reviews are
/// postponed by the limit, nothing new is added. Suspended, postponed and difficult characters are left out.
///
/// With the brush come characters that are well known from memory (Strength::mature) and not due from memory:
/// those whose review with the brush is due, the earliest first, then those never written with it, the best
/// known first. They are at most `brush_per_day`, with those already written today.
/// @param learning_order  all characters the learner wants, in order: CharacterLists::in_learning_order().
/// @source descending retrievability for backlogs: simulations of open-spaced-repetition, "Review Sort
/// Orders".
[[nodiscard]] base::Result<DayPlan> plan_day(const LearnerStore& learner,
                                             std::span<const char32_t> learning_order);

/// The probability that a character is recalled now: FSRS's retrievability after the study days since its
/// last review.
[[nodiscard]] double retrievability_now(const Card& card, const Fsrs& fsrs, Day today);

}  // namespace nazori::study
