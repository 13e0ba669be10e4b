// SPDX-License-Identifier: Apache-2.0
#include "store_schema.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <array>
#include <string>

#include "store_days.h"

namespace nazori::study {
namespace {

constexpr const char* kRestore = "nothing was changed; restore a backup: nazori-cli study restore";

/// The statements that upgrade a file from version i to version i + 1. A released step is never changed
/// again.
constexpr std::array<const char*, kLearnerVersion> kMigrations{R"sql(
-- Which versions this file has had.
CREATE TABLE schema_version(
  version INTEGER PRIMARY KEY,
  since_ms INTEGER NOT NULL);      -- milliseconds since 1970-01-01 UTC

-- Everything the learner did. Rows are only ever added.
CREATE TABLE log(
  id INTEGER PRIMARY KEY,          -- 1, 2, 3, ...
  action INTEGER NOT NULL,         -- id of the first row of the same action
  at_ms INTEGER NOT NULL,          -- milliseconds since 1970-01-01 UTC
  day INTEGER NOT NULL,            -- study day, in days since 1970-01-01
  kind INTEGER NOT NULL,           -- EntryKind
  character INTEGER,               -- code point
  stage INTEGER,                   -- Stage; this and the next ones of a writing
  rating INTEGER,                  -- Rating, the learner's
  proposed INTEGER,                -- Rating, the program's
  accepted INTEGER,
  score INTEGER,
  faults TEXT,                     -- "wrong:3 ending:0": kind and stroke from 0
  hints INTEGER,
  misses INTEGER,
  shown_strokes INTEGER,
  help REAL,
  duration_ms INTEGER,
  strokes INTEGER,                 -- of the character
  interval_days INTEGER,           -- where the interval was moved within its range
  speed REAL, smoothness REAL,     -- of the ink, where it has times
  undoes INTEGER,                  -- of an undo: the action
  until_day INTEGER,               -- of a postponement
  settings TEXT);                  -- of a change of settings: JSON
CREATE INDEX log_of_character ON log(character, id);
CREATE TRIGGER log_is_not_changed BEFORE UPDATE ON log
  BEGIN SELECT RAISE(ABORT, 'the log is only added to'); END;
CREATE TRIGGER log_is_not_shortened BEFORE DELETE ON log
  BEGIN SELECT RAISE(ABORT, 'the log is only added to'); END;

-- The ink of a writing: docs/file-formats.md.
CREATE TABLE ink(entry INTEGER PRIMARY KEY, packed BLOB NOT NULL);

-- What follows from the log; `study rebuild` makes it anew.
CREATE TABLE card(
  character INTEGER PRIMARY KEY,
  phase INTEGER NOT NULL,
  stability REAL NOT NULL,
  difficulty REAL NOT NULL,
  step INTEGER NOT NULL,
  scheduled_days INTEGER NOT NULL,
  reps INTEGER NOT NULL,
  lapses INTEGER NOT NULL,
  due_ms INTEGER NOT NULL,
  last_review_ms INTEGER,
  introduced INTEGER, last_day INTEGER, due_day INTEGER, postponed_until INTEGER,
  paused INTEGER NOT NULL,
  leech INTEGER NOT NULL,
  leech_at INTEGER NOT NULL,
  practices INTEGER NOT NULL,
  next_stage INTEGER NOT NULL,
  help REAL NOT NULL);

CREATE TABLE list(name TEXT PRIMARY KEY);
CREATE TABLE list_member(list TEXT, position INTEGER, character INTEGER NOT NULL,
  PRIMARY KEY(list, position)) WITHOUT ROWID;
CREATE TABLE tag(character INTEGER, tag TEXT, PRIMARY KEY(character, tag)) WITHOUT ROWID;
)sql",
                                                               R"sql(
CREATE INDEX log_of_action ON log(action);
CREATE INDEX log_of_undo ON log(undoes) WHERE undoes IS NOT NULL;
CREATE INDEX log_of_settings ON log(kind) WHERE settings IS NOT NULL;

-- What follows from the log, too: all writings of a character on one study day.
CREATE TABLE character_day(
  character INTEGER NOT NULL,      -- code point
  number INTEGER NOT NULL,         -- of its study days, from 0
  day INTEGER NOT NULL,            -- study day, in days since 1970-01-01
  outcome INTEGER,                 -- DayOutcome
  time_ms INTEGER NOT NULL,        -- of all writings
  writings INTEGER NOT NULL,
  reviews INTEGER NOT NULL,        -- of these from memory
  PRIMARY KEY(character, number)) WITHOUT ROWID;
CREATE INDEX character_day_of_day ON character_day(day);
CREATE INDEX character_day_of_outcome ON character_day(outcome, day DESC, character, number)
  WHERE time_ms > 0;

-- The sums of each study day: writings, reviews, and the character days of each outcome that took any time.
CREATE TABLE study_day(
  day INTEGER PRIMARY KEY,
  writings INTEGER NOT NULL,
  reviews INTEGER NOT NULL,
  recalled INTEGER NOT NULL,
  failed INTEGER NOT NULL,
  introduced INTEGER NOT NULL);
)sql",
                                                               R"sql(
-- The log may have entries of the kinds choices and known, which earlier versions cannot read.
SELECT 1;
)sql",
                                                               R"sql(
