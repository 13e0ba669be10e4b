// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/backups.h"

#include <SQLiteCpp/Backup.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "daily_backup.h"
#include "nazori/base/file_lock.h"
#include "nazori/base/unfinished_file.h"
#include "nazori/study/learner_store.h"
#include "store_schema.h"

namespace nazori::study {
namespace {

namespace fs = std::filesystem;
using base::Errc;

constexpr std::string_view kDaily = "daily-";
constexpr std::string_view kReplaced = "before-restore";
constexpr std::string_view kPart = ".part";
constexpr std::string_view kExtension = ".db";
constexpr int kPagesAtOnce = 1'024;
constexpr int kPagesBetweenFlushes = 4'096;

bool is_daily(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(kDaily) || !name.ends_with(kExtension)) return false;
  return parse_day(
             std::string_view(name).substr(kDaily.size(), name.size() - kDaily.size() - kExtension.size()))
      .has_value();
}

/// Flushes it to the disk.
base::Result<void> flush(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = descriptor >= 0 && ::fsync(descriptor) == 0;
  const int number = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (done) return {};
  return base::fail(Errc::io, "cannot be written: " + std::generic_category().message(number), path.string());
}

/// "20261121T134206Z"
std::string stamp(Time time) {
  std::string text = to_text(time).substr(0, 19) + "Z";
  std::erase(text, '-');
  std::erase(text, ':');
  return text;
}

/// The name of a file that does not exist yet: "own-20261121T134206Z.db".
fs::path free_file(const fs::path& folder, std::string_view kind, Time time) {
  const std::string name = fmt::format("{}-{}", kind, stamp(time));
  fs::path file = folder / (name + std::string(kExtension));
  std::error_code error;
  for (int copy = 2; fs::exists(file, error); ++copy)
    file = folder / fmt::format("{}-{}{}", name, copy, kExtension);
  return file;
}

/// Removes a database and the journals of SQLite beside it.
void remove_database(const fs::path& file) {
  std::error_code gone_already;
  for (const char* part : {"", "-journal", "-wal", "-shm"}) fs::remove(file.string() + part, gone_already);
}

/// Removes unfinished daily copies of a killed program. Only a program that has the learner's lock makes such
/// copies, so no other one is at work.
void remove_unfinished(const fs::path& learner) {
  std::error_code error;
  std::vector<fs::path> unfinished;
  for (const auto& entry : fs::directory_iterator(backup_folder(learner), error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(kDaily) && name.find(fmt::format("{}{}", kExtension, kPart)) != std::string::npos)
      unfinished.push_back(entry.path());
  }
  for (const fs::path& file : unfinished) fs::remove(file, error);
}

fs::path restored_beside(const fs::path& learner) { return learner.string() + ".restored"; }

struct DatedBackup {
  Backup backup;
  fs::file_time_type time;
};

/// The newest first.
std::vector<DatedBackup> dated_backups(const fs::path& learner) {
  std::vector<DatedBackup> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(backup_folder(learner), error)) {
    if (!entry.is_regular_file(error) || entry.path().extension() != kExtension) continue;
    found.push_back(
        {{entry.path(), entry.file_size(error), is_daily(entry.path())}, entry.last_write_time(error)});
  }
  std::sort(found.begin(), found.end(), [](const DatedBackup& a, const DatedBackup& b) {
    return a.time != b.time ? a.time > b.time : a.backup.file.filename() > b.backup.file.filename();
  });
  return found;
}

/// Removes the oldest backups of one kind until `most` are left, but never those in `kept`, the first of
/// which was made just now. The age is the time of the file, because the names follow a clock that may have
/// been set back.
template <class IsOfKind>
void let_oldest_go(const fs::path& learner, int most, const std::vector<fs::path>& kept,
                   IsOfKind is_of_kind) {
  std::error_code error;
  const fs::file_time_type now = fs::last_write_time(kept.front(), error);
  if (error) return;
  std::vector<DatedBackup> all = dated_backups(learner);
  std::erase_if(all, [&](const DatedBackup& one) { return !is_of_kind(one.backup.file); });
  // A file with a time in the future was made before the clock was set back.
  std::stable_partition(all.begin(), all.end(), [now](const DatedBackup& one) { return one.time <= now; });
  auto left = static_cast<std::ptrdiff_t>(all.size());
  for (auto one = all.rbegin(); one != all.rend() && left > most; ++one) {
    if (std::find(kept.begin(), kept.end(), one->backup.file) != kept.end()) continue;
    remove_database(one->backup.file);
    --left;
  }
}

