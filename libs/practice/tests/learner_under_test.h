// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "nazori/base/clock.h"
#include "nazori/base/executor.h"
#include "nazori/practice/learner.h"

namespace nazori::practice {

/// A learner in a folder of its own, whose clock the test sets.
class LearnerTest : public testing::Test {
 protected:
  LearnerTest() {
    std::string name = (std::filesystem::temp_directory_path() / "nazori-practice-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the test can be made");
    folder_ = name;
    open_learner();
  }
  ~LearnerTest() override {
    learner_.reset();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  static std::filesystem::path kanji_db() {
    return std::filesystem::path(std::getenv("NAZORI_DATA")) / "kanji.db";
  }

  [[nodiscard]] Learner::Place place() {
    return {folder_ / "learners", {kanji_db(), own_characters()}, [this] { return clock_.calendar(); }};
  }

  /// Where characters are kept that a test makes; there is no such folder before.
  [[nodiscard]] std::filesystem::path own_characters() const { return folder_ / "characters"; }

  /// A learner in the UTC zone, as after a restart of the program.
  void open_learner() {
    learner_.reset();
    learner_ = std::make_unique<Learner>(inbox_, place());
    learner_->announced.connect([this](const LearnerEvent& event) { announced_.push_back(event); });
    learner_->switch_profile("learner");
    if (learner_->can_write() && learner_->store().settings().time_zone != "UTC") {
      auto settings = learner_->store().settings();
      settings.time_zone = "UTC";
      ASSERT_TRUE(learner_->store().change_settings(settings));
    }
  }

  void write(char32_t character) {
    study::Writing writing;
    writing.result.duration = std::chrono::seconds(5);
    ASSERT_TRUE(learner_->report(learner_->store().add_writing(character, 1, writing)));
  }
  /// Waits until the learner's file is no longer being checked.
  void wait_for_upkeep() {
    inbox_.run_until([this] { return !learner_->keeps_up(); });
  }

  std::filesystem::path folder_;
  base::ManualClock clock_{*study::parse_time("2026-03-02T10:00Z")};
  base::Inbox inbox_;
  std::vector<LearnerEvent> announced_;
  std::unique_ptr<Learner> learner_;
};

}  // namespace nazori::practice
