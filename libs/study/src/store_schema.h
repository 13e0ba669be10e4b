// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/study/time.h"

namespace nazori::study {

/// PRAGMA application_id of a learner.db: "NZLN".
inline constexpr std::int32_t kLearnerApplicationId = 0x4E5A4C4E;
/// PRAGMA user_version; goes up with every change of the layout or of what a column means.
inline constexpr std::int32_t kLearnerVersion = 4;

/// Whether the file is a learner.db this program can read. A file without any table is a new one.
/// @return its version, 0 for a new one; Errc::schema.
[[nodiscard]] base::Result<int> check_store(SQLite::Database& database, const std::string& name);

/// Reads every page of the file. @return Errc::parse where one is damaged; Errc::cancelled.
[[nodiscard]] base::Result<void> check_pages(SQLite::Database& database, const std::string& name,
                                             const base::Progress& progress = {});

/// Upgrades the layout from `version` (0: empty file) to the present one, in one transaction. Throws
/// SQLite::Exception.
void migrate_store(SQLite::Database& database, int version, Time now);

/// An error message of SQLite, for people. `name`: the file.
[[nodiscard]] base::Error error_of(const SQLite::Exception& trouble, const std::string& name);

}  // namespace nazori::study
