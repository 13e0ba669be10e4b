// SPDX-License-Identifier: Apache-2.0
// What can happen to a learner's file: death at any moment, a full disk, other programs, damage, age.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <random>
#include <thread>

#include "learner_fixture.h"
#include "nazori/study/backups.h"
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
using test::some_ink;
using test::TemporaryFolder;
using testing::HasSubstr;

constexpr char32_t kRest = U'休';

void write_file(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Runs `work` in a separate process. @return its exit code, 128 + a signal's number.
template <class Work>
int in_child(Work work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Permissions do not restrict the superuser, and the group has its own permissions.
bool gives_up_privileges() {
  constexpr int kNobody = 65'534;
  return ::geteuid() != 0 ||
         (::setgroups(0, nullptr) == 0 && ::setgid(kNobody) == 0 && ::setuid(kNobody) == 0);
}

/// Reviews endlessly; writes the number of each acknowledged entry into `channel`.
[[noreturn]] void review_until_killed(const fs::path& file, int channel) {
  auto store = LearnerStore::open(file, Access::write);
  if (!store) ::_exit(3);
  for (char32_t c = U'一';; c = c < U'三' + 50 ? c + 1 : U'一') {
    if (!store->add_writing(c, 4, review(kRatings[c % 4]), some_ink())) ::_exit(4);
    if (c % 16 == 0 && !store->undo()) ::_exit(5);
    const std::int64_t entry = store->last_entry();
    if (::write(channel, &entry, sizeof entry) != sizeof entry) ::_exit(6);
  }
}

TEST(StoreSafety, NoAcknowledgedReviewIsLostWhenTheProgramIsKilled) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  std::mt19937 random(20261121);
  std::int64_t acknowledged = 0;
  int with_reviews = 0;
  for (int round = 0; round < 200; ++round) {
    std::array<int, 2> channel{};
    ASSERT_EQ(::pipe(channel.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(channel[0]);
      review_until_killed(file, channel[1]);
    }
    ::close(channel[1]);
    // In most rounds the child is killed shortly after an acknowledgement, else while it opens the file.
    std::int64_t entry = 0;
    int wanted = static_cast<int>(random() % 4);
    const int had = wanted;
    for (; wanted > 0 && ::read(channel[0], &entry, sizeof entry) == sizeof entry; --wanted)
      acknowledged = entry;
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 4'000));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the reviewer ended by itself: " << WEXITSTATUS(status);
    while (::read(channel[0], &entry, sizeof entry) == sizeof entry) acknowledged = entry;
    ::close(channel[0]);
    with_reviews += had > 0 ? 1 : 0;

    auto store = LearnerStore::open(file, Access::write);  // checks the file whole
    ASSERT_TRUE(store) << "round " << round << ": " << base::to_line(store.error());
    ASSERT_GE(store->last_entry(), acknowledged) << "round " << round;
    ASSERT_LE(store->last_entry(), acknowledged + 2) << "round " << round;
    // The rows of one action are all there or none is, also in the indexes.
    const auto report = store->rebuild();
    ASSERT_TRUE(report) << base::to_line(report.error());
    ASSERT_EQ(report->differences, 0) << "round " << round;
    SQLite::Database db(file.string(), SQLite::OPEN_READONLY);
    ASSERT_EQ(db.execAndGet("PRAGMA integrity_check(1)").getString(), "ok") << "round " << round;
    acknowledged = store->last_entry();
  }
  EXPECT_GT(with_reviews, 100);
}

TEST(StoreSafety, ASecondWindowIsToldAndReadersAreLetIn) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  EXPECT_FALSE(LearnerStore::in_use(file));
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write));
    (void)must(store.add_writing(kRest, 6, review(Rating::good)));
    const auto second = LearnerStore::open(file, Access::write);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, Errc::in_use);
    EXPECT_THAT(base::to_line(second.error()), HasSubstr("open in another Nazori"));
    EXPECT_TRUE(LearnerStore::in_use(file));
    EXPECT_FALSE(restore_backup(file, file));
    const LearnerStore reader = must(LearnerStore::open(file, Access::read));
    EXPECT_EQ(reader.cards(), store.cards());
  }
  EXPECT_FALSE(LearnerStore::in_use(file));
  EXPECT_TRUE(LearnerStore::open(file, Access::write));
}

TEST(StoreSafety, ReadingALearnerWhoHasNoFileMakesNone) {
  const TemporaryFolder folder;
  EXPECT_TRUE(must(LearnerStore::open(folder / "none" / "learner.db", Access::read)).cards().empty());
  EXPECT_FALSE(fs::exists(folder / "none"));
}

