// SPDX-License-Identifier: Apache-2.0
// How a learner's file is opened: names, ages, damage, and what stays beside it.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <fstream>

#include "../src/store_schema.h"
#include "learner_fixture.h"
#include "nazori/study/backups.h"
#include "nazori/study/exchange.h"
#include "test_paths.h"

namespace nazori::study {
namespace {

namespace fs = std::filesystem;
using base::Errc;
using std::chrono::days;
using test::bytes_of;
using test::MovedClock;
using test::must;
using test::review;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr char32_t kRest = U'休';

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void study(const fs::path& file, const MovedClock& clock, Upkeep upkeep = Upkeep::later) {
  (void)must(must(LearnerStore::open(file, Access::write, clock.clock(), upkeep))
                 .add_writing(kRest, 6, review(Rating::good)));
}

std::int64_t number(const fs::path& file, const std::string& sql) {
  return SQLite::Database(file.string(), SQLite::OPEN_READONLY).execAndGet(sql).getInt64();
}

TEST(StoreOpening, WorksInFoldersOfAnyName) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  for (const char* name :
       {"plain-1_2.3", "two words", "50%", "%41", "what?mode=rw", "a#b", "健太", "a&b;c", "Z{z}@", "a:b"}) {
    const fs::path file = folder / name / "learner.db";
    study(file, clock);
    for (const Access access : {Access::read, Access::backup}) {
      const auto store = LearnerStore::open(file, access, clock.clock());
      ASSERT_TRUE(store) << name << ": " << base::to_line(store.error());
      EXPECT_EQ(store->last_entry(), 1) << name;
    }
    EXPECT_FALSE(must(keep_up(file, *parse_day("2026-01-01"))).backup_trouble) << name;
    EXPECT_EQ(backups_of(file).size(), 1U) << name;
  }
}

TEST(StoreOpening, ANameWithoutAFolderIsOneOfThePresentFolder) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder / "");
  const MovedClock clock("2026-01-01T09:00:00Z");
  study("learner.db", clock);
  EXPECT_EQ(must(LearnerStore::open("learner.db", Access::read)).last_entry(), 1);
  EXPECT_EQ(must(LearnerStore::open("learner.db", Access::write)).last_entry(), 1);
  fs::current_path(before);
}

TEST(StoreOpening, AnEmptyFileIsANewLearnerAndAShortOneIsNone) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  std::ofstream(file) << "";
  EXPECT_EQ(must(LearnerStore::open(file, Access::read)).last_entry(), 0);
  EXPECT_EQ(fs::file_size(file), 0U) << "reading leaves it";
  study(file, clock);
  EXPECT_EQ(must(LearnerStore::open(file, Access::read)).last_entry(), 1);
  for (const char* wrong : {"x", "SQLite format 3", "SQLite format 4 and more than sixteen"}) {
    std::ofstream(folder / "other.db") << wrong;
    EXPECT_EQ(LearnerStore::open(folder / "other.db", Access::write).error().code, Errc::parse) << wrong;
    EXPECT_EQ(bytes_of(folder / "other.db"), wrong);
  }
}

TEST(StoreOpening, ReadingLeavesNothingBesideAFileThatWasClosed) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  study(file, clock);
  fs::remove(folder / "learner.db.lock");
  const std::string bytes = bytes_of(file);
  EXPECT_EQ(must(LearnerStore::open(file, Access::backup)).last_entry(), 1);
  EXPECT_THAT(names_in(folder / ""), ElementsAre("learner.db"));
  EXPECT_FALSE(LearnerStore::in_use(file));
  EXPECT_THAT(names_in(folder / ""), ElementsAre("learner.db")) << "asking makes no lock";
  EXPECT_EQ(must(LearnerStore::open(file, Access::read)).last_entry(), 1);
  EXPECT_EQ(bytes_of(file), bytes);
  EXPECT_FALSE(must(LearnerStore::open(file, Access::read)).add_writing(kRest, 6, review(Rating::good)));
}

TEST(StoreOpening, AFileIsKeptWithAWriteAheadLogThatIsTakenInAtTheEnd) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock()));
    (void)must(store.add_writing(kRest, 6, review(Rating::good)));
    EXPECT_GT(fs::file_size(file.string() + "-wal"), 0U);
    SQLite::Database other(file.string(), SQLite::OPEN_READONLY);
    EXPECT_EQ(other.execAndGet("PRAGMA journal_mode").getString(), "wal");
    // Opening for reading does not write the log into the file.
    { (void)must(LearnerStore::open(file, Access::read)); }
    EXPECT_GT(fs::file_size(file.string() + "-wal"), 0U);
  }
  EXPECT_THAT(names_in(folder / ""), ElementsAre("learner.db", "learner.db.lock"));
}

