// SPDX-License-Identifier: Apache-2.0
// The check and the backup behind a store that is in use.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "learner_fixture.h"
#include "nazori/study/backups.h"

namespace nazori::study {
namespace {

namespace fs = std::filesystem;
using base::Errc;
using test::MovedClock;
using test::must;
using test::review;
using test::TemporaryFolder;

constexpr char32_t kTree = U'木';

LearnerStore opened(const fs::path& file, const MovedClock& clock) {
  return must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::later));
}

TEST(Upkeep, TodaysBackupIsMadeBesideAStoreInUse) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  LearnerStore store = opened(file, clock);
  (void)must(store.add_writing(kTree, 4, review(Rating::good)));
  EXPECT_TRUE(backups_of(file).empty()) << "opening leaves it for later";
  EXPECT_FALSE(must(keep_up(file, store.today())).backup_trouble);
  ASSERT_EQ(backups_of(file).size(), 1U);
  EXPECT_TRUE(backups_of(file).front().automatic);
  EXPECT_EQ(must(look_into(backups_of(file).front().file)).writings, 1);
  (void)must(store.add_writing(kTree, 4, review(Rating::good)));
  EXPECT_FALSE(must(keep_up(file, store.today())).backup_trouble);
  EXPECT_EQ(backups_of(file).size(), 1U) << "one a day";
}

TEST(Upkeep, WhatIsWrittenDuringTheBackupIsNeitherLostNorHalfInIt) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  LearnerStore store = opened(file, clock);
  ASSERT_TRUE(store.fill(test::long_history(9'000)));
  int looks = 0;
  const auto write = [&](double, std::string_view) {
    if (++looks % 3 == 0) (void)must(store.add_writing(kTree, 4, review(Rating::good)));
    return true;
  };
  EXPECT_FALSE(must(keep_up(file, store.today(), write)).backup_trouble);
  EXPECT_GT(store.last_entry(), 9'000);
  EXPECT_EQ(must(look_into(backups_of(file).front().file)).writings, 9'000);
}

TEST(Upkeep, ThatIsStoppedLeavesNothingBehind) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  LearnerStore store = opened(file, clock);
  ASSERT_TRUE(store.fill(test::long_history(9'000)));
  for (const std::string_view stopped : {"check", "copy"}) {
    const auto progress = [&](double, std::string_view step) { return step != stopped; };
    const auto kept = keep_up(file, store.today(), progress);
    ASSERT_FALSE(kept) << stopped;
    EXPECT_EQ(kept.error().code, Errc::cancelled);
    std::error_code none;
    EXPECT_TRUE(!fs::exists(backup_folder(file)) || fs::is_empty(backup_folder(file), none)) << stopped;
  }
}

TEST(Upkeep, FindsADamagedPage) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  {
    LearnerStore store = opened(file, clock);
    ASSERT_TRUE(store.fill(test::long_history(3'000)));
  }
  {
    // Far after the pages that opening reads: a page of the log.
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(static_cast<std::streamoff>(fs::file_size(file) / 2));
    bytes << std::string(8'192, '\xee');
  }
  const LearnerStore store = opened(file, clock);
  const auto kept = keep_up(file, store.today());
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().code, Errc::parse);
  EXPECT_TRUE(backups_of(file).empty()) << "a damaged file replaces no backup";
}

TEST(Upkeep, ABackupThatCannotBeMadeIsSaid) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  LearnerStore store = opened(file, clock);
  (void)must(store.add_writing(kTree, 4, review(Rating::good)));
  std::ofstream(backup_folder(file)) << "in the way";
  const UpkeepReport report = must(keep_up(file, store.today()));
  ASSERT_TRUE(report.backup_trouble);
  EXPECT_EQ(report.backup_trouble->code, Errc::io);
}

TEST(Upkeep, OfANewLearnerMakesNoBackup) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  const fs::path file = folder / "learner.db";
  const LearnerStore store = opened(file, clock);
  EXPECT_FALSE(must(keep_up(file, store.today())).backup_trouble);
  EXPECT_TRUE(backups_of(file).empty());
}

}  // namespace
}  // namespace nazori::study
