// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/learner_exchange.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "learner_under_test.h"
#include "nazori/study/backups.h"
#include "nazori/study/exchange.h"
#include "nazori/study/profiles.h"

namespace nazori::practice {
namespace {

using Format = LearnerExchange::Format;
using Kind = ExchangeEvent::Kind;
using Work = LearnerExchange::Work;
using testing::ElementsAre;

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class PracticeExchange : public LearnerTest {
 protected:
  PracticeExchange() {
    exchange_->announced.connect([this](const ExchangeEvent& event) {
      EXPECT_FALSE(exchange_->is_busy() && event.kind != Kind::busy);
      events_.push_back(event);
    });
    exchange_->finished.connect([this] { ++finished_; });
  }
  void wait() {
    inbox_.run_until([this] { return !exchange_->is_busy(); });
  }
  /// What was announced last.
  const ExchangeEvent& event() {
    if (events_.empty()) events_.emplace_back();
    return events_.back();
  }
  [[nodiscard]] std::string exported() const { return *study::export_json(learner_->store()); }
  [[nodiscard]] std::filesystem::path file(const char* name) const { return folder_ / name; }

  std::vector<ExchangeEvent> events_;
  int finished_ = 0;
  std::unique_ptr<LearnerExchange> exchange_ = std::make_unique<LearnerExchange>(inbox_, *learner_);
};

TEST_F(PracticeExchange, WhatIsWrittenIsReadIntoANewLearnerOrIntoAnEmptyOne) {
  write(U'一');
  write(U'二');
  const std::string all = exported();
  exchange_->write(Format::json, file("Mari.json"));
  wait();
  EXPECT_EQ(event().kind, Kind::saved);
  EXPECT_EQ(event().file, file("Mari.json"));
  EXPECT_EQ(content(file("Mari.json")), all);
  exchange_->read(file("Mari.json"));
  wait();
  EXPECT_EQ(event().kind, Kind::imported);
  EXPECT_EQ(event().profile, "Mari");
  EXPECT_EQ(event().characters, 2);
  EXPECT_EQ(learner_->profile(), "Mari");
  EXPECT_EQ(exported(), all);
  exchange_->read(file("Mari.json"));
  wait();
  EXPECT_EQ(learner_->profile(), "Mari 2") << "the name is taken";
  ASSERT_TRUE(learner_->switch_profile("empty"));
  exchange_->read(file("Mari.json"));
  wait();
  EXPECT_EQ(learner_->profile(), "empty");
  EXPECT_EQ(exported(), all);
  ASSERT_TRUE(learner_->switch_profile("noted"));
  ASSERT_TRUE(learner_->store().save_list({"mine", {U'一'}}));
  exchange_->read(file("Mari.json"));
  wait();
  EXPECT_EQ(learner_->profile(), "Mari 3") << "a list is something to keep";
}

TEST_F(PracticeExchange, AnImportIsNamedAfterItsFileAsFarAsThatCanBeAName) {
  write(U'一');
  const std::string long_name(70, 'x');
  const std::pair<std::string, std::string> names[] = {
      {"..Mari.json", "learner 2"},
      {"  花子　.json", "花子"},
      {"a.b.json", "a.b"},
      {long_name + ".json", long_name.substr(0, 60)},
      {"花花花花花花花花花花花花花花花花花花花花花.json", "花花花花花花花花花花花花花花花花花花花花"}};
  for (const auto& [name, profile] : names) {
    ASSERT_TRUE(learner_->switch_profile("learner"));
    exchange_->write(Format::json, folder_ / name);
    wait();
    exchange_->read(folder_ / name);
    wait();
    EXPECT_EQ(event().kind, Kind::imported) << name;
    EXPECT_EQ(learner_->profile(), profile) << name;
  }
}

TEST_F(PracticeExchange, OneThingAtATimeIsWrittenOrRead) {
  write(U'一');
  std::vector<Work> started;
  exchange_->started.connect([&](Work work, const std::filesystem::path&) { started.push_back(work); });
  std::vector<int> percents;
  exchange_->progressed().connect([&](int percent) { percents.push_back(percent); });
  exchange_->write(Format::json, file("a.json"));
  EXPECT_TRUE(exchange_->is_busy());
  exchange_->write(Format::csv, file("b.csv"));
  exchange_->read(file("a.json"));
  exchange_->back_up();
  exchange_->restore("x");
  ASSERT_EQ(events_.size(), 4U);
  for (const auto& one : events_) EXPECT_EQ(one.kind, Kind::busy);
  wait();
  EXPECT_EQ(finished_, 1);
  EXPECT_EQ(event().kind, Kind::saved);
  EXPECT_FALSE(std::filesystem::exists(file("b.csv")));
  EXPECT_THAT(started, ElementsAre(Work::write));
  EXPECT_TRUE(std::is_sorted(percents.begin(), percents.end()));
}

TEST_F(PracticeExchange, TablesAndAnkiPackagesAreWritten) {
  write(U'一');
  exchange_->write(Format::csv, file("a.csv"));
  wait();
  EXPECT_EQ(content(file("a.csv")), *study::export_csv(learner_->store()));
  exchange_->write(Format::anki, file("a.apkg"));
  wait();
  EXPECT_TRUE(content(file("a.apkg")).starts_with("PK"));
  exchange_->write(Format::anki, file("b.apkg"), {"grade-1", "Deck", 4});
  wait();
  EXPECT_GT(std::filesystem::file_size(file("b.apkg")), std::filesystem::file_size(file("a.apkg")));
}

TEST_F(PracticeExchange, WhatFailsIsAnnouncedWithItsFileAndChangesNothing) {
  write(U'一');
  for (const auto format : {Format::json, Format::csv, Format::anki}) {
    exchange_->write(format, file("no/such/folder/a.x"));
    wait();
    EXPECT_EQ(event().kind, Kind::exchange_failed);
    EXPECT_EQ(event().file, file("no/such/folder/a.x"));
    EXPECT_FALSE(event().error.what.empty());
  }
  exchange_->read(file("none.json"));
  wait();
  EXPECT_EQ(event().kind, Kind::exchange_failed);
  EXPECT_EQ(event().file, file("none.json"));
  std::ofstream(file("bad.json"))
      << "{\"format\": \"nazori-learner\", \"version\": 1,\n\"entries\": [{\"id\": 7}]}";
  exchange_->read(file("bad.json"));
  wait();
  EXPECT_EQ(event().kind, Kind::exchange_failed);
  exchange_->restore(file("none.db"));
  wait();
  EXPECT_EQ(event().kind, Kind::restore_failed);
  EXPECT_EQ(study::profiles(learner_->folder()), std::vector<std::string>{"learner"});
  EXPECT_TRUE(learner_->can_write());
  EXPECT_TRUE(learner_->store().cards().contains(U'一'));
}

TEST_F(PracticeExchange, WorkThatIsStoppedWritesNothing) {
  write(U'一');
  exchange_->write(Format::anki, file("a.apkg"), {"secondary", "Deck", 4});
  exchange_->stop();
  wait();
  EXPECT_EQ(event().kind, Kind::stopped);
  EXPECT_EQ(finished_, 1);
  EXPECT_FALSE(std::filesystem::exists(file("a.apkg")));
}

TEST_F(PracticeExchange, ABackupIsMadeAndRestoredAndWhatItReplacedIsKept) {
  write(U'一');
  const std::string before = exported();
  exchange_->back_up();
  wait();
  ASSERT_EQ(event().kind, Kind::backed_up);
  const auto backup = event().file;
  EXPECT_TRUE(backup.filename().string().starts_with("own-"));
  write(U'二');
  exchange_->restore(backup);
  EXPECT_FALSE(learner_->can_write());
  EXPECT_EQ(learner_->trouble()->kind, LearnerEvent::Kind::replacing);
  wait();
  EXPECT_EQ(event().kind, Kind::restored);
  EXPECT_TRUE(learner_->can_write());
  EXPECT_EQ(exported(), before);
  const auto backups = study::backups_of(learner_->file());
  EXPECT_TRUE(std::any_of(backups.begin(), backups.end(), [](const study::Backup& one) {
    return one.file.filename().string().starts_with("before-restore-");
  }));
}

TEST_F(PracticeExchange, WhatCannotBeBackedUpIsExplained) {
  learner_->switch_profile("nothing done yet");
  exchange_->back_up();
  EXPECT_EQ(event().kind, Kind::nothing_to_back_up);
  learner_->let_go(LearnerEvent::Kind::replacing);
  exchange_->back_up();
  EXPECT_EQ(event().kind, Kind::no_store);
  EXPECT_EQ(event().trouble, learner_->trouble());
  EXPECT_FALSE(exchange_->is_busy());
  EXPECT_EQ(finished_, 0);
}

TEST_F(PracticeExchange, DestroyedWhileItWorksItLeavesWholeFiles) {
  for (const char32_t character : {U'一', U'二', U'三'}) write(character);
  const std::string all = exported();
  for (int round = 0; round < 4; ++round) {
    LearnerExchange exchange(inbox_, *learner_);
    exchange.write(Format::json, file("a.json"));
    if (round % 2 == 0) inbox_.run_until([&] { return !exchange.is_busy(); });
  }
  EXPECT_EQ(content(file("a.json")), all);
  {
    LearnerExchange exchange(inbox_, *learner_);
    exchange.read(file("a.json"));
  }
  EXPECT_EQ(exported(), all);
}

}  // namespace
}  // namespace nazori::practice