/// Writes the content of the write-ahead log into its file, if both are valid.
void take_in_log(const fs::path& database) {
  try {
    SQLite::Database db(database.string(), SQLite::OPEN_READWRITE);
    db.exec("PRAGMA wal_checkpoint(TRUNCATE)");
  } catch (const SQLite::Exception&) {
    // A damaged file and its log are kept unchanged.
  }
}

/// Keeps the file `learner` also as `kept`. It stays in its place, so that there is a file at any moment;
/// only on a file system without links it is missing for a moment.
bool keep_as(const fs::path& learner, const fs::path& kept) {
  take_in_log(learner);
  std::error_code error;
  // A log that could not be written into its file is kept with it; its index can always be rebuilt.
  const fs::path log = learner.string() + "-wal";
  if (fs::exists(log, error)) {
    if (fs::file_size(log, error) > 0) {
      fs::rename(log, kept.string() + "-wal", error);
    } else {
      fs::remove(log, error);
    }
  }
  fs::remove(learner.string() + "-shm", error);
  fs::create_hard_link(learner, kept, error);
  if (error) fs::rename(learner, kept, error);
  return !error;
}

}  // namespace

fs::path backup_folder(const fs::path& learner) { return learner.parent_path() / "backups"; }

std::vector<Backup> backups_of(const fs::path& learner) {
  std::vector<Backup> backups;
  for (DatedBackup& one : dated_backups(learner)) backups.push_back(std::move(one.backup));
  return backups;
}

