// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/list_members.h"

namespace nazori::practice {

base::Result<std::vector<char32_t>> list_members(const std::string& id, study::CharacterLists* lists,
                                                 const study::LearnerStore& store) {
  if (!id.empty()) {
    if (lists == nullptr)
      return base::fail(base::Errc::not_found, "there is no kanji database to take it from", id);
    return lists->members(id, store);
  }
  std::vector<char32_t> studied;
  studied.reserve(store.cards().size());
  for (const auto& [character, card] : store.cards()) studied.push_back(character);
  return studied;
}

}  // namespace nazori::practice
