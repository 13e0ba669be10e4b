// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/backups.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>

#include "../src/daily_backup.h"
#include "learner_fixture.h"

namespace {

bool links_work = true;
bool flush_works = true;  ///< for files that are open for reading; SQLite's own are open for writing
std::string onto_fails;   ///< the first rename to this file fails

}  // namespace

// These replace the system's functions, so that operations of std::filesystem can fail as on a full disk, or
// on one without links.
extern "C" int link(const char* from, const char* to) {
  if (!links_work) {
    errno = EPERM;
    return -1;
  }
  return ::linkat(AT_FDCWD, from, AT_FDCWD, to, 0);
}
extern "C" int rename(const char* from, const char* to) {
  if (onto_fails == to) {
    onto_fails.clear();
    errno = EIO;
    return -1;
  }
  return ::renameat(AT_FDCWD, from, AT_FDCWD, to);
}
extern "C" int fsync(int descriptor) {
  if (!flush_works && (::fcntl(descriptor, F_GETFL) & O_ACCMODE) == O_RDONLY) {
    errno = EIO;
    return -1;
  }
  return ::fdatasync(descriptor);
}

namespace nazori::study {
namespace {

namespace fs = std::filesystem;
using std::chrono::days;
using test::bytes_of;
using test::MovedClock;
using test::must;
using test::review;
using test::some_ink;
using test::TemporaryFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr char32_t kRest = U'休';

void study(const fs::path& file, const MovedClock& clock) {
  LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock()));
  EXPECT_FALSE(store.backup_trouble());
  (void)must(store.add_writing(kRest, 6, review(Rating::good), some_ink()));
}

/// Names of all files there, sorted.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> dailies(const fs::path& file) {
  std::vector<std::string> names = names_in(backup_folder(file));
  std::erase_if(names, [](const std::string& name) { return !name.starts_with("daily-"); });
  return names;
}

/// Sets the times of the files of a folder an hour apart, in the order of their names, the last to an hour
/// ago.
void age(const fs::path& folder) {
  const auto names = names_in(folder);
  auto time = fs::file_time_type::clock::now();
  for (auto name = names.rbegin(); name != names.rend(); ++name)
    fs::last_write_time(folder / *name, time -= std::chrono::hours(1));
}

TEST(Backups, AClockThatWasSetBackDoesNotCostTheNewBackup) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  MovedClock clock("2030-06-01T09:00:00Z");
  for (int day = 0; day < 9; ++day, clock.advance(days(1))) study(file, clock);
  age(backup_folder(file));
  ASSERT_EQ(dailies(file).size(), 7U);
  ASSERT_EQ(dailies(file).front(), "daily-2030-06-03.db");
  clock.set("2026-01-01T09:00:00Z");
  study(file, clock);
  EXPECT_THAT(dailies(file), Contains("daily-2026-01-01.db"));
  EXPECT_EQ(dailies(file).size(), 7U);
  // It is not copied again at each opening.
  const fs::path made = backup_folder(file) / "daily-2026-01-01.db";
  const auto time = fs::last_write_time(made);
  const std::string bytes = bytes_of(made);
  study(file, clock);
  EXPECT_EQ(fs::last_write_time(made), time);
  EXPECT_EQ(bytes_of(made), bytes);
  // Each day the oldest by time is removed, until only the new ones are left.
  for (int day = 0; day < 6; ++day) {
    clock.advance(days(1));
    study(file, clock);
  }
  EXPECT_THAT(dailies(file), ElementsAre("daily-2026-01-01.db", "daily-2026-01-02.db", "daily-2026-01-03.db",
                                         "daily-2026-01-04.db", "daily-2026-01-05.db", "daily-2026-01-06.db",
                                         "daily-2026-01-07.db"));
}