base::Result<void> copy_database(SQLite::Database& database, const fs::path& file,
                                 const base::Progress& progress) {
  const fs::path beside = fmt::format("{}{}", file.string(), kPart);
  std::error_code error;
  remove_database(beside);
  base::UnfinishedFile unfinished(beside, base::UnfinishedKind::database);
  auto copied = [&]() -> base::Result<void> {
    try {
      SQLite::Database target(beside.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      SQLite::Backup backup(target, database);
      int flushed = 0;
      for (int step = SQLITE_OK; step != SQLITE_DONE;) {
        step = backup.executeStep(kPagesAtOnce);
        if (step == SQLITE_BUSY || step == SQLITE_LOCKED)
          return base::fail(Errc::io, "cannot be copied: it is in use", file.string(), "try again");
        const double all = std::max(1, backup.getTotalPageCount());
        if (progress && !progress(1 - backup.getRemainingPageCount() / all, "copy"))
          return base::fail(Errc::cancelled, "stopped", file.string());
        // While the system writes hundreds of megabytes at once, not even a signal ends the program. This
        // also releases SQLite's lock on the file, which no other program uses.
        const int copied_pages = backup.getTotalPageCount() - backup.getRemainingPageCount();
        if (copied_pages - flushed < kPagesBetweenFlushes) continue;
        flushed = copied_pages;
        if (auto done = flush(beside); !done) return done;
      }
      // A copy of a file in WAL mode is in WAL mode, too; a backup must be a single file.
      (void)target.execAndGet("PRAGMA journal_mode = DELETE");
    } catch (const SQLite::Exception& trouble) {
      return tl::unexpected(error_of(trouble, file.string()));
    }
    return flush(beside);
  }();
  if (copied) {
    fs::rename(beside, file, error);
    if (error) copied = base::fail(Errc::io, "cannot be written: " + error.message(), file.string());
  }
  if (copied)
    unfinished.finish();
  else
    remove_database(beside);
  return copied;
}

void clear_unfinished_restore(const fs::path& learner) {
  const fs::path beside = restored_beside(learner);
  remove_database(beside);
  remove_database(fmt::format("{}{}", beside.string(), kPart));
}

base::Result<void> keep_daily_backup(SQLite::Database& database, const fs::path& learner, Day day,
                                     const base::Progress& progress) {
  const fs::path folder = backup_folder(learner);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return base::fail(Errc::io, "cannot be created: " + error.message(), folder.string());
  const fs::path file = folder / fmt::format("{}{}{}", kDaily, to_text(day), kExtension);
  if (fs::exists(file, error)) return {};
  remove_unfinished(learner);
  if (auto made = copy_database(database, file, progress); !made) return made;
  let_oldest_go(learner, kBackupsKept, {file}, is_daily);
  return {};
}

base::Result<void> keep_backup_before_migration(SQLite::Database& database, const fs::path& learner,
                                                int version) {
  const fs::path folder = backup_folder(learner);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return base::fail(Errc::io, "cannot be created: " + error.message(), folder.string());
  return copy_database(database, folder / fmt::format("before-version-{}{}", version + 1, kExtension));
}

base::Result<fs::path> make_backup(const LearnerStore& learner, const fs::path& file,
                                   const base::Progress& progress) {
  if (learner.last_entry() == 0) return base::fail(Errc::not_found, "nothing studied yet", file.string());
  const fs::path folder = backup_folder(file);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return base::fail(Errc::io, "cannot be created: " + error.message(), folder.string());
  fs::path backup = free_file(folder, "own", learner.now());
  if (auto done = learner.copy_to(backup, progress); !done) return tl::unexpected(std::move(done.error()));
  return backup;
}

base::Result<BackupContents> look_into(const fs::path& backup) {
  std::error_code error;
  if (!fs::is_regular_file(backup, error))
    return base::fail(Errc::not_found, "this backup does not exist", backup.string());
  const auto learner = LearnerStore::open(backup, Access::backup);
  if (!learner) return tl::unexpected(learner.error());
  BackupContents contents;
  auto read = learner->for_each_entry(true, [&](const LearnerStore::LoggedEntry& logged) {
    if (logged.entry.kind != EntryKind::writing) return true;
    ++contents.writings;
    contents.last_day = logged.entry.day;
    contents.last = logged.entry.at;
    return true;
  });
  if (!read) return tl::unexpected(std::move(read.error()));
  contents.characters = static_cast<int>(learner->cards().size());
  return contents;
}

base::Result<fs::path> restore_backup(const fs::path& backup, const fs::path& learner, const Clock& clock,
                                      const base::Progress& progress) {
  std::error_code error;
  if (!fs::is_regular_file(backup, error)) {
    return base::fail(Errc::not_found, "this backup does not exist", backup.string(),
                      "list backups with: nazori-cli study restore --list");
  }
  if (learner.has_parent_path()) fs::create_directories(learner.parent_path(), error);
  bool is_locked = false;
  const auto lock = base::FileLock::take(learner.string() + ".lock", is_locked);
  if (is_locked)
    return base::fail(Errc::in_use, "is open in another Nazori window", learner.string(),
                      "close it there first");
  if (!lock) return tl::unexpected(lock.error());

  clear_unfinished_restore(learner);
  const fs::path beside = restored_beside(learner);
  base::UnfinishedFile unfinished(beside, base::UnfinishedKind::database);
  {
    // Read like a learner's file, so that the restored file is known to open.
    auto source = LearnerStore::open(backup, Access::backup, clock);
    if (!source) return tl::unexpected(std::move(source.error()));
    if (auto copied = source->copy_to(beside, progress); !copied)
      return tl::unexpected(std::move(copied.error()));
  }
  fs::path kept;
  if (fs::exists(learner, error)) {
    const fs::path folder = backup_folder(learner);
    fs::create_directories(folder, error);
    kept = free_file(folder, kReplaced, clock());
    if (!keep_as(learner, kept)) {
      return base::fail(Errc::io, "cannot be moved aside", learner.string(),
                        "check the permissions of the folder");
    }
  }
  fs::rename(beside, learner, error);
  if (error) {
    std::error_code ignored;
    if (!fs::exists(learner, ignored)) fs::rename(kept, learner, ignored);
    return base::fail(Errc::io, "cannot be written: " + error.message(), learner.string());
  }
  unfinished.finish();
  if (!kept.empty()) {
    let_oldest_go(learner, kReplacedKept, {kept, backup},
                  [](const fs::path& one) { return one.filename().string().starts_with(kReplaced); });
  }
  return kept;
}

}  // namespace nazori::study
