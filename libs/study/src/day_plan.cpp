// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/day_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "nazori/kanji/kana_sound.h"
#include "nazori/study/pace.h"
#include "nazori/study/statistics.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::milliseconds;
using std::chrono::minutes;

constexpr minutes kAhead{20};
constexpr minutes kNewKana{1};  ///< until the learner's own pace is known
constexpr std::array<double, kDaysOfReturn> kShareOfReturn{0.5, 0.75, 0.9};

/// The study days so far, including today.
struct Past {
  std::set<char32_t> reviewed_today;
  std::set<char32_t> introduced_today;
  std::vector<Day> days;  ///< days with a review, oldest first
  Pace pace;
};

base::Result<Past> read_past(const LearnerStore& learner, Day today) {
  const auto studied = learner.study_days();
  if (!studied) return tl::unexpected(studied.error());
  const auto reviewed = learner.reviewed_on(today);
  if (!reviewed) return tl::unexpected(reviewed.error());
  const auto introduced = learner.introduced_on(today);
  if (!introduced) return tl::unexpected(introduced.error());
  const auto pace = pace_of(learner);
  if (!pace) return tl::unexpected(pace.error());
  Past past;
  past.introduced_today.insert(introduced->begin(), introduced->end());
  past.reviewed_today.insert(reviewed->begin(), reviewed->end());
  for (const StudyDay& day : *studied)
    if (day.reviews > 0) past.days.push_back(day.day);
  past.pace = *pace;
  return past;
}

/// The number of today since the return, from 0; kDaysOfReturn or more where the limit is not lowered.
int day_of_return(std::vector<Day> all, Day today) {
  if (all.empty()) return kDaysOfReturn;
  if (all.back() < today) all.push_back(today);
  int since = 0;
  for (std::size_t i = all.size() - 1; i > 0; --i, ++since) {
    if (all[i] - all[i - 1] >= days(kDaysAway)) return since;
    if (since >= kDaysOfReturn) break;
  }
  return kDaysOfReturn;
}

/// The expected time of a task; a review fails with the probability that FSRS predicts.
milliseconds time_for(const StudyTask& task, const Pace& pace) {
  switch (task.kind) {
    case TaskKind::fresh:
      // A kana has few strokes, one sound and no meaning. Once there is a history, that decides.
      return pace.introduced_days < kPaceNeeds && kanji::teaching_rank(task.character) ? kNewKana
                                                                                       : pace.introduced;
    case TaskKind::step:
      return pace.recalled;
    case TaskKind::review:
      return pace.recalled + std::chrono::round<milliseconds>(
                                 (1 - task.retrievability) *
                                 std::chrono::duration<double, std::milli>(pace.failed - pace.recalled));
  }
  return pace.recalled;
}

/// Reviews due on each of the coming days, to compute how long a backlog lasts.
GentlePlan spread(int overdue, int per_day, int full_limit, const Cards& cards, Day today, int return_day) {
  constexpr int kMostDays = 3'650;
  GentlePlan plan{overdue, per_day, 0, today};
  std::vector<int> coming(static_cast<std::size_t>(kMostDays), 0);
  for (const auto& [character, card] : cards) {
    if (!card.due_day || card.paused || card.leech) continue;
    const auto offset = (*card.due_day - today).count();
    if (offset > 0 && offset < kMostDays) ++coming[static_cast<std::size_t>(offset)];
  }
  int left = overdue - per_day;
  plan.days = 1;
  for (int day = 1; left > 0 && day < kMostDays; ++day, ++plan.days) {
    const int at = return_day + day;
    const int limit =
        at < kDaysOfReturn
            ? static_cast<int>(std::ceil(full_limit * kShareOfReturn[static_cast<std::size_t>(at)]))
            : full_limit;
    left += coming[static_cast<std::size_t>(day)] - limit;
  }
  plan.last_day = today + days(plan.days - 1);
  return plan;
}

/// What is due with the brush today.
class BrushDue {
 public:
  BrushDue(Day today, int per_day) : today_(today), per_day_(per_day) {}

  void take(const Card& card) {
    if (card.brush.last_day == today_) ++done_;
    if (per_day_ == 0 || strength_of(card) != Strength::mature) return;
    if (card.postponed_until && *card.postponed_until > today_) return;
    // The model would give away the answer of the review from memory.
    if (card.due_day && *card.due_day <= today_) return;
    if (!card.brush.due_day) {
      never_.emplace_back(-card.memory.stability, card.character);
    } else if (*card.brush.due_day <= today_) {
      again_.emplace_back(*card.brush.due_day, card.character);
    }
  }
  void finish(DayPlan& plan) {
    std::sort(again_.begin(), again_.end());
    std::sort(never_.begin(), never_.end());
    plan.brush_done = done_;
    const auto room = static_cast<std::size_t>(std::max(0, per_day_ - done_));
    for (const auto& [due, character] : again_) plan.brush.push_back(character);
    for (const auto& [known, character] : never_) plan.brush.push_back(character);
    if (plan.brush.size() > room) plan.brush.resize(room);
  }

 private:
  Day today_;
  int per_day_;
  int done_ = 0;
  std::vector<std::pair<Day, char32_t>> again_;
  std::vector<std::pair<double, char32_t>> never_;
};

}  // namespace

int DayPlan::count(TaskKind kind) const {
  return static_cast<int>(
      std::count_if(now.begin(), now.end(), [kind](const StudyTask& task) { return task.kind == kind; }));
}

