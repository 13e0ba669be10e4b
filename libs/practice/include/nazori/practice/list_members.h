// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/study/character_lists.h"
#include "nazori/study/learner_store.h"

namespace nazori::practice {

/// The members of a list; for an empty id, all studied characters.
/// @param id  as study::CharacterLists::members() reads it.
/// @param lists  may be nullptr: without a kanji database.
/// @return Errc::not_found for a list that no longer exists; else the errors of LearnerStore::lists().
[[nodiscard]] base::Result<std::vector<char32_t>> list_members(const std::string& id,
                                                               study::CharacterLists* lists,
                                                               const study::LearnerStore& store);

}  // namespace nazori::practice
