// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <span>

#include "nazori/study/study_days.h"

namespace nazori::study {

// The tables character_day and study_day follow from the log. They make what a day needs cost the same with a
// short and a long history. All functions throw SQLite::Exception; the caller holds the transaction.

/// Brings the rows of one character to `days` and adds the study days that changed up again. Writes only the
/// rows that differ.
void put_character_days(SQLite::Database& db, char32_t character, std::span<const CharacterDay> days);

/// Works both tables out from the whole log.
void rebuild_days(SQLite::Database& db);

}  // namespace nazori::study
