// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/study/character_lists.h"
#include "nazori/study/learner_store.h"

namespace nazori::practice {

/// The members of a list; what was studied so far where its id is empty.
/// @param id  as study::CharacterLists::members() reads it.
/// @param lists  may be nullptr: there is no kanji database.
/// @return Errc::not_found for a list that is gone; else as LearnerStore::lists() says.
[[nodiscard]] base::Result<std::vector<char32_t>> list_members(const std::string& id,
                                                               study::CharacterLists* lists,
                                                               const study::LearnerStore& store);

}  // namespace nazori::practice
