// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nazori/practice/learner.h"
#include "nazori/study/card.h"
#include "nazori/study/statistics.h"

namespace nazori::practice {

/// How far a learner is with one character.
struct CharacterStanding {
  study::Strength strength = study::Strength::unseen;
  double recall = 0;         ///< probability that it is remembered now, 0..1; 0 if it was never reviewed
  bool comes_again = false;  ///< it is scheduled: `card` says when
  bool is_due = false;       ///< now, or since a while
  study::Card card;
  study::Time now{};
  study::Day today{};
};
[[nodiscard]] CharacterStanding standing_of(const study::LearnerStore& store, char32_t character);

/// Marks a character as known, which makes it come after about a week to be written from memory. A character
/// that was suspended, or forgotten too often, comes again. It does not count as a writing of the day, and
/// one undo takes it back.
/// @return whether it was saved; why not is announced by the learner.
bool mark_known(Learner& learner, char32_t character);

/// The names of the learner's own lists, and whether the character is in each.
struct ListMembership {
  std::string name;
  bool contains = false;

  friend bool operator==(const ListMembership&, const ListMembership&) = default;
};
/// @return nothing where the lists cannot be read, which the learner announces.
[[nodiscard]] std::optional<std::vector<ListMembership>> list_memberships(Learner& learner,
                                                                          char32_t character);

/// Puts a character at the end of one of the learner's own lists, or takes it out; a list that does not exist
/// is made. The learning order is computed again.
/// @return whether it was saved; why not is announced by the learner.
bool set_in_list(Learner& learner, const std::string& name, char32_t character, bool contains);

}  // namespace nazori::practice
