// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <map>
#include <vector>

#include "nazori/kanji/character.h"

namespace nazori::kanji {

/// Characters that people made, by how they are used.
struct OwnForms {
  std::vector<Character> beside;           ///< the published ones
  std::map<char32_t, Character> replaced;  ///< used instead of a published one, by its code point
};
/// Sorts own characters by how they are used. One whose published character is not in the database stands
/// beside the others.
[[nodiscard]] OwnForms sorted_forms(SQLite::Database& db, std::vector<Character> own);

/// Adds own characters to what a connection finds: temporary views stand before the tables of the file and
/// join its rows with those of the own characters. Their places come after all others, but a form that takes
/// the place of a published one has that one's. Only what is searched and listed is added: a whole own
/// character is kept beside the connection.
void add_own_rows(SQLite::Database& db, const OwnForms& own);

}  // namespace nazori::kanji