TEST(StoreSafety, AFolderThatMayNotBeEnteredIsNoEmptyLearner) {
  const TemporaryFolder folder;
  const fs::path file = folder / "closed" / "learner.db";
  (void)must(must(LearnerStore::open(file, Access::write)).add_writing(kRest, 6, review(Rating::good)));
  fs::permissions(folder / "", fs::perms::all);
  fs::permissions(folder / "closed", fs::perms::none);
  const int code = in_child([&] {
    if (!gives_up_privileges()) return 77;
    for (const Access access : {Access::read, Access::backup, Access::write}) {
      const auto store = LearnerStore::open(file, access);
      if (store || store.error().code != Errc::io) return 1;
    }
    return 0;
  });
  EXPECT_EQ(code, 0);
  fs::permissions(folder / "closed", fs::perms::owner_all);
}

TEST(StoreSafety, AFileThatMayNotGrowLosesNothing) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  const int code = in_child([&] {
    auto store = LearnerStore::open(file, Access::write);
    if (!store) return 1;
    // Simulates a disk that fills up: writes beyond this size fail.
    const rlimit limit{240'000, 240'000};
    (void)std::signal(SIGXFSZ, SIG_IGN);
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 2;
    std::int64_t acknowledged = 0;
    for (int i = 0; i < 10'000; ++i) {
      const auto card = store->add_writing(kRest, 6, review(Rating::good), some_ink(i));
      if (!card) {
        if (card.error().code != Errc::io || card.error().where.empty()) return 3;
        if (store->last_entry() != acknowledged) return 4;
        // What was there stays readable in the same window.
        return store->writings_of(kRest)->size() == static_cast<std::size_t>(acknowledged) ? 0 : 5;
      }
      acknowledged = store->last_entry();
    }
    return 6;
  });
  EXPECT_EQ(code, 0);
  LearnerStore store = must(LearnerStore::open(file, Access::write));
  EXPECT_GT(store.last_entry(), 5);
  EXPECT_EQ(must(store.rebuild()).differences, 0);
}

TEST(StoreSafety, WhereNothingMayGrowALearnerCanBeReadAndIsToldWhyNotMore) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  (void)must(must(LearnerStore::open(file, Access::write)).add_writing(kRest, 6, review(Rating::good)));
  const int code = in_child([&] {
    // Simulates a disk without a free block: not even the index of a write-ahead log can be made.
    const rlimit limit{100, 100};
    (void)std::signal(SIGXFSZ, SIG_IGN);
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 1;
    const auto store = LearnerStore::open(file, Access::read);
    if (!store || store->last_entry() != 1) return 2;
    const auto written = LearnerStore::open(file, Access::write);
    if (written || written.error().code != Errc::io) return 3;
    return base::to_line(written.error()).find("disk is full") != std::string::npos ? 0 : 4;
  });
  EXPECT_EQ(code, 0);
  EXPECT_EQ(must(LearnerStore::open(file, Access::write)).last_entry(), 1);
}

TEST(StoreSafety, AFolderThatMayNotBeWrittenIsNamed) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "closed");
  (void)must(LearnerStore::open(folder / "closed" / "learner.db", Access::write));
  fs::remove(folder / "closed" / "learner.db.lock");
  fs::permissions(folder / "", fs::perms::all);
  fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                                         fs::perms::others_exec);
  const int code = in_child([&] {
    if (!gives_up_privileges()) return 77;
    const auto store = LearnerStore::open(folder / "closed" / "learner.db", Access::write);
    if (store || store.error().code != Errc::io) return 1;
    if (base::to_line(store.error()).find("closed") == std::string::npos) return 2;
    return LearnerStore::open(folder / "closed" / "learner.db", Access::read) ? 0 : 3;
  });
  EXPECT_EQ(code, 0);
  fs::permissions(folder / "closed", fs::perms::owner_all);
}

/// Opening must fail with `code` and leave the file unchanged, both for writing and for reading.
void expect_refused_untouched(const fs::path& file, Errc code, const char* word) {
  const std::string before = bytes_of(file);
  for (const Access access : {Access::write, Access::read}) {
    const auto store = LearnerStore::open(file, access);
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().code, code) << base::to_line(store.error());
    EXPECT_THAT(base::to_line(store.error()), HasSubstr(word));
    EXPECT_EQ(bytes_of(file), before);
  }
  EXPECT_TRUE(backups_of(file).empty());
}

