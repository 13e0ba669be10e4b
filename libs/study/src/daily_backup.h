// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/study/time.h"

namespace nazori::study {

/// Copies a database into a file, by way of a file beside it.
[[nodiscard]] base::Result<void> copy_database(SQLite::Database& database, const std::filesystem::path& file,
                                               const base::Progress& progress = {});

/// Makes today's backup if there is none, and lets the oldest daily ones go.
[[nodiscard]] base::Result<void> keep_daily_backup(SQLite::Database& database,
                                                   const std::filesystem::path& learner, Day day,
                                                   const base::Progress& progress = {});
/// Removes what a restore that was killed has left. Only for the holder of the learner's lock.
void clear_unfinished_restore(const std::filesystem::path& learner);
/// Makes a backup of a file that is about to get a newer layout.
[[nodiscard]] base::Result<void> keep_backup_before_migration(SQLite::Database& database,
                                                              const std::filesystem::path& learner,
                                                              int version);

}  // namespace nazori::study
