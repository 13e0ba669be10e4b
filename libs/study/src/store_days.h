// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <span>

#include "nazori/study/study_days.h"

namespace nazori::study {

// The tables character_day and study_day are computed from the log. With them the cost of a day's queries
// does not depend on the length of the history. All functions throw SQLite::Exception; the caller has opened
// the transaction.

/// Updates the rows of one character to `days` and computes the sums of the changed study days again. Writes
/// only the rows that differ.
void put_character_days(SQLite::Database& db, char32_t character, std::span<const CharacterDay> days);

/// Computes both tables from the whole log.
void rebuild_days(SQLite::Database& db);

}  // namespace nazori::study
