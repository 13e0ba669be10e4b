// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/backup_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "learner_under_test.h"

namespace nazori::practice {
namespace {

class PracticeBackups : public LearnerTest {
 protected:
  PracticeBackups() {
    wait_for_upkeep();
    std::filesystem::remove_all(study::backup_folder(learner_->file()));
  }
  void put(const char* name, bool sound) {
    const auto folder = study::backup_folder(learner_->file());
    std::filesystem::create_directories(folder);
    if (sound)
      ASSERT_TRUE(learner_->store().copy_to(folder / name));
    else
      std::ofstream(folder / name) << "nothing";
  }
  [[nodiscard]] static bool all_read(const BackupList& list) {
    return std::all_of(list.backups().begin(), list.backups().end(),
                       [](const ListedBackup& one) { return one.contents.has_value(); });
  }
};

TEST_F(PracticeBackups, EachHasItsKindAndWhatItHolds) {
  write(U'一');
  write(U'二');
  put("daily-2026-02-01.db", true);
  put("own-2026-02-02-100000.db", true);
  put("before-restore-2026-02-03-100000.db", true);
  put("daily-2026-01-31.db", false);
  BackupList list(inbox_, *learner_);
  EXPECT_TRUE(list.backups().empty());
  std::set<std::size_t> read;
  list.read.connect([&read](std::size_t one) { EXPECT_TRUE(read.insert(one).second); });
  list.refresh();
  ASSERT_EQ(list.backups().size(), 4U);
  EXPECT_TRUE(std::none_of(list.backups().begin(), list.backups().end(), [](const ListedBackup& one) {
    return one.contents || one.is_sound();
  })) << "not read yet";
  inbox_.run_until([&] { return all_read(list); });
  EXPECT_EQ(read.size(), 4U);
  std::map<std::string, ListedBackup> by_name;
  for (const auto& one : list.backups()) by_name[one.backup.file.filename()] = one;
  EXPECT_EQ(by_name["daily-2026-02-01.db"].kind, BackupKind::daily);
  EXPECT_EQ(by_name["daily-2026-02-01.db"].day, *study::parse_day("2026-02-01"));
  EXPECT_EQ(by_name["own-2026-02-02-100000.db"].kind, BackupKind::own);
  EXPECT_EQ(by_name["own-2026-02-02-100000.db"].day, std::nullopt);
  EXPECT_EQ(by_name["before-restore-2026-02-03-100000.db"].kind, BackupKind::before_restore);
  for (const auto& [name, one] : by_name) {
    EXPECT_EQ(one.is_sound(), name != "daily-2026-01-31.db") << name;
    if (!one.is_sound()) continue;
    EXPECT_EQ((*one.contents)->writings, 2) << name;
    EXPECT_EQ((*one.contents)->characters, 2) << name;
    EXPECT_EQ((*one.contents)->last_day, *study::parse_day("2026-03-02")) << name;
  }
}

TEST_F(PracticeBackups, OfTwoListingsTheNewerIsRead) {
  write(U'一');
  put("own-2026-02-02-100000.db", true);
  put("own-2026-02-03-100000.db", true);
  BackupList list(inbox_, *learner_);
  int reads = 0;
  list.read.connect([&reads](std::size_t) { ++reads; });
  list.refresh();
  std::filesystem::remove(study::backup_folder(learner_->file()) / "own-2026-02-02-100000.db");
  list.refresh();
  ASSERT_EQ(list.backups().size(), 1U);
  inbox_.run_until([&] { return all_read(list); });
  EXPECT_EQ(reads, 1);
  list.refresh();  // destroyed before it is read
}

TEST_F(PracticeBackups, WithoutAnyNothingIsListed) {
  BackupList list(inbox_, *learner_);
  list.refresh();
  EXPECT_TRUE(list.backups().empty());
}

}  // namespace
}  // namespace nazori::practice
