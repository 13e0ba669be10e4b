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

/// Number of automatic backups that are kept: the newest ones, one per study day.
inline constexpr int kBackupsKept = 7;
/// Number of replaced files that are kept after restoring backups, the newest ones: each is as large as the
/// learner's file.
inline constexpr int kReplacedKept = 3;

/// A backup of a learner.db.
struct Backup {
  std::filesystem::path file;
  std::uintmax_t bytes = 0;
  bool automatic = false;  ///< whether it is one of the daily ones

  friend bool operator==(const Backup&, const Backup&) = default;
};

/// The folder "backups" beside a learner.db.
[[nodiscard]] std::filesystem::path backup_folder(const std::filesystem::path& learner);

/// All backups beside a learner.db, newest first.
[[nodiscard]] std::vector<Backup> backups_of(const std::filesystem::path& learner);

class LearnerStore;

/// The result of keep_up() for a valid file.
struct UpkeepReport {
  std::optional<base::Error> backup_trouble;  ///< why today's backup could not be made
};

/// Checks the whole learner.db and makes today's backup where there is none yet, through a separate
/// connection: a store on another thread or in another program may write meanwhile. Takes at least a second
/// per 500 MB.
/// @param day  the learner's study day.
/// @return Errc::parse where the file is damaged; Errc::schema, Errc::io as LearnerStore::open();
/// Errc::cancelled.
[[nodiscard]] base::Result<UpkeepReport> keep_up(const std::filesystem::path& learner, Day day,
                                                 const base::Progress& progress = {});

/// Makes a backup besides the daily ones. @param file  the learner's file; the backups are in the same
/// folder.
/// @return the backup; Errc::not_found where nothing is studied yet; Errc::io; Errc::cancelled.
[[nodiscard]] base::Result<std::filesystem::path> make_backup(const LearnerStore& learner,
                                                              const std::filesystem::path& file,
                                                              const base::Progress& progress = {});

/// The content of a backup, summarised.
struct BackupContents {
  int writings = 0;  ///< in force
  int characters = 0;
  std::optional<Day> last_day;  ///< with a writing
  Time last{};                  ///< its moment

  friend bool operator==(const BackupContents&, const BackupContents&) = default;
};

/// Reads a whole backup and leaves no other files. @return as LearnerStore::open() for reading.
[[nodiscard]] base::Result<BackupContents> look_into(const std::filesystem::path& backup);

/// Replaces a learner.db, which may be damaged or missing, by a backup. First the whole backup is read. The
/// replaced file is kept with the backups as "before-restore-...", so restoring can be undone, too. Of these
/// files the newest kReplacedKept are kept. If the program is killed at any moment there is a valid
/// learner.db: the old one or the backup.
/// @return the file that contains the replaced data, empty where there were none; Errc::not_found,
/// Errc::schema, Errc::parse for a backup that cannot be used, Errc::io, Errc::in_use where another program
/// has the learner's file open, Errc::cancelled. On an error nothing is changed.
[[nodiscard]] base::Result<std::filesystem::path> restore_backup(const std::filesystem::path& backup,
                                                                 const std::filesystem::path& learner,
                                                                 const Clock& clock = system_now,
                                                                 const base::Progress& progress = {});

}  // namespace nazori::study
