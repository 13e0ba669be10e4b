// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <span>

#include "nazori/kanji/character.h"

namespace nazori::kanji {

/// Adds own characters to what a connection finds: temporary views stand before the tables of the file and
/// join its rows with those of the own characters. Their places come after all others. Only what is searched
/// and listed is added: a whole own character is kept beside the connection.
void add_own_rows(SQLite::Database& db, std::span<const Character> own);

}  // namespace nazori::kanji
