// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/study/time.h"

namespace nazori::study {

/// Automatic backups kept: one a study day, the newest ones.
inline constexpr int kBackupsKept = 7;
/// Files kept that a restored backup has replaced, the newest ones: each is as large as the learner's.
inline constexpr int kReplacedKept = 3;

/// A backup of a learner.db.
struct Backup {
  std::filesystem::path file;
  std::uintmax_t bytes = 0;
  bool automatic = false;  ///< one of the daily ones

  friend bool operator==(const Backup&, const Backup&) = default;
};

/// The folder "backups" beside a learner.db.
[[nodiscard]] std::filesystem::path backup_folder(const std::filesystem::path& learner);

/// All backups beside a learner.db, newest first.
[[nodiscard]] std::vector<Backup> backups_of(const std::filesystem::path& learner);

class LearnerStore;

/// What keep_up() found besides a sound file.
struct UpkeepReport {
  std::optional<base::Error> backup_trouble;  ///< why today's backup could not be made
};

/// Checks the whole learner.db and makes today's backup where there is none yet, through a connection of its
/// own: a store on another thread, or in another program, may write meanwhile. A second per 500 MB and more.
/// @param day  the learner's study day.
/// @return Errc::parse where the file is damaged; Errc::schema, Errc::io as LearnerStore::open() says;
/// Errc::cancelled.
[[nodiscard]] base::Result<UpkeepReport> keep_up(const std::filesystem::path& learner, Day day,
                                                 const base::Progress& progress = {});

/// Makes a backup besides the daily ones. @param file  the learner's own, which has the backups beside it.
/// @return the backup; Errc::not_found where nothing is studied yet; Errc::io; Errc::cancelled.
[[nodiscard]] base::Result<std::filesystem::path> make_backup(const LearnerStore& learner,
                                                              const std::filesystem::path& file,
                                                              const base::Progress& progress = {});

/// What can be found in a backup.
struct BackupContents {
  int writings = 0;  ///< in force
  int characters = 0;
  std::optional<Day> last_day;  ///< with a writing
  Time last{};                  ///< its moment

  friend bool operator==(const BackupContents&, const BackupContents&) = default;
};

/// Reads a backup whole and leaves nothing beside it. @return as LearnerStore::open() says of a file to read.
[[nodiscard]] base::Result<BackupContents> look_into(const std::filesystem::path& backup);

/// Puts a backup in the place of a learner.db, which may be damaged or missing. The backup is read whole
/// first; what stood there is kept beside the backups as "before-restore-...", so this too can be taken back;
/// the oldest of those go, but for kReplacedKept.
/// Killed at any moment it leaves a whole learner.db: what stood there, or the backup.
/// @return the file that holds what stood there, empty where nothing did; Errc::not_found, Errc::schema,
/// Errc::parse for a backup that cannot be used, Errc::io, Errc::in_use where another program has the
/// learner's file open, Errc::cancelled. Nothing is changed then.
[[nodiscard]] base::Result<std::filesystem::path> restore_backup(const std::filesystem::path& backup,
                                                                 const std::filesystem::path& learner,
                                                                 const Clock& clock = system_now,
                                                                 const base::Progress& progress = {});

}  // namespace nazori::study
