// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_choice.h"

#include <algorithm>
#include <span>
#include <utility>

#include "nazori/study/day_plan.h"
#include "nazori/study/fsrs.h"

namespace nazori::practice {

CharacterStanding standing_of(const study::LearnerStore& store, char32_t character) {
  CharacterStanding out;
  out.card = store.card(character);
  out.strength = study::strength_of(out.card);
  out.now = store.now();
  out.today = store.today();
  const auto& memory = out.card.memory;
  if (memory.phase == study::Phase::fresh) return out;
  if (const auto fsrs = study::Fsrs::create(store.settings().fsrs))
    out.recall = study::retrievability_now(out.card, *fsrs, out.today);
  out.comes_again = !out.card.paused && !out.card.leech;
  if (!out.comes_again) return out;
  const bool is_reached = memory.phase == study::Phase::review
                              ? out.card.due_day && *out.card.due_day <= out.today
                              : memory.due <= out.now;
  out.is_due = is_reached && (!out.card.postponed_until || *out.card.postponed_until <= out.today);
  return out;
}

bool mark_known(Learner& learner, char32_t character) {
  const study::KnownCharacter known{character, std::nullopt};
  return learner.report(learner.store().know(std::span(&known, 1)));
}

std::optional<std::vector<ListMembership>> list_memberships(Learner& learner, char32_t character) {
  const auto lists = learner.store().lists();
  if (!lists) {
    learner.announce_unread(lists.error());
    return std::nullopt;
  }
  std::vector<ListMembership> out;
  for (const auto& list : *lists)
    out.push_back({list.name, std::find(list.characters.begin(), list.characters.end(), character) !=
                                  list.characters.end()});
  return out;
}

bool set_in_list(Learner& learner, const std::string& name, char32_t character, bool contains) {
  auto& store = learner.store();
  const auto lists = store.lists();
  // A list that cannot be read must not be replaced.
  if (!lists) {
    learner.announce_unread(lists.error());
    return false;
  }
  study::CustomList list{name, {}};
  const auto known =
      std::find_if(lists->begin(), lists->end(), [&name](const auto& one) { return one.name == name; });
  if (known != lists->end()) list = *known;
  std::erase(list.characters, character);
  if (contains) list.characters.push_back(character);
  if (!learner.report(store.save_list(list))) return false;
  learner.renew_order();
  return true;
}

}  // namespace nazori::practice