TEST(StoreSafety, AFileOfANewerVersionIsLeftAlone) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  (void)must(LearnerStore::open(file, Access::write));
  {
    SQLite::Database db(file.string(), SQLite::OPEN_READWRITE);
    db.exec("PRAGMA journal_mode = DELETE; PRAGMA user_version = 99");
  }
  expect_refused_untouched(file, Errc::schema, "newer");
}

TEST(StoreSafety, AForeignFileIsLeftAlone) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  write_file(file, "this is a letter, not a learner\n");
  expect_refused_untouched(file, Errc::parse, "damaged");
  fs::remove(file);
  {
    SQLite::Database db(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    db.exec("CREATE TABLE x(y)");
  }
  expect_refused_untouched(file, Errc::schema, "is not a Nazori study file");
}

TEST(StoreSafety, ADamagedFileIsLeftAloneAndABackupBringsTheLearnerBack) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  MovedClock clock("2026-01-01T09:00:00Z");
  Cards before;
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock()));
    for (char32_t c = U'一'; c < U'一' + 40; ++c)
      (void)must(store.add_writing(c, 4, review(Rating::good), some_ink()));
    before = store.cards();
  }
  clock.advance(days(1));
  (void)must(LearnerStore::open(file, Access::write, clock.clock()));  // makes the backup of the day
  ASSERT_EQ(backups_of(file).size(), 1U);
  std::string bytes = bytes_of(file);
  for (std::size_t i = 5'000; i < bytes.size(); i += 700) bytes[i] = static_cast<char>(~bytes[i]);
  write_file(file, bytes);
  const auto damaged = LearnerStore::open(file, Access::write, clock.clock());
  ASSERT_FALSE(damaged);
  EXPECT_EQ(damaged.error().code, Errc::parse);
  EXPECT_THAT(base::to_line(damaged.error()), HasSubstr("study restore"));
  EXPECT_EQ(bytes_of(file), bytes);

  const fs::path kept = must(restore_backup(backups_of(file)[0].file, file, clock.clock()));
  EXPECT_EQ(bytes_of(kept), bytes);
  EXPECT_EQ(must(LearnerStore::open(file, Access::write, clock.clock())).cards(), before);
}

TEST(StoreSafety, OneBackupADayAndSevenAreKept) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  MovedClock clock("2026-01-01T09:00:00Z");
  for (int day = 0; day < 12; ++day, clock.advance(days(1))) {
    for (int window = 0; window < 2; ++window) {
      LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock()));
      EXPECT_FALSE(store.backup_trouble());
      (void)must(store.add_writing(kRest, 6, review(Rating::good)));
    }
  }
  std::vector<std::string> names;
  for (const Backup& backup : backups_of(file)) names.push_back(backup.file.filename().string());
  std::sort(names.begin(), names.end());
  ASSERT_EQ(names.size(), 7U);
  EXPECT_EQ(names.front(), "daily-2026-01-06.db");
  EXPECT_EQ(names.back(), "daily-2026-01-12.db");
  // The backup of a day contains the data from the beginning of the day.
  EXPECT_EQ(must(LearnerStore::open(folder / "backups" / "daily-2026-01-12.db", Access::read)).last_entry(),
            22);
}

TEST(StoreSafety, AFileThatIsNoBackupIsNotRestored) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write));
    (void)must(store.add_writing(kRest, 6, review(Rating::good)));
  }
  write_file(folder / "letter.db", "dear learner");
  const std::string before = bytes_of(file);
  EXPECT_EQ(restore_backup(folder / "letter.db", file).error().code, Errc::parse);
  EXPECT_EQ(restore_backup(folder / "none.db", file).error().code, Errc::not_found);
  EXPECT_EQ(bytes_of(file), before);
}

