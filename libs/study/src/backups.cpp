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
#include "file_lock.h"
#include "nazori/base/unfinished_file.h"
#include "nazori/study/learner_store.h"
#include "store_schema.h"

namespace nazori::study {
namespace {

namespace fs = std::filesystem;
using base::Errc;

constexpr std::string_view kDaily = "daily-";
constexpr std::string_view kExtension = ".db";
constexpr int kPagesAtOnce = 1'024;

bool is_daily(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(kDaily) || !name.ends_with(kExtension)) return false;
  return parse_day(
             std::string_view(name).substr(kDaily.size(), name.size() - kDaily.size() - kExtension.size()))
      .has_value();
}

/// On disk, not only on its way there.
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

/// A file that is not there yet: "own-20261121T134206Z.db".
fs::path free_file(const fs::path& folder, std::string_view kind, Time time) {
  const std::string name = fmt::format("{}-{}", kind, stamp(time));
  fs::path file = folder / (name + std::string(kExtension));
  std::error_code error;
  for (int copy = 2; fs::exists(file, error); ++copy)
    file = folder / fmt::format("{}-{}{}", name, copy, kExtension);
  return file;
}

/// Brings what the write-ahead log holds into its file, where both are sound.
void take_in_log(const fs::path& database) {
  try {
    SQLite::Database db(database.string(), SQLite::OPEN_READWRITE);
    db.exec("PRAGMA wal_checkpoint(TRUNCATE)");
  } catch (const SQLite::Exception&) {
    // A damaged file is kept with its log as they are.
  }
}

/// Keeps what stands at `learner` as `kept`, too. It stays there, so that there is a file at any moment; only
/// where the file system has no links it is gone for one.
bool keep_as(const fs::path& learner, const fs::path& kept) {
  take_in_log(learner);
  std::error_code error;
  for (const char* part : {"-wal", "-shm"}) {
    const fs::path from = learner.string() + part;
    if (fs::exists(from, error)) fs::rename(from, kept.string() + part, error);
  }
  fs::create_hard_link(learner, kept, error);
  if (error) fs::rename(learner, kept, error);
  return !error;
}

}  // namespace

fs::path backup_folder(const fs::path& learner) { return learner.parent_path() / "backups"; }

std::vector<Backup> backups_of(const fs::path& learner) {
  struct Dated {
    Backup backup;
    fs::file_time_type time;
  };
  std::vector<Dated> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(backup_folder(learner), error)) {
    if (!entry.is_regular_file(error) || entry.path().extension() != kExtension) continue;
    found.push_back(
        {{entry.path(), entry.file_size(error), is_daily(entry.path())}, entry.last_write_time(error)});
  }
  std::sort(found.begin(), found.end(), [](const Dated& a, const Dated& b) {
    return a.time != b.time ? a.time > b.time : a.backup.file.filename() > b.backup.file.filename();
  });
  std::vector<Backup> backups;
  backups.reserve(found.size());
  for (Dated& one : found) backups.push_back(std::move(one.backup));
  return backups;
}

base::Result<void> copy_database(SQLite::Database& database, const fs::path& file,
                                 const base::Progress& progress) {
  const fs::path beside = file.string() + ".part";
  std::error_code error;
  fs::remove(beside, error);
  base::UnfinishedFile unfinished(beside, base::UnfinishedKind::database);
  auto copied = [&]() -> base::Result<void> {
    try {
      SQLite::Database target(beside.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      SQLite::Backup backup(target, database);
      for (int step = SQLITE_OK; step != SQLITE_DONE;) {
        step = backup.executeStep(kPagesAtOnce);
        if (step == SQLITE_BUSY || step == SQLITE_LOCKED)
          return base::fail(Errc::io, "cannot be copied: it is in use", file.string(), "try again");
        const double all = std::max(1, backup.getTotalPageCount());
        if (progress && !progress(1 - backup.getRemainingPageCount() / all, "copy"))
          return base::fail(Errc::cancelled, "stopped", file.string());
      }
      // A copy of a WAL file is one too; a backup shall be a single file.
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
  if (copied) unfinished.finish();
  return copied;
}

base::Result<void> keep_daily_backup(SQLite::Database& database, const fs::path& learner, Day day) {
  const fs::path folder = backup_folder(learner);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return base::fail(Errc::io, "cannot be made: " + error.message(), folder.string());
  const fs::path file = folder / fmt::format("{}{}{}", kDaily, to_text(day), kExtension);
  if (fs::exists(file, error)) return {};
  if (auto made = copy_database(database, file); !made) return made;
  std::vector<fs::path> daily;
  for (const Backup& backup : backups_of(learner)) {
    if (backup.automatic) daily.push_back(backup.file);
  }
  std::sort(daily.begin(), daily.end());
  while (daily.size() > static_cast<std::size_t>(kBackupsKept)) {
    fs::remove(daily.front(), error);
    daily.erase(daily.begin());
  }
  return {};
}

base::Result<void> keep_backup_before_migration(SQLite::Database& database, const fs::path& learner,
                                                int version) {
  const fs::path folder = backup_folder(learner);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return base::fail(Errc::io, "cannot be made: " + error.message(), folder.string());
  return copy_database(database, folder / fmt::format("before-version-{}{}", version + 1, kExtension));
}

base::Result<fs::path> make_backup(const LearnerStore& learner, const fs::path& file,
                                   const base::Progress& progress) {
  if (learner.last_entry() == 0) return base::fail(Errc::not_found, "nothing studied yet", file.string());
  const fs::path folder = backup_folder(file);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return base::fail(Errc::io, "cannot be made: " + error.message(), folder.string());
  fs::path backup = free_file(folder, "own", learner.now());
  if (auto done = learner.copy_to(backup, progress); !done) return tl::unexpected(std::move(done.error()));
  return backup;
}

base::Result<BackupContents> look_into(const fs::path& backup) {
  std::error_code error;
  if (!fs::is_regular_file(backup, error))
    return base::fail(Errc::not_found, "there is no such backup", backup.string());
  const auto learner = LearnerStore::open(backup, Access::read);
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
    return base::fail(Errc::not_found, "there is no such backup", backup.string(),
                      "nazori-cli study restore --list names them");
  }
  if (learner.has_parent_path()) fs::create_directories(learner.parent_path(), error);
  bool taken = false;
  const auto lock = FileLock::take(learner.string() + ".lock", taken);
  if (taken)
    return base::fail(Errc::in_use, "is open in another Nazori", learner.string(), "close it there first");
  if (!lock) return tl::unexpected(lock.error());

  const fs::path beside = learner.string() + ".restored";
  fs::remove(beside, error);
  base::UnfinishedFile unfinished(beside, base::UnfinishedKind::database);
  {
    // Read as a learner's file would be, so that what is put in place can be opened.
    auto source = LearnerStore::open(backup, Access::read, clock);
    if (!source) return tl::unexpected(std::move(source.error()));
    if (auto copied = source->copy_to(beside, progress); !copied)
      return tl::unexpected(std::move(copied.error()));
  }
  fs::path kept;
  if (fs::exists(learner, error)) {
    const fs::path folder = backup_folder(learner);
    fs::create_directories(folder, error);
    kept = free_file(folder, "before-restore", clock());
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
  return kept;
}

}  // namespace nazori::study