TEST(Backups, WhatWasMadeByAClockThatWasAheadIsOlderThanWhatIsMadeNow) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  MovedClock clock("2030-06-01T09:00:00Z");
  for (int day = 0; day < 9; ++day, clock.advance(days(1))) study(file, clock);
  // The clock of the whole computer was four years ahead, and so are the times of the files.
  for (const std::string& name : dailies(file)) {
    const fs::path one = backup_folder(file) / name;
    fs::last_write_time(one, fs::last_write_time(one) + days(1'400));
  }
  clock.set("2026-01-01T09:00:00Z");
  for (int day = 0; day < 3; ++day, clock.advance(days(1))) study(file, clock);
  EXPECT_THAT(dailies(file), ElementsAre("daily-2026-01-01.db", "daily-2026-01-02.db", "daily-2026-01-03.db",
                                         "daily-2030-06-06.db", "daily-2030-06-07.db", "daily-2030-06-08.db",
                                         "daily-2030-06-09.db"));
}

TEST(Backups, OneThatFailsIsSaidAndLeavesNothing) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  const MovedClock clock("2026-01-01T09:00:00Z");
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock()));
    for (int i = 0; i < 200; ++i) (void)must(store.add_writing(kRest, 6, review(Rating::good), some_ink(i)));
  }
  fs::remove_all(backup_folder(file));
  ASSERT_GT(fs::file_size(file), 80'000U);
  const pid_t child = ::fork();
  if (child == 0) {
    // Simulates a disk with room for the index of a write-ahead log, but not for a copy.
    const rlimit limit{50'000, 50'000};
    (void)std::signal(SIGXFSZ, SIG_IGN);
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(1);
    const auto store = LearnerStore::open(file, Access::write, clock.clock());
    if (!store) ::_exit(2);
    if (!store->backup_trouble()) ::_exit(3);
    ::_exit(store->backup_trouble()->where.find("daily-2026-01-01.db") != std::string::npos ? 0 : 4);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_THAT(names_in(backup_folder(file)), IsEmpty());
  study(file, clock);
  EXPECT_THAT(names_in(backup_folder(file)), ElementsAre("daily-2026-01-01.db")) << "it is made later";
}

TEST(Backups, WhatAProgramThatWasKilledLeftIsClearedAway) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  MovedClock clock("2026-01-01T09:00:00Z");
  study(file, clock);
  fs::create_directories(backup_folder(file));
  for (const char* name : {"daily-2025-12-24.db.part", "daily-2025-12-24.db.part-journal", "letter.part",
                           "own-20260101T080000Z.db.part"})
    std::ofstream(backup_folder(file) / name) << "half";
  for (const char* name : {"learner.db.restored", "learner.db.restored.part", "learner.db.restored.part-wal"})
    std::ofstream(folder / name) << "half";
  study(file, clock);
  // Another program may be making one of the learner's own backups at this moment.
  EXPECT_THAT(names_in(backup_folder(file)),
              ElementsAre("daily-2026-01-01.db", "letter.part", "own-20260101T080000Z.db.part"));
  EXPECT_THAT(names_in(folder / ""), ElementsAre("backups", "learner.db", "learner.db.lock"));
}

TEST(Backups, LookingIntoOneLeavesNothingBesideIt) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  const MovedClock clock("2026-01-01T09:00:00Z");
  study(file, clock);
  const fs::path own = must(make_backup(must(LearnerStore::open(file, Access::read)), file));
  study(file, clock);
  const fs::path kept = must(restore_backup(own, file, clock.clock()));
  fs::remove_all(backup_folder(file) / "daily-2026-01-01.db");
  const auto before = names_in(backup_folder(file));
  ASSERT_EQ(before.size(), 2U);
  for (const Backup& one : backups_of(file)) EXPECT_TRUE(look_into(one.file)) << one.file;
  EXPECT_EQ(must(look_into(kept)).writings, 2);
  EXPECT_EQ(names_in(backup_folder(file)), before);
  (void)must(restore_backup(kept, file, clock.clock()));
  EXPECT_EQ(must(look_into(file)).writings, 2);
  EXPECT_THAT(names_in(backup_folder(file)),
              testing::Each(testing::AnyOf(testing::StartsWith("own-"), testing::EndsWith("Z.db"),
                                           testing::EndsWith("-2.db"))));
}

TEST(Backups, ALearnerWhoStudiesIsLookedIntoAsHeIsNow) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  LearnerStore store = must(LearnerStore::open(file, Access::write));
  for (int i = 1; i < 4; ++i) {
    (void)must(store.add_writing(kRest, 6, review(Rating::good)));
    EXPECT_EQ(must(look_into(file)).writings, i);
  }
}

TEST(Backups, OfWhatWasReplacedTheNewestAreKept) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  MovedClock clock("2026-01-01T09:00:00Z");
  study(file, clock);
  ASSERT_TRUE(must(LearnerStore::open(file, Access::read)).copy_to(folder / "one.db"));
  std::vector<std::string> kept;
  for (int i = 0; i < 6; ++i, clock.advance(std::chrono::hours(1))) {
    kept.push_back(must(restore_backup(folder / "one.db", file, clock.clock())).filename().string());
    // A log beside the file is moved with it.
    std::ofstream(backup_folder(file) / (kept.back() + "-wal")) << "";
    age(backup_folder(file));
  }
  kept.erase(kept.begin(), kept.end() - kReplacedKept);
  std::vector<std::string> expected;
  for (const std::string& name : kept) {
    expected.push_back(name);
    expected.push_back(name + "-wal");
  }
  EXPECT_EQ(names_in(backup_folder(file)), expected);
}

TEST(Backups, WhereTheRestoredFileCannotBePutInPlaceTheOldOneComesBack) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  MovedClock clock("2026-01-01T09:00:00Z");
  study(file, clock);
  ASSERT_TRUE(must(LearnerStore::open(file, Access::read)).copy_to(folder / "one.db"));
  clock.advance(days(1));
  study(file, clock);
  for (const bool has_links : {true, false}) {
    links_work = has_links;
    onto_fails = file.string();
    const auto done = restore_backup(folder / "one.db", file, clock.clock());
    links_work = true;
    onto_fails.clear();
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, base::Errc::io);
    EXPECT_THAT(done.error().what, HasSubstr("cannot be written"));
    EXPECT_EQ(must(LearnerStore::open(file, Access::read)).last_entry(), 2) << has_links;
  }
  EXPECT_TRUE(restore_backup(folder / "one.db", file, clock.clock()));
  EXPECT_EQ(must(LearnerStore::open(file, Access::read)).last_entry(), 1);
}