double retrievability_now(const Card& card, const Fsrs& fsrs, Day today) {
  if (!card.last_day) return 0;
  return fsrs.retrievability(card.memory.stability,
                             std::max<double>(0, static_cast<double>((today - *card.last_day).count())));
}

base::Result<DayPlan> plan_day(const LearnerStore& learner, std::span<const char32_t> learning_order) {
  const Time now = learner.now();
  const Day today = learner.today();
  const Settings& settings = learner.settings();
  const auto fsrs = Fsrs::create(settings.fsrs);
  if (!fsrs) return tl::unexpected(fsrs.error());
  const auto past = read_past(learner, today);
  if (!past) return tl::unexpected(past.error());

  DayPlan plan;
  plan.day = today;
  const Time begin_of_day = learner.calendar().begin_of(today);
  std::vector<StudyTask> steps;
  std::vector<StudyTask> reviews;
  std::vector<StudyTask> begun;
  int overdue = 0;
  BrushDue brush(today, settings.brush_per_day);
  for (const auto& [character, card] : learner.cards()) {
    brush.take(card);
    // What was only marked as known today is no new character of the day.
    const bool new_today = card.introduced == today && past->introduced_today.contains(character);
    if (new_today) ++plan.new_done;
    if (past->reviewed_today.contains(character) && !new_today) ++plan.reviews_done;
    if (card.paused || (card.postponed_until && *card.postponed_until > today)) continue;
    if (card.leech) {
      plan.leeches.push_back(character);
      continue;
    }
    const double chance = retrievability_now(card, *fsrs, today);
    switch (card.memory.phase) {
      case Phase::fresh:
        if (card.introduced) {
          begun.push_back({TaskKind::fresh, character, card.next_stage,
                           learner.calendar().begin_of(*card.introduced), 0});
        }
        break;
      case Phase::learning:
      case Phase::relearning:
        // A step left unfinished on an earlier day is treated like an overdue review.
        if (card.memory.due < begin_of_day) {
          reviews.push_back({TaskKind::step, character, card.next_stage, card.memory.due, chance});
          ++overdue;
        } else {
          steps.push_back({TaskKind::step, character, card.next_stage, card.memory.due, chance});
        }
        break;
      case Phase::review:
        if (card.due_day && *card.due_day <= today) {
          reviews.push_back({TaskKind::review, character, card.next_stage,
                             learner.calendar().begin_of(*card.due_day), chance});
          if (*card.due_day < today) ++overdue;
        }
        break;
    }
  }

  brush.finish(plan);

  const int return_day = day_of_return(past->days, today);
  int limit = settings.reviews_per_day;
  if (return_day < kDaysOfReturn) {
    limit = static_cast<int>(std::ceil(limit * kShareOfReturn[static_cast<std::size_t>(return_day)]));
  }
  const int room = std::max(0, limit - plan.reviews_done);
  const int due = static_cast<int>(reviews.size());
  std::sort(reviews.begin(), reviews.end(), [](const StudyTask& a, const StudyTask& b) {
    return std::tuple(-a.retrievability, a.due, a.character) <
           std::tuple(-b.retrievability, b.due, b.character);
  });
  plan.held_back = std::max(0, due - room);
  if (due > room && overdue > 0) {
    plan.gentle = spread(due, room, settings.reviews_per_day, learner.cards(), today, return_day);
  }
  if (due > room) reviews.resize(static_cast<std::size_t>(room));
  const auto left_over = std::stable_partition(
      reviews.begin(), reviews.end(), [](const StudyTask& task) { return task.kind == TaskKind::step; });
  steps.insert(steps.end(), reviews.begin(), left_over);
  reviews.erase(reviews.begin(), left_over);

  std::sort(steps.begin(), steps.end(), [](const StudyTask& a, const StudyTask& b) {
    return std::tuple(a.due, a.character) < std::tuple(b.due, b.character);
  });
  const Time end_of_day = learner.calendar().begin_of(today + days(1));
  for (const StudyTask& step : steps) {
    if (step.due <= now) {
      plan.now.push_back(step);
    } else if (step.due < end_of_day) {
      plan.later_today.push_back(step);
    }
  }
  plan.now.insert(plan.now.end(), reviews.begin(), reviews.end());
  plan.now.insert(plan.now.end(), begun.begin(), begun.end());
  if (plan.held_back == 0) {
    int fresh = settings.new_per_day - plan.new_done;
    for (const char32_t character : learning_order) {
      if (fresh <= 0) break;
      const auto known = learner.cards().find(character);
      if (known != learner.cards().end()) {
        const Card& card = known->second;
        if (card.introduced || card.paused || (card.postponed_until && *card.postponed_until > today))
          continue;
      }
      plan.now.push_back({TaskKind::fresh, character, Stage::watch, learner.calendar().begin_of(today), 0});
      --fresh;
    }
  }
  // With nothing else to do, a step that is nearly due is offered now.
  if (plan.now.empty()) {
    while (!plan.later_today.empty() && plan.later_today.front().due <= now + kAhead) {
      plan.now.push_back(plan.later_today.front());
      plan.later_today.erase(plan.later_today.begin());
    }
  }
  for (const StudyTask& task : plan.now) plan.estimate += time_for(task, past->pace);
  return plan;
}

}  // namespace nazori::study
