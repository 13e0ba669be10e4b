// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/study/time.h"

namespace nazori::study {

/// Copies a database into a file, through a temporary file in the same folder.
[[nodiscard]] base::Result<void> copy_database(SQLite::Database& database, const std::filesystem::path& file,
                                               const base::Progress& progress = {});

/// Makes today's backup if there is none, and removes the oldest daily ones.
[[nodiscard]] base::Result<void> keep_daily_backup(SQLite::Database& database,
                                                   const std::filesystem::path& learner, Day day,
                                                   const base::Progress& progress = {});
/// Removes the files of a killed restore. Call it only with the learner's lock.
void clear_unfinished_restore(const std::filesystem::path& learner);
/// Makes a backup of a file that is about to be upgraded.
[[nodiscard]] base::Result<void> keep_backup_before_migration(SQLite::Database& database,
                                                              const std::filesystem::path& learner,
                                                              int version);

}  // namespace nazori::study