TEST(Backups, ACopyThatCannotBePutInPlaceOrOnDiskLeavesNothing) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock()));
  (void)must(store.add_writing(kRest, 6, review(Rating::good)));
  onto_fails = folder / "copy.db";
  auto copied = store.copy_to(folder / "copy.db");
  ASSERT_FALSE(copied);
  EXPECT_EQ(copied.error().code, base::Errc::io);
  EXPECT_EQ(copied.error().where, (folder / "copy.db").string());
  flush_works = false;
  copied = store.copy_to(folder / "copy.db");
  flush_works = true;
  ASSERT_FALSE(copied);
  EXPECT_EQ(copied.error().code, base::Errc::io);
  EXPECT_THAT(copied.error().what, HasSubstr("cannot be written"));
  EXPECT_THAT(names_in(folder / ""), testing::Not(Contains(HasSubstr("copy.db"))));
  EXPECT_TRUE(store.copy_to(folder / "copy.db"));
  EXPECT_THAT(names_in(folder / ""), Contains("copy.db"));
  // A single file, which needs no log.
  std::ifstream bytes(folder / "copy.db", std::ios::binary);
  bytes.seekg(18);
  EXPECT_EQ(bytes.get(), 1) << "bytes 18 and 19 of an SQLite file: 2 where it has a write-ahead log";
}

TEST(Backups, ADatabaseThatIsBeingWrittenIsNotCopied) {
  const TemporaryFolder folder;
  const fs::path file = folder / "one.db";
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec("CREATE TABLE word(text TEXT); INSERT INTO word VALUES('rest')");
  const auto expect_refused = [&] {
    const auto copied = copy_database(database, folder / "copy.db");
    ASSERT_FALSE(copied);
    EXPECT_EQ(copied.error().code, base::Errc::io);
    EXPECT_THAT(copied.error().what, HasSubstr("it is in use"));
    EXPECT_EQ(copied.error().where, (folder / "copy.db").string());
    EXPECT_THAT(names_in(folder / ""), testing::Not(Contains(HasSubstr("copy.db"))));
  };
  {
    SQLite::Database other(file.string(), SQLite::OPEN_READWRITE);
    other.exec("BEGIN EXCLUSIVE");
    expect_refused();
  }
  database.exec("BEGIN; INSERT INTO word VALUES('day')");
  expect_refused();
  database.exec("COMMIT");
  ASSERT_TRUE(copy_database(database, folder / "copy.db"));
  SQLite::Database copy((folder / "copy.db").string());
  EXPECT_EQ(copy.execAndGet("SELECT group_concat(text) FROM word").getString(), "rest,day");
}

TEST(Backups, WhatARestoreReplacedKeepsALogThatCouldNotBeTakenIn) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  const MovedClock clock("2026-01-01T09:00:00Z");
  ASSERT_TRUE(must(LearnerStore::in_memory(clock.clock())).copy_to(folder / "none.db"));
  for (const bool empty : {true, false}) {
    const pid_t child = ::fork();
    if (child == 0) {
      auto store = LearnerStore::open(file, Access::write, clock.clock(), Upkeep::later);
      const bool written = store && store->add_writing(kRest, 6, review(Rating::good));
      if (empty) store = LearnerStore::in_memory();  // closes the file
      ::_exit(written ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_EQ(status, 0);
    const std::string log = empty ? std::string() : bytes_of(file.string() + "-wal");
    ASSERT_EQ(log.empty(), empty);
    std::ofstream(file.string() + "-wal", std::ios::binary) << log;
    // Where the index of the log cannot be made, SQLite does not open the file.
    fs::remove(file.string() + "-shm");
    fs::create_directory(file.string() + "-shm");
    const fs::path kept = must(restore_backup(folder / "none.db", file, clock.clock()));
    EXPECT_EQ(fs::exists(kept.string() + "-wal"), !empty);
    EXPECT_EQ(must(LearnerStore::open(kept, Access::read)).last_entry(), 1);
    EXPECT_THAT(names_in(folder / ""), ElementsAre("backups", "learner.db", "learner.db.lock", "none.db"));
    EXPECT_EQ(must(LearnerStore::open(file, Access::read)).last_entry(), 0);
  }
}

TEST(Backups, WhatIsRestoredIsNotLetGoWithTheOldest) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  MovedClock clock("2026-01-01T09:00:00Z");
  study(file, clock);
  ASSERT_TRUE(must(LearnerStore::open(file, Access::read)).copy_to(folder / "one.db"));
  const fs::path first = must(restore_backup(folder / "one.db", file, clock.clock()));
  for (int i = 0; i < 5; ++i) {
    clock.advance(std::chrono::hours(1));
    age(backup_folder(file));
    (void)must(restore_backup(first, file, clock.clock()));
    EXPECT_TRUE(fs::exists(first)) << i;
  }
  EXPECT_EQ(names_in(backup_folder(file)).size(), static_cast<std::size_t>(kReplacedKept));
}

}  // namespace
}  // namespace nazori::study
