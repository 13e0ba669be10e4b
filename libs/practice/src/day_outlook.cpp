// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/day_outlook.h"

#include <algorithm>
#include <vector>

namespace nazori::practice {

DayOutlook outlook_of(const study::LearnerStore& learner, const study::DayPlan& plan) {
  using Kind = DayOutlook::Kind;
  if (!plan.later_today.empty())
    return {Kind::later_today, static_cast<int>(plan.later_today.size()), plan.later_today.front().due};
  if (plan.held_back > 0) return {Kind::limit_reached, plan.held_back, {}};
  const auto& cards = learner.cards();
  if (cards.empty()) return {Kind::nothing_to_learn, 0, {}};
  const study::Day next_day = plan.day + std::chrono::days(1);
  const auto tomorrow = std::count_if(cards.begin(), cards.end(), [&](const auto& one) {
    const study::Card& card = one.second;
    if (card.paused || card.leech || card.postponed_until > next_day) return false;
    if (card.postponed_until != next_day) return card.due_day == next_day;
    return card.memory.reps > 0 && card.due_day.value_or(next_day) <= next_day;
  });
  if (tomorrow > 0) return {Kind::reviews_tomorrow, static_cast<int>(tomorrow), {}};
  return {learner.settings().new_per_day > 0 ? Kind::new_tomorrow : Kind::nothing_tomorrow, 0, {}};
}

PartOfDay part_of_day(const study::LearnerStore& learner) {
  constexpr std::chrono::hours kNoon{12};
  constexpr std::chrono::hours kEvening{18};
  const auto since_midnight = learner.now() - learner.calendar().begin_of(learner.today()) +
                              std::chrono::hours(learner.settings().day_starts_at);
  if (since_midnight < kNoon) return PartOfDay::morning;
  return since_midnight < kEvening ? PartOfDay::afternoon : PartOfDay::evening;
}

study::Streak streak_now(const study::LearnerStore& learner) {
  std::vector<study::Day> all;
  if (const auto days = learner.study_days()) {
    all.reserve(days->size());
    for (const study::StudyDay& day : *days)
      if (day.writings > 0) all.push_back(day.day);
  }
  return study::streak_of(all, learner.today());
}

}  // namespace nazori::practice
