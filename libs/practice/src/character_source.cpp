// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_source.h"

#include "nazori/author/collection.h"

namespace nazori::practice {

base::Result<bool> CharacterBook::look() {
  const author::Collection own(source_.own);
  // Read before the characters: what changes meanwhile is noticed by the next look.
  const auto changed_at = own.changed_at();
  if (database_ && changed_at == own_of_) return false;
  auto opened = author::open_with_own(source_.database, own);
  if (!opened) {
    database_.reset();
    return tl::unexpected(std::move(opened.error()));
  }
  if (database_)
    *database_ = *std::move(opened);
  else
    database_.emplace(*std::move(opened));
  own_of_ = changed_at;
  return true;
}

}  // namespace nazori::practice
