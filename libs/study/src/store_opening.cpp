// SPDX-License-Identifier: Apache-2.0
#include <SQLiteCpp/Backup.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <unistd.h>
#include <array>
#include <fstream>
#include <system_error>

#include "daily_backup.h"
#include "learner_store_inside.h"
#include "nazori/study/backups.h"

namespace nazori::study {
namespace {

namespace fs = std::filesystem;
using base::Errc;

constexpr int kBusyMs = 5'000;

fs::path lock_of(const fs::path& path) { return path.string() + ".lock"; }

/// Refuses a damaged file before SQLite makes other files beside it.
base::Result<void> check_beginning(const fs::path& path) {
  std::array<char, 16> begin{};
  std::ifstream file(path, std::ios::binary);
  if (!file) return base::fail(Errc::io, "cannot be read", path.string(), "check its permissions");
  file.read(begin.data(), begin.size());
  if (file.gcount() == 0) return {};
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  if (std::string_view(begin.data(), static_cast<std::size_t>(file.gcount())) == kMagic) return {};
  return base::fail(Errc::parse, "is damaged or not a Nazori study file", path.string(),
                    "nothing was changed; restore a backup: nazori-cli study restore");
}

/// Whether the file has a write-ahead log that is not empty.
bool has_log(const fs::path& path) {
  std::error_code error;
  const auto bytes = fs::file_size(path.string() + "-wal", error);
  return !error && bytes > 0;
}

/// The URI with which SQLite reads the file without changing its folder. @param immutable  no program writes
/// it.
std::string read_only_uri(const fs::path& path, bool immutable) {
  std::string uri = "file:";
  for (const char c : fs::absolute(path).string()) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '/' || c == '-' || c == '_' || c == '.';
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri + (immutable ? "?mode=ro&immutable=1" : "?mode=ro");
}

/// A copy of an older file, upgraded in a temporary file that SQLite removes. The older one is not changed.
SQLite::Database newer_copy(SQLite::Database& older, int version, Time now) {
  SQLite::Database copy("", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  SQLite::Backup(copy, older).executeStep(-1);
  migrate_store(copy, version, now);
  return copy;
}

void keep_wal_as_it_is(SQLite::Database& db, bool keep) {
  (void)sqlite3_db_config(db.getHandle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, keep ? 1 : 0, nullptr);
}

}  // namespace

LearnerStore::Inside::Inside(SQLite::Database opened, std::string file_name, Clock the_clock)
    : db(std::move(opened)),
      name(std::move(file_name)),
      clock(std::move(the_clock)),
      calendar(*Calendar::create("UTC")),
      timeline{{0, Settings{}}} {}

void LearnerStore::Inside::load_calendar() {
  // A time zone that this computer does not know must not keep a learner from studying.
  auto own = Calendar::create(settings().time_zone, settings().day_starts_at);
  if (!own) own = Calendar::create("", settings().day_starts_at);
  if (own) calendar = *std::move(own);
}

base::Result<void> LearnerStore::Inside::load() {
  const auto damaged = [&](const char* what) {
    return base::fail(Errc::parse, fmt::format("is damaged: {}", what), name,
                      "rebuild it: nazori-cli study rebuild; or restore a backup: nazori-cli study restore");
  };
  timeline.assign(1, {0, Settings{}});
  undone.clear();
  SQLite::Statement undos(db, "SELECT undoes FROM log WHERE undoes IS NOT NULL");
  while (undos.executeStep()) undone.insert(undos.getColumn(0).getInt64());
  SQLite::Statement rows(
      db,
      "SELECT id, settings, action FROM log INDEXED BY log_of_settings WHERE settings IS NOT NULL "
      "ORDER BY id");
  while (rows.executeStep()) {
    if (undone.contains(rows.getColumn(2).getInt64())) continue;
    auto settings = parse_settings(rows.getColumn(1).getString());
    if (!settings) return damaged("settings that cannot be read");
    timeline.emplace_back(rows.getColumn(0).getInt64(), *std::move(settings));
  }
  last_id = db.execAndGet("SELECT coalesce(max(id), 0) FROM log").getInt64();
  auto read = read_cards(db);
  if (!read && !rebuilds) return damaged("a card that cannot be");
  cards = std::move(read).value_or(Cards());
  load_calendar();
  return {};
}

bool LearnerStore::in_use(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(lock_of(path), ignored)) return false;
  bool is_locked = false;
  (void)base::FileLock::take(lock_of(path), is_locked);
  return is_locked;
}

base::Result<LearnerStore> LearnerStore::in_memory(Clock clock) {
  try {
    SQLite::Database db(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    migrate_store(db, 0, clock());
    auto inside = std::make_unique<Inside>(std::move(db), "memory", std::move(clock));
    if (auto fine = inside->load(); !fine) return tl::unexpected(std::move(fine.error()));
    return LearnerStore(std::move(inside));
  } catch (const SQLite::Exception& trouble) {
    return tl::unexpected(error_of(trouble, "memory"));
  }
}

base::Result<LearnerStore> LearnerStore::open(const fs::path& path, Access access, Clock clock,
                                              Upkeep upkeep) {
  std::error_code error;
  const bool there = fs::exists(path, error);
  // A file that cannot be inspected must not be treated as an empty learner.
  if (error) {
    return base::fail(Errc::io, "cannot be read: " + error.message(), path.string(),
                      "check the permissions of the folder");
  }
  const bool writes = access == Access::write || access == Access::rebuild;
  if (!there && !writes) return in_memory(std::move(clock));
  base::FileLock lock;
  if (writes) {
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    if (error) {
      return base::fail(Errc::io, "cannot be created: " + error.message(), path.parent_path().string(),
                        "check the permissions of the folder");
    }
    bool is_locked = false;
    auto own = base::FileLock::take(lock_of(path), is_locked);
    if (is_locked) {
      return base::fail(Errc::in_use, "is open in another Nazori window", path.string(),
                        "close it there first");
    }
    if (!own) return tl::unexpected(std::move(own.error()));
    lock = *std::move(own);
    clear_unfinished_restore(path);
  }
  if (there) {
    if (auto fine = check_beginning(path); !fine) return tl::unexpected(std::move(fine.error()));
  }
  const auto attempt = [&](bool immutable) -> base::Result<LearnerStore> {
    try {
      SQLite::Database db(
          writes ? path.string() : read_only_uri(path, immutable),
          writes ? SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE : SQLite::OPEN_READONLY | SQLite::OPEN_URI,
          kBusyMs);
      keep_wal_as_it_is(db, true);
      const auto version = check_store(db, path.string());
      if (!version) return tl::unexpected(version.error());
      // A damaged file is never upgraded.
      const bool older = *version > 0 && *version < kLearnerVersion;
      if (upkeep == Upkeep::now || older) {
        if (auto sound = check_pages(db, path.string()); !sound) return tl::unexpected(sound.error());
      }
      if (!writes && *version == 0) return in_memory(clock);
      if (!writes && older) db = newer_copy(db, *version, clock());
      auto inside = std::make_unique<Inside>(std::move(db), path.string(), clock);
      inside->lock = std::move(lock);
      inside->rebuilds = access == Access::rebuild;
      if (writes) {
        keep_wal_as_it_is(inside->db, false);
        if (older) {
          auto kept = keep_backup_before_migration(inside->db, path, *version);
          if (!kept) return tl::unexpected(std::move(kept.error()));
        }
        if (*version < kLearnerVersion) migrate_store(inside->db, *version, inside->clock());
        inside->db.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
      }
      if (auto fine = inside->load(); !fine) return tl::unexpected(std::move(fine.error()));
      if (writes && upkeep == Upkeep::now && inside->last_id > 0) {
        const Day day = inside->calendar.day_of(inside->clock());
        if (auto kept = keep_daily_backup(inside->db, path, day); !kept) {
          inside->backup_trouble = std::move(kept.error());
        }
      }
      return LearnerStore(std::move(inside));
    } catch (const SQLite::Exception& trouble) {
      return tl::unexpected(error_of(trouble, path.string()));
    }
  };
  // Without write permission the files of a write-ahead log cannot be made; a properly closed file has none.
  const bool closed = ::access(path.parent_path().empty() ? "." : path.parent_path().c_str(), W_OK) != 0;
  const bool still = access == Access::backup && !has_log(path) && !in_use(path);
  auto opened = attempt(still || (!writes && closed && !fs::exists(path.string() + "-wal", error)));
  // They cannot be made on a full disk either.
  if (!opened && !writes && opened.error().code == Errc::io && !has_log(path)) opened = attempt(true);
  return opened;
}

base::Result<UpkeepReport> keep_up(const fs::path& learner, Day day, const base::Progress& progress) {
  try {
    SQLite::Database db(read_only_uri(learner, false), SQLite::OPEN_READONLY | SQLite::OPEN_URI, kBusyMs);
    keep_wal_as_it_is(db, true);
    if (const auto version = check_store(db, learner.string()); !version)
      return tl::unexpected(version.error());
    // One reading transaction for both, so that the checked data are copied, whatever is written meanwhile.
    SQLite::Transaction reading(db);
    if (auto sound = check_pages(db, learner.string(), progress); !sound)
      return tl::unexpected(sound.error());
    UpkeepReport report;
    if (db.execAndGet("SELECT coalesce(max(id), 0) FROM log").getInt64() == 0) return report;
    if (auto kept = keep_daily_backup(db, learner, day, progress); !kept) {
      if (kept.error().code == Errc::cancelled) return tl::unexpected(std::move(kept.error()));
      report.backup_trouble = std::move(kept.error());
    }
    return report;
  } catch (const SQLite::Exception& trouble) {
    return tl::unexpected(error_of(trouble, learner.string()));
  }
}

}  // namespace nazori::study