TEST(StoreOpening, ADamagedFileIsFoundNowOrLater) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::later));
    ASSERT_TRUE(store.fill(test::long_history(3'000)));
  }
  {
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(static_cast<std::streamoff>(fs::file_size(file) / 2));
    bytes << std::string(8'192, '\xee');
  }
  for (const Access access : {Access::read, Access::write}) {
    const auto now = LearnerStore::open(file, access, clock.clock(), Upkeep::now);
    ASSERT_FALSE(now);
    EXPECT_EQ(now.error().code, Errc::parse);
    EXPECT_TRUE(LearnerStore::open(file, access, clock.clock(), Upkeep::later));
  }
}

TEST(StoreOpening, BackupsAreMadeNowOfALearnerWhoHasStudied) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-02T03:00:00Z");
  const fs::path file = folder / "learner.db";
  (void)must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::now));
  EXPECT_THAT(backups_of(file), IsEmpty()) << "of nothing";
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::now));
    test::use_zone(store, "UTC");
  }
  (void)must(LearnerStore::open(file, Access::read, clock.clock(), Upkeep::now));
  (void)must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::later));
  EXPECT_THAT(backups_of(file), IsEmpty());
  (void)must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::now));
  ASSERT_EQ(backups_of(file).size(), 1U);
  EXPECT_EQ(backups_of(file)[0].file.filename(), "daily-2026-01-01.db") << "it is still that night";
}

TEST(StoreOpening, AZoneThatIsNotKnownHereIsTheComputers) {
  const MovedClock clock("2026-01-01T09:00:00Z");
  Settings settings;
  settings.time_zone = "Mars/Olympus";
  settings.day_starts_at = 9;
  std::string text =
      "{\"format\":\"nazori-learner\",\"version\":1,\"entries\":[{\"id\":1,\"action\":1,\"at\":"
      "\"2026-01-01T09:00Z\",\"day\":\"2026-01-01\",\"kind\":\"settings\",\"settings\":" +
      to_json(settings) + "}],\"lists\":[],\"tags\":[]}";
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  ASSERT_TRUE(import_json(store, text_source(text)));
  EXPECT_EQ(store.settings().time_zone, "Mars/Olympus");
  EXPECT_EQ(store.calendar().zone(), Calendar::create("")->zone());
  EXPECT_EQ(store.calendar().begin_of(store.today()), Calendar::create("", 9)->begin_of(store.today()));
}

TEST(StoreOpening, SettingsThatCannotBeReadAreDamage) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::later));
    test::use_zone(store, "UTC");
  }
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
      .exec("DROP TRIGGER log_is_not_changed; UPDATE log SET settings = '{\"new_per_day\": -1}'");
  for (const Access access : {Access::read, Access::write, Access::rebuild}) {
    const auto store = LearnerStore::open(file, access, clock.clock(), Upkeep::later);
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().code, Errc::parse);
    EXPECT_THAT(store.error().what, HasSubstr("settings that cannot be read"));
  }
}

fs::path file_of_version_one(const TemporaryFolder& folder) {
  const fs::path file = folder / "learner.db";
  SQLite::Database db(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  db.exec(bytes_of(std::string(test_paths::kFixtures) + "/learner-v1.sql"));
  return file;
}

TEST(StoreSchema, AnOlderFileIsBroughtUpToDateAfterABackup) {
  const TemporaryFolder folder;
  const fs::path file = file_of_version_one(folder);
  const MovedClock clock("2026-05-05T09:00:00Z");
  (void)must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::later));
  EXPECT_THAT(names_in(backup_folder(file)), ElementsAre("before-version-2.db"));
  EXPECT_EQ(number(backup_folder(file) / "before-version-2.db", "PRAGMA user_version"), 1);
  EXPECT_EQ(number(file, "PRAGMA user_version"), kLearnerVersion);
  EXPECT_EQ(number(file, "PRAGMA application_id"), kLearnerApplicationId);
  EXPECT_EQ(number(file, "SELECT max(version) FROM schema_version"), kLearnerVersion);
  EXPECT_EQ(number(file, "SELECT count(*) FROM schema_version"), kLearnerVersion);
  EXPECT_EQ(number(file, "SELECT since_ms FROM schema_version WHERE version = 2"),
            clock.now().time_since_epoch().count());
}