-- The log may have writings of the stage brush, which earlier versions cannot read. What follows from them,
-- for each character that has any.
CREATE TABLE brush_card(
  character INTEGER PRIMARY KEY,
  phase INTEGER NOT NULL,
  stability REAL NOT NULL,
  difficulty REAL NOT NULL,
  step INTEGER NOT NULL,
  scheduled_days INTEGER NOT NULL,
  reps INTEGER NOT NULL,
  lapses INTEGER NOT NULL,
  due_ms INTEGER NOT NULL,
  last_review_ms INTEGER,
  last_day INTEGER, due_day INTEGER);
)sql"};

constexpr int kDaysSince = 2;  ///< the version that introduced character_day and study_day

}  // namespace

base::Result<int> check_store(SQLite::Database& database, const std::string& name) {
  const int tables = database.execAndGet("SELECT count(*) FROM sqlite_master").getInt();
  const int id = database.execAndGet("PRAGMA application_id").getInt();
  const int version = database.execAndGet("PRAGMA user_version").getInt();
  if (tables == 0 && id == 0 && version == 0) return 0;
  if (id != kLearnerApplicationId || version < 1) {
    return base::fail(base::Errc::schema, "is not a Nazori study file", name, "nothing was changed");
  }
  if (version > kLearnerVersion) {
    return base::fail(
        base::Errc::schema,
        fmt::format("was written by a newer Nazori (version {} of the file, this one reads up to {})",
                    version, kLearnerVersion),
        name, "nothing was changed; install the newer Nazori");
  }
  return version;
}

base::Result<void> check_pages(SQLite::Database& database, const std::string& name,
                               const base::Progress& progress) {
  constexpr int kStepsBetweenLooks = 10'000;
  const auto look = [](void* asked) {
    return (*static_cast<const base::Progress*>(asked))(0, "check") ? 0 : 1;
  };
  base::Progress asked = progress;
  if (progress) sqlite3_progress_handler(database.getHandle(), kStepsBetweenLooks, look, &asked);
  const auto verdict = [&]() -> base::Result<std::string> {
    try {
      return database.execAndGet("PRAGMA quick_check(1)").getString();
    } catch (const SQLite::Exception& trouble) {
      if (trouble.getErrorCode() == SQLITE_INTERRUPT)
        return base::fail(base::Errc::cancelled, "stopped", name);
      return tl::unexpected(error_of(trouble, name));
    }
  }();
  sqlite3_progress_handler(database.getHandle(), 0, nullptr, nullptr);
  if (!verdict) return tl::unexpected(verdict.error());
  if (*verdict != "ok") return base::fail(base::Errc::parse, "is damaged: " + *verdict, name, kRestore);
  return {};
}

void migrate_store(SQLite::Database& database, int version, Time now) {
  SQLite::Transaction transaction(database);
  for (int step = version; step < kLearnerVersion; ++step) {
    database.exec(kMigrations[static_cast<std::size_t>(step)]);
    if (step + 1 == kDaysSince) rebuild_days(database);
    SQLite::Statement insert(database, "INSERT INTO schema_version VALUES(?, ?)");
    insert.bind(1, step + 1);
    insert.bind(2, static_cast<std::int64_t>(now.time_since_epoch().count()));
    insert.exec();
  }
  database.exec(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kLearnerApplicationId,
                            kLearnerVersion));
  transaction.commit();
}

base::Error error_of(const SQLite::Exception& trouble, const std::string& name) {
  using base::Errc;
  base::Error full{Errc::io, "the disk is full", name, "make room; what was acknowledged before is safe"};
  // For the index of the write-ahead log SQLite reports a full disk with another error.
  if (trouble.getExtendedErrorCode() == SQLITE_IOERR_SHMSIZE) return full;
  switch (trouble.getErrorCode()) {
    case SQLITE_FULL:
      return full;
    case SQLITE_READONLY:
      return {Errc::io, "may not be written", name, "check the permissions of the file and its folder"};
    case SQLITE_CANTOPEN:
      return {Errc::io, "cannot be opened", name, "check the permissions of the file and its folder"};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {Errc::io, "is in use by another program", name, "close it there, then try again"};
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return {Errc::parse, std::string("is damaged: ") + trouble.what(), name, kRestore};
    default:
      return {Errc::io, std::string("cannot be read or written: ") + trouble.what(), name,
              "check the disk; what was acknowledged before is safe"};
  }
}

}  // namespace nazori::study