TEST(StoreSafety, WhoIsKilledWhileRestoringHasTheOldFileOrTheBackup) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write));
    (void)must(store.add_writing(kRest, 6, review(Rating::good), some_ink()));
    ASSERT_TRUE(store.copy_to(folder / "one.db"));
    (void)must(store.add_writing(kRest, 6, review(Rating::good), some_ink()));
    ASSERT_TRUE(store.copy_to(folder / "two.db"));
  }
  std::mt19937 random(20261122);
  std::array<int, 3> had{};  // by the number of entries
  for (int round = 0; round < 100; ++round) {
    std::array<int, 2> channel{};
    ASSERT_EQ(::pipe(channel.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(channel[0]);
      for (int i = 0;; ++i) {
        if (!restore_backup(folder / (i % 2 == 0 ? "one.db" : "two.db"), file)) ::_exit(1);
        if (::write(channel[1], "x", 1) != 1) ::_exit(2);
      }
    }
    ::close(channel[1]);
    // Killed shortly after a restore has finished, or during the first one.
    char done = 0;
    for (auto wanted = random() % 3; wanted > 0 && ::read(channel[0], &done, 1) == 1;) --wanted;
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 20'000));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ::close(channel[0]);
    ASSERT_TRUE(WIFSIGNALED(status)) << "restoring ended by itself: " << WEXITSTATUS(status);
    ASSERT_TRUE(fs::exists(file)) << "round " << round;
    const auto store = LearnerStore::open(file, Access::write);
    ASSERT_TRUE(store) << "round " << round << ": " << base::to_line(store.error());
    ASSERT_TRUE(store->last_entry() == 1 || store->last_entry() == 2) << store->last_entry();
    ++had[static_cast<std::size_t>(store->last_entry())];
    fs::remove_all(backup_folder(file));
  }
  EXPECT_GT(had[1], 0);
  EXPECT_GT(had[2], 0);
}

TEST(StoreSafety, ThereIsAFileAtEveryMomentOfARestore) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write));
    (void)must(store.add_writing(kRest, 6, review(Rating::good)));
    ASSERT_TRUE(store.copy_to(folder / "one.db"));
  }
  const pid_t child = ::fork();
  if (child == 0) {
    for (int i = 0; i < 100; ++i)
      if (!restore_backup(folder / "one.db", file)) ::_exit(1);
    ::_exit(0);
  }
  std::int64_t missing = 0;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0)
    for (int look = 0; look < 100; ++look) missing += ::access(file.c_str(), F_OK) == 0 ? 0 : 1;
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_EQ(missing, 0);
}

TEST(StoreSafety, WhatARestoredBackupReplacedIsKeptEachTime) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  const MovedClock clock("2026-01-01T09:00:00Z");  // stands still
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock()));
    (void)must(store.add_writing(kRest, 6, review(Rating::good)));
    ASSERT_TRUE(store.copy_to(folder / "one.db"));
    (void)must(store.add_writing(kRest, 6, review(Rating::good)));
  }
  const fs::path first = must(restore_backup(folder / "one.db", file, clock.clock()));
  const fs::path second = must(restore_backup(first, file, clock.clock()));
  EXPECT_NE(first, second);
  EXPECT_EQ(must(LearnerStore::open(first, Access::read)).last_entry(), 2);
  EXPECT_EQ(must(LearnerStore::open(second, Access::read)).last_entry(), 1);
  EXPECT_EQ(must(LearnerStore::open(file, Access::read)).last_entry(), 2);
}

TEST(StoreSafety, WhatIsStillInTheWriteAheadLogIsKeptByARestore) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  ASSERT_TRUE(must(LearnerStore::in_memory()).copy_to(folder / "none.db"));
  ASSERT_EQ(in_child([&] {
              auto store = LearnerStore::open(file, Access::write);
              if (!store || !store->add_writing(kRest, 6, review(Rating::good), some_ink())) return 1;
              ::_exit(0);  // without closing the file
            }),
            0);
  ASSERT_GT(fs::file_size(file.string() + "-wal"), 0U);
  const fs::path kept = must(restore_backup(folder / "none.db", file));
  EXPECT_EQ(must(LearnerStore::open(file, Access::write)).last_entry(), 0);
  fs::remove(kept.string() + "-wal");
  EXPECT_EQ(must(LearnerStore::open(kept, Access::read)).last_entry(), 1) << "in the one file";
}

TEST(StoreSafety, AFileOfVersionOneIsRead) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  {
    SQLite::Database db(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    db.exec(bytes_of(std::string(test_paths::kFixtures) + "/learner-v1.sql"));
  }
  LearnerStore store = must(LearnerStore::open(file, Access::write));
  EXPECT_EQ(store.last_entry(), 4);
  const Card card = store.card(kRest);
  EXPECT_EQ(card.memory.phase, Phase::review);
  EXPECT_EQ(card.memory.stability, 8.2956);
  EXPECT_EQ(card.due_day, *parse_day("2026-01-09"));
  EXPECT_EQ(store.settings().new_per_day, 9);
  EXPECT_EQ(must(store.ink_of(2)).size(), 1U);
  EXPECT_EQ(must(store.lists()).at(0).name, "trees");
  EXPECT_EQ(must(store.rebuild()).differences, 0);
}

}  // namespace
}  // namespace nazori::study
