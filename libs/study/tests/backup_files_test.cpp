// SPDX-License-Identifier: Apache-2.0
// The backups beside a learner's file: their names, their order and what is told while one is made.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "learner_fixture.h"
#include "nazori/study/backups.h"

namespace nazori::study {
namespace {

namespace fs = std::filesystem;
using test::MovedClock;
using test::must;
using test::review;
using test::TemporaryFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr char32_t kRest = U'休';

void study(const fs::path& file, const MovedClock& clock) {
  LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::later));
  (void)must(store.add_writing(kRest, 6, review(Rating::good)));
}

/// Names of all files there, sorted.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(BackupFiles, AreListedNewestFirstWithWhatTheyAre) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  EXPECT_TRUE(backups_of(file).empty());
  const fs::path backups = backup_folder(file);
  EXPECT_EQ(backups, folder / "backups");
  fs::create_directories(backups / "folder.db");
  const auto now = fs::file_time_type::clock::now();
  int hours_ago = 0;
  for (const char* name : {"daily-2026-01-03.db", "own-20260103T090000Z.db", "daily-2026-02-30.db",
                           "daily-.db", "before-restore-x.db", "daily-2026-01-01.db"}) {
    std::ofstream(backups / name) << std::string(static_cast<std::size_t>(hours_ago) + 1, 'x');
    fs::last_write_time(backups / name, now - std::chrono::hours(hours_ago++));
  }
  for (const char* name : {"daily-2026-01-02.db.part", "letter.txt", "daily-2026-01-04"})
    std::ofstream(backups / name) << "x";
  std::vector<Backup> expected;
  for (const char* name : {"daily-2026-01-03.db", "own-20260103T090000Z.db", "daily-2026-02-30.db",
                           "daily-.db", "before-restore-x.db", "daily-2026-01-01.db"})
    expected.push_back({backups / name, expected.size() + 1, expected.empty() || expected.size() == 5});
  EXPECT_EQ(backups_of(file), expected);
  // Files of the same time are sorted by name, the last first.
  for (const Backup& one : expected) fs::last_write_time(one.file, now);
  std::vector<std::string> names;
  for (const Backup& one : backups_of(file)) names.push_back(one.file.filename().string());
  EXPECT_TRUE(std::is_sorted(names.rbegin(), names.rend()));
  EXPECT_EQ(names.size(), 6U);
  EXPECT_EQ(Backup().bytes, 0U);
  EXPECT_FALSE(Backup().automatic);
  EXPECT_EQ(BackupContents().writings + BackupContents().characters, 0);
}

TEST(BackupFiles, OfTheLearnersOwnAreNamedByTheirMoment) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  const MovedClock clock("2026-11-21T13:42:06.789Z");
  LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock()));
  (void)must(store.add_writing(kRest, 6, review(Rating::good)));
  for (int i = 0; i < 3; ++i) {
    const fs::path made = must(make_backup(store, file));
    EXPECT_EQ(made.filename(), "own-20261121T134206Z" + (i == 0 ? "" : "-" + std::to_string(i + 1)) + ".db");
    EXPECT_EQ(must(look_into(made)).writings, 1);
  }
  EXPECT_EQ(names_in(backup_folder(file)).size(), 3U) << "with nothing beside them";
}

TEST(BackupFiles, TellTheShareThatIsCopiedAndStop) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock()));
  ASSERT_TRUE(store.fill(test::long_history(40'000)));
  std::vector<double> reported;
  const fs::path made = must(make_backup(store, file, [&](double done, std::string_view step) {
    EXPECT_EQ(step, "copy");
    reported.push_back(done);
    return true;
  }));
  // 1,024 pages of 4 KiB at a time.
  const auto pages = static_cast<double>(fs::file_size(made)) / 4'096;
  ASSERT_GT(pages, 1'024);
  ASSERT_EQ(reported.size(), static_cast<std::size_t>(std::ceil(pages / 1'024)));
  for (std::size_t i = 0; i + 1 < reported.size(); ++i)
    EXPECT_NEAR(reported[i], static_cast<double>(i + 1) * 1'024 / pages, 1e-9);
  EXPECT_EQ(reported.back(), 1);
  std::size_t asked = 0;
  const auto stopped =
      store.copy_to(folder / "copy.db", [&](double, std::string_view) { return ++asked < 2; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, base::Errc::cancelled);
  EXPECT_EQ(asked, 2U);
  EXPECT_THAT(names_in(folder / ""), testing::Not(Contains(HasSubstr("copy.db"))));
}

TEST(BackupFiles, AFolderThatCannotBeMadeIsNamed) {
  const TemporaryFolder folder;
  const fs::path file = folder / "learner.db";
  LearnerStore store =
      must(LearnerStore::open(file, Access::write, MovedClock("2026-01-01T09:00:00Z").clock()));
  (void)must(store.add_writing(kRest, 6, review(Rating::good)));
  std::ofstream(backup_folder(file)) << "in the way";
  const auto made = make_backup(store, file);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().where, backup_folder(file).string());
  EXPECT_THAT(made.error().what, HasSubstr("cannot be created"));
}

TEST(BackupFiles, ALearnerWhoIsGoneIsRestoredWithoutAnythingReplaced) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  study(folder / "learner.db", clock);
  ASSERT_TRUE(must(LearnerStore::open(folder / "learner.db", Access::read)).copy_to(folder / "one.db"));
  const fs::path other = folder / "new" / "learner.db";
  EXPECT_EQ(must(restore_backup(folder / "one.db", other, clock.clock())), fs::path());
  EXPECT_EQ(must(LearnerStore::open(other, Access::read)).last_entry(), 1);
  EXPECT_THAT(names_in(folder / "new"), ElementsAre("learner.db", "learner.db.lock"));
}

}  // namespace
}  // namespace nazori::study
