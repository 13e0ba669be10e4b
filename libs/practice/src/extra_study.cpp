// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/extra_study.h"

#include <algorithm>
#include <tuple>

#include "nazori/study/pace.h"

namespace nazori::practice {

base::Result<std::vector<char32_t>> new_characters(Learner& learner, std::size_t most) {
  const auto order = learner.learning_order();
  if (!order) return tl::unexpected(order.error());
  const auto& store = learner.store();
  std::vector<char32_t> found;
  for (const char32_t character : *order) {
    if (found.size() >= most) break;
    const auto known = store.cards().find(character);
    if (known != store.cards().end()) {
      const study::Card& card = known->second;
      if (card.introduced || card.paused || (card.postponed_until && *card.postponed_until > store.today()))
        continue;
    }
    found.push_back(character);
  }
  return found;
}

std::vector<char32_t> reviews_ahead(const study::LearnerStore& store, std::size_t most) {
  const study::Day today = store.today();
  std::vector<std::tuple<study::Day, double, char32_t>> coming;
  for (const auto& [character, card] : store.cards()) {
    if (card.paused || card.leech || card.memory.phase != study::Phase::review || !card.due_day) continue;
    if (*card.due_day <= today || (card.postponed_until && *card.postponed_until > today)) continue;
    coming.emplace_back(*card.due_day, card.memory.stability, character);
  }
  std::sort(coming.begin(), coming.end());
  if (coming.size() > most) coming.resize(most);
  std::vector<char32_t> characters;
  characters.reserve(coming.size());
  for (const auto& [day, stability, character] : coming) characters.push_back(character);
  return characters;
}

base::Result<ReviewsNow> reviews_now(const study::LearnerStore& store, const study::DayPlan& plan) {
  const auto pace = study::pace_of(store);
  if (!pace) return tl::unexpected(pace.error());
  ReviewsNow reviews;
  reviews.estimate = plan.estimate - pace->introduced * plan.count(study::TaskKind::fresh);
  for (const auto& task : plan.now)
    if (task.kind != study::TaskKind::fresh) reviews.characters.push_back(task.character);
  return reviews;
}

}  // namespace nazori::practice