TEST(StoreSchema, AnOlderFileWithoutABackupStaysAsItIs) {
  const TemporaryFolder folder;
  const fs::path file = file_of_version_one(folder);
  std::ofstream(backup_folder(file)) << "in the way";
  const auto store =
      LearnerStore::open(file, Access::write, MovedClock("2026-05-05T09:00:00Z").clock(), Upkeep::later);
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().code, Errc::io);
  EXPECT_EQ(store.error().where, backup_folder(file).string());
  EXPECT_EQ(number(file, "PRAGMA user_version"), 1);
}

TEST(StoreSchema, ANewFileHasHadEveryVersionAtItsFirstMoment) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-05-05T09:00:00Z");
  const fs::path file = folder / "learner.db";
  (void)must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::now));
  EXPECT_EQ(number(file, "SELECT count(*) FROM schema_version"), kLearnerVersion);
  EXPECT_EQ(number(file, "SELECT min(since_ms) FROM schema_version"), clock.now().time_since_epoch().count());
  EXPECT_FALSE(fs::exists(backup_folder(file)));
}

TEST(StoreSchema, ADamagedOlderFileStaysAsItIs) {
  const TemporaryFolder folder;
  const fs::path file = file_of_version_one(folder);
  std::string bytes = bytes_of(file);
  // All but its first two pages.
  std::fill(bytes.begin() + 8'192, bytes.end(), '\xee');
  std::ofstream(file, std::ios::binary) << bytes;
  for (const Access access : {Access::read, Access::write}) {
    EXPECT_EQ(
        LearnerStore::open(file, access, MovedClock("2026-05-05T09:00Z").clock(), Upkeep::later).error().code,
        Errc::parse);
    EXPECT_EQ(bytes_of(file), bytes);
  }
  EXPECT_THAT(backups_of(file), IsEmpty());
}

TEST(StoreSchema, AFileIsALearnersByItsNumberAndVersion) {
  const auto version = [](const std::string& sql) {
    SQLite::Database db(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    db.exec(sql);
    const auto found = check_store(db, "x");
    return found ? std::to_string(*found)
                 : std::string(found.error().code == Errc::schema ? found.error().what : "?");
  };
  const std::string own = "PRAGMA application_id = " + std::to_string(kLearnerApplicationId) + ";";
  const auto user = [](int number) { return "PRAGMA user_version = " + std::to_string(number) + ";"; };
  const std::string table = "CREATE TABLE x(y);";
  EXPECT_EQ(version(""), "0");
  EXPECT_EQ(version(own + user(1) + table), "1");
  EXPECT_EQ(version(own + user(kLearnerVersion) + table), std::to_string(kLearnerVersion));
  EXPECT_THAT(version(own + user(kLearnerVersion + 1) + table), HasSubstr("newer Nazori (version 5"));
  for (const std::string& foreign : {table, user(1), own, own + user(0) + table, own + user(-1) + table,
                                     "PRAGMA application_id = 5;" + user(1) + table})
    EXPECT_THAT(version(foreign), HasSubstr("is not a Nazori study file")) << foreign;
}

TEST(StoreSchema, TroubleOfTheDatabaseIsNamedByWhatCanBeDone) {
  const auto message = [](int code) {
    const base::Error error = error_of(SQLite::Exception("trouble", code), "me.db");
    EXPECT_EQ(error.where, "me.db");
    EXPECT_FALSE(error.remedy.empty());
    return (error.code == Errc::parse ? "parse: " : error.code == Errc::io ? "io: " : "?") + error.what;
  };
  EXPECT_EQ(message(SQLITE_FULL), "io: the disk is full");
  EXPECT_EQ(message(SQLITE_READONLY), "io: may not be written");
  EXPECT_EQ(message(SQLITE_CANTOPEN), "io: cannot be opened");
  EXPECT_EQ(message(SQLITE_BUSY), "io: is in use by another program");
  EXPECT_EQ(message(SQLITE_LOCKED), "io: is in use by another program");
  EXPECT_EQ(message(SQLITE_CORRUPT), "parse: is damaged: trouble");
  EXPECT_EQ(message(SQLITE_NOTADB), "parse: is damaged: trouble");
  EXPECT_EQ(message(SQLITE_IOERR), "io: cannot be read or written: trouble");
}

}  // namespace
}  // namespace nazori::study
