// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/learner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "learner_under_test.h"
#include "nazori/author/collection.h"
#include "nazori/study/backups.h"
#include "nazori/study/profiles.h"

namespace nazori::practice {
namespace {

using Kind = LearnerEvent::Kind;
using testing::ElementsAre;

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class PracticeLearner : public LearnerTest {
 protected:
  /// What is emitted, in order.
  void listen() {
    learner_->changed.connect([this] { heard_.emplace_back("changed"); });
    learner_->profile_changed.connect([this] { heard_.emplace_back("profile"); });
    learner_->announced.connect([this](const LearnerEvent&) { heard_.emplace_back("announced"); });
  }
  /// A character of the learner's own with one stroke.
  [[nodiscard]] char32_t make_character() const {
    author::OwnCharacter sign;
    sign.facts.name = "bar";
    const author::OwnStroke bar{{{{30, 95}, 2, 0.4}, {{80, 80}, 4, 1}}, kanji::StrokeEnding::stop, {}};
    sign.strokes = {bar};
    const auto kept = author::Collection(own_characters()).keep(sign, std::nullopt);
    EXPECT_TRUE(kept);
    return kept.value_or(0);
  }
  std::vector<std::string> heard_;
};

TEST_F(PracticeLearner, BeforeAProfileIsOpenThereIsAnEmptyStoreThatCannotBeSaved) {
  const Learner fresh(inbox_, place());
  EXPECT_FALSE(fresh.can_write());
  EXPECT_FALSE(fresh.trouble());
  EXPECT_TRUE(fresh.store().cards().empty());
  EXPECT_TRUE(fresh.file().empty());
}

TEST_F(PracticeLearner, ANewProfileIsANewLearner) {
  listen();
  EXPECT_TRUE(learner_->switch_profile("花子"));
  EXPECT_THAT(heard_, ElementsAre("profile", "changed"));
  EXPECT_EQ(learner_->profile(), "花子");
  EXPECT_TRUE(learner_->can_write());
  EXPECT_EQ(learner_->file(), folder_ / "learners" / "花子" / "learner.db");
  EXPECT_TRUE(std::filesystem::exists(learner_->file()));
  EXPECT_NE(learner_->lists(), nullptr);
  EXPECT_NE(learner_->database(), nullptr);
  EXPECT_EQ(learner_->source().database, kanji_db());
}

TEST_F(PracticeLearner, ANameThatNoLearnerCanHaveChangesNothing) {
  listen();
  EXPECT_FALSE(learner_->switch_profile("../x"));
  EXPECT_THAT(heard_, ElementsAre("announced"));
  ASSERT_EQ(announced_.size(), 1U);
  EXPECT_EQ(announced_[0].kind, Kind::name_refused);
  EXPECT_EQ(announced_[0].profile, "../x");
  EXPECT_EQ(learner_->profile(), "learner");
  EXPECT_TRUE(learner_->can_write());
}

TEST_F(PracticeLearner, WithoutAFolderNothingIsSaved) {
  const char* const own = std::getenv("NAZORI_LEARNERS");
  const std::string kept = own == nullptr ? "" : own;
  ASSERT_EQ(setenv("NAZORI_LEARNERS", "", 1), 0);
  const std::string home = std::getenv("HOME") == nullptr ? "" : std::getenv("HOME");
  const char* const data = std::getenv("XDG_DATA_HOME");
  const std::string data_home = data == nullptr ? "" : data;
  unsetenv("HOME");
  unsetenv("XDG_DATA_HOME");
  Learner nowhere(inbox_, {{}, kanji_db(), {}});
  setenv("HOME", home.c_str(), 1);
  if (data != nullptr) setenv("XDG_DATA_HOME", data_home.c_str(), 1);
  if (own != nullptr)
    setenv("NAZORI_LEARNERS", kept.c_str(), 1);
  else
    unsetenv("NAZORI_LEARNERS");
  EXPECT_FALSE(nowhere.switch_profile("learner"));
  ASSERT_TRUE(nowhere.trouble());
  EXPECT_EQ(nowhere.trouble()->kind, Kind::no_folder);
}

TEST_F(PracticeLearner, WhatAnotherProgramHasOpenIsReadAndOpensWhenThatHasClosedIt) {
  write(U'一');
  Learner second(inbox_, place());
  std::vector<Kind> announced;
  second.announced.connect([&](const LearnerEvent& event) { announced.push_back(event.kind); });
  EXPECT_FALSE(second.switch_profile("learner"));
  EXPECT_FALSE(second.can_write());
  EXPECT_TRUE(second.store().cards().contains(U'一')) << "what can be read is shown";
  ASSERT_TRUE(second.trouble());
  EXPECT_EQ(second.trouble()->kind, Kind::in_use);
  EXPECT_EQ(second.trouble()->profile, "learner");
  learner_.reset();
  EXPECT_TRUE(second.open_again());
  EXPECT_FALSE(second.trouble());
  EXPECT_THAT(announced, ElementsAre(Kind::in_use, Kind::opened_again));
}

TEST_F(PracticeLearner, ADamagedFileIsLeftByteForByte) {
  const auto path = learner_->file();
  learner_.reset();
  const std::string damaged(5000, 'x');
  std::ofstream(path, std::ios::binary) << damaged;
  open_learner();
  EXPECT_FALSE(learner_->can_write());
  ASSERT_TRUE(learner_->trouble());
  EXPECT_EQ(learner_->trouble()->kind, Kind::damaged);
  EXPECT_EQ(announced_.back(), *learner_->trouble());
  EXPECT_EQ(content(path), damaged);
}

TEST_F(PracticeLearner, DamageThatTheCheckFindsClosesTheFile) {
  wait_for_upkeep();
  for (int i = 0; i < 40; ++i) write(U'一');
  const auto path = learner_->file();
  learner_.reset();
  {
    // Damages pages after the first: the file can be opened, but is not valid.
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(0, std::ios::end);
    const auto size = static_cast<std::streamoff>(file.tellp());
    ASSERT_GT(size, 3 * 4096);
    file.seekp(size - 4096);
    file << std::string(4096, 'x');
  }
  announced_.clear();
  open_learner();
  wait_for_upkeep();
  EXPECT_FALSE(learner_->can_write());
  ASSERT_TRUE(learner_->trouble());
  EXPECT_EQ(learner_->trouble()->kind, Kind::damaged);
  ASSERT_FALSE(announced_.empty());
  EXPECT_EQ(announced_.back(), *learner_->trouble());
}

TEST_F(PracticeLearner, AFileInTheWayOfTheFolderIsNotWritable) {
  std::ofstream(folder_ / "learners" / "blocked") << "a file";
  EXPECT_FALSE(learner_->switch_profile("blocked"));
  ASSERT_TRUE(learner_->trouble());
  EXPECT_EQ(learner_->trouble()->kind, Kind::not_writable);
  EXPECT_EQ(learner_->trouble()->profile, "blocked");
  EXPECT_EQ(learner_->trouble()->folder, folder_ / "learners" / "blocked");
  EXPECT_TRUE(learner_->store().cards().empty());
}

TEST_F(PracticeLearner, TheCauseIsLookedForInTheNearestFolderThatIsThere) {
  const LearnerEvent event = with_cause({}, folder_ / "none" / "deeper" / "learner.db");
  EXPECT_EQ(event.folder, folder_);
  EXPECT_EQ(event.cause, LearnerEvent::Cause::other);
  // In /proc nothing can be written, not even by root.
  EXPECT_NE(with_cause({}, "/proc/1/learner.db").cause, LearnerEvent::Cause::other);
}

TEST_F(PracticeLearner, AnActionIsReportedAsAChangeOrAsNotSaved) {
  listen();
  EXPECT_TRUE(learner_->report(learner_->store().pause(std::vector<char32_t>{U'一'})));
  EXPECT_THAT(heard_, ElementsAre("changed"));
  EXPECT_FALSE(learner_->report(base::Result<void>(base::fail(base::Errc::io, "refused"))));
  ASSERT_EQ(announced_.size(), 1U);
  EXPECT_EQ(announced_[0].kind, Kind::not_saved);
  EXPECT_EQ(announced_[0].error.what, "refused");
  EXPECT_EQ(announced_[0].cause, LearnerEvent::Cause::other);
  EXPECT_THAT(heard_, ElementsAre("changed", "announced"));
  learner_->announce_unread({base::Errc::io, "unread", {}, {}});
  EXPECT_EQ(announced_.back().kind, Kind::unread);
}

TEST_F(PracticeLearner, WhileItIsClosedTheProfileMayBeRenamed) {
  write(U'一');
  learner_->while_closed([this]() -> std::string {
    EXPECT_TRUE(study::rename_profile(folder_ / "learners", "learner", "Mari"));
    return "Mari";
  });
  EXPECT_EQ(learner_->profile(), "Mari");
  EXPECT_TRUE(learner_->can_write());
  EXPECT_TRUE(learner_->store().cards().contains(U'一'));
  learner_->while_closed([]() -> std::string { return {}; });
  EXPECT_EQ(learner_->profile(), "Mari");
}

TEST_F(PracticeLearner, LearnersAreListedRenamedAndRemovedTheCurrentOneToo) {
  ASSERT_TRUE(learner_->switch_profile("次郎"));
  ASSERT_TRUE(learner_->switch_profile("花子"));
  EXPECT_TRUE(learner_->has_profile("次郎"));
  EXPECT_FALSE(learner_->has_profile("三郎"));
  EXPECT_FALSE(learner_->has_profile("../次郎"));
  ASSERT_TRUE(learner_->rename_profile("次郎", "三郎"));
  EXPECT_EQ(learner_->profile(), "花子") << "the current learner stays";
  ASSERT_TRUE(learner_->rename_profile("花子", "一子"));
  EXPECT_EQ(learner_->profile(), "一子");
  EXPECT_TRUE(learner_->can_write());
  EXPECT_FALSE(learner_->rename_profile("一子", "三郎")) << "another has this name";
  EXPECT_EQ(learner_->profile(), "一子");
  EXPECT_TRUE(learner_->can_write()) << "open again after the error";
  EXPECT_THAT(learner_->profiles(), testing::IsSupersetOf({"一子", "三郎"}));
  EXPECT_THAT(learner_->profiles(), testing::Not(testing::Contains("花子")));

  const auto removed = learner_->remove_profile("一子");
  ASSERT_TRUE(removed);
  EXPECT_TRUE(std::filesystem::exists(*removed / "learner.db")) << "nothing is deleted";
  EXPECT_NE(learner_->profile(), "一子");
  EXPECT_TRUE(learner_->can_write());
  while (learner_->has_profile(learner_->profile())) {
    const std::string last = learner_->profile();
    ASSERT_TRUE(learner_->remove_profile(last));
    if (learner_->profile() == last) break;
  }
  EXPECT_EQ(learner_->profile(), study::kDefaultProfile) << "the last one is replaced by a new one";
}

TEST_F(PracticeLearner, ALearnerWithoutAFileIsListedToo) {
  const Learner fresh(inbox_, place());
  EXPECT_THAT(fresh.profiles(), testing::Contains(fresh.profile()));
}

TEST_F(PracticeLearner, LetGoItHasNoStoreUntilItIsOpenedAgain) {
  write(U'一');
  listen();
  learner_->let_go(Kind::replacing);
  EXPECT_THAT(heard_, ElementsAre("profile", "changed"));
  EXPECT_FALSE(learner_->can_write());
  EXPECT_TRUE(learner_->store().cards().empty());
  EXPECT_EQ(learner_->trouble()->kind, Kind::replacing);
  EXPECT_TRUE(announced_.empty());
  EXPECT_TRUE(learner_->open_again());
  EXPECT_EQ(announced_.back().kind, Kind::opened_again);
  EXPECT_TRUE(learner_->store().cards().contains(U'一'));
}

TEST_F(PracticeLearner, ANewStudyDayIsNoticedOnceAndBackedUp) {
  wait_for_upkeep();
  write(U'一');
  // The first check may have run on an empty store, of which no backup is made.
  ASSERT_TRUE(learner_->open_again());
  wait_for_upkeep();
  listen();
  learner_->tick();
  EXPECT_TRUE(heard_.empty());
  for (int day = 1; day <= 3; ++day) {
    clock_.advance(std::chrono::hours(24));
    learner_->tick();
    learner_->tick();
    EXPECT_THAT(heard_, ElementsAre("changed")) << "once a day";
    EXPECT_TRUE(learner_->keeps_up());
    wait_for_upkeep();
    heard_.clear();
  }
  EXPECT_EQ(study::backups_of(learner_->file()).size(), 4U) << "today's and one of each day";
}

TEST_F(PracticeLearner, ABackupThatFailsIsAnnouncedAndKeptInMind) {
  wait_for_upkeep();
  write(U'一');
  const auto backups = study::backup_folder(learner_->file());
  std::filesystem::remove_all(backups);
  std::ofstream(backups) << "a file in its place";
  clock_.advance(std::chrono::hours(24));
  learner_->tick();
  wait_for_upkeep();
  ASSERT_TRUE(learner_->backup_trouble());
  EXPECT_EQ(learner_->backup_trouble()->kind, Kind::backup_failed);
  EXPECT_EQ(announced_.back(), *learner_->backup_trouble());
  EXPECT_FALSE(learner_->trouble()) << "studying works";
  std::filesystem::remove(backups);
  EXPECT_TRUE(learner_->open_again());
  wait_for_upkeep();
  EXPECT_FALSE(learner_->backup_trouble());
}

TEST_F(PracticeLearner, ListsThatChangedChangeWhatIsLearntNext) {
  ASSERT_TRUE(learner_->store().save_list({"few", {U'二', U'一'}}));
  auto settings = learner_->store().settings();
  settings.new_lists = {"list:few"};
  settings.new_order = study::NewOrder::own;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  ASSERT_EQ(learner_->plan()->now.front().character, U'二');
  ASSERT_TRUE(learner_->store().save_list({"few", {U'三'}}));
  listen();
  learner_->renew_order();
  EXPECT_THAT(heard_, ElementsAre("changed"));
  EXPECT_EQ(learner_->plan()->now.front().character, U'三');
}

TEST_F(PracticeLearner, ListsStayWhereTheyAreWhenCharactersAreMade) {
  const study::CharacterLists* const lists = learner_->lists();
  const char32_t made = make_character();
  EXPECT_EQ(learner_->lists()->facts(made), nullptr);
  listen();
  learner_->renew_characters();
  EXPECT_THAT(heard_, ElementsAre("changed"));
  EXPECT_EQ(learner_->lists(), lists) << "others hold the address";
  EXPECT_NE(learner_->lists()->facts(made), nullptr);
  learner_->renew_characters();
  EXPECT_THAT(heard_, ElementsAre("changed")) << "nothing is new";
}

TEST_F(PracticeLearner, WhatIsCheckedIsDroppedWhenTheLearnerGoes) {
  write(U'一');
  for (int round = 0; round < 5; ++round) {
    open_learner();
    EXPECT_TRUE(learner_->can_write());
  }
  learner_.reset();
  bool is_empty = false;
  inbox_.post([&is_empty] { is_empty = true; });
  inbox_.run_until([&is_empty] { return is_empty; });
}

}  // namespace
}  // namespace nazori::practice
