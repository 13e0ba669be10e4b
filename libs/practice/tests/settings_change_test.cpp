// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/settings_change.h"

#include <gtest/gtest.h>

#include "learner_under_test.h"

namespace nazori::practice {
namespace {

class PracticeSettings : public LearnerTest {
 protected:
  /// Waits for the end. @return the result.
  base::Result<void> wait_for(SettingsChange& change) {
    base::Result<void> done;
    int ends = 0;
    const base::Connection heard = change.finished.connect([&](const base::Result<void>& result) {
      done = result;
      ++ends;
    });
    inbox_.run_until([&] { return ends > 0; });
    EXPECT_FALSE(change.is_busy());
    return done;
  }
};

TEST_F(PracticeSettings, ThatChangeEveryCardAreSavedBehind) {
  write(U'一');
  auto wanted = learner_->store().settings();
  wanted.new_per_day = 3;
  EXPECT_FALSE(SettingsChange::takes_long(learner_->store(), wanted));
  wanted.fsrs.weights.front() = 0.5;
  EXPECT_FALSE(SettingsChange::takes_long(learner_->store(), wanted)) << "of one writing";
  SettingsChange change(inbox_, *learner_);
  change.start(wanted);
  EXPECT_TRUE(change.is_busy());
  EXPECT_FALSE(learner_->can_write());
  EXPECT_EQ(learner_->trouble()->kind, LearnerEvent::Kind::changing_settings);
  EXPECT_EQ(learner_->trouble()->profile, "learner");
  EXPECT_TRUE(wait_for(change));
  EXPECT_TRUE(learner_->can_write());
  EXPECT_EQ(learner_->store().settings(), wanted);
  wanted.new_per_day = 5000;
  change.start(wanted);
  EXPECT_FALSE(wait_for(change)) << "there is no such number";
  EXPECT_EQ(learner_->store().settings().new_per_day, 3);
  EXPECT_TRUE(learner_->can_write());
}

TEST_F(PracticeSettings, OfAThousandActionsTakeLong) {
  auto wanted = learner_->store().settings();
  wanted.fsrs.weights.front() = 0.5;
  const std::vector<char32_t> one{U'一'};
  while (learner_->store().last_entry() < 1000) {
    const bool is_paused = learner_->store().card(one.front()).paused;
    ASSERT_TRUE(is_paused ? learner_->store().resume(one) : learner_->store().pause(one));
  }
  EXPECT_FALSE(SettingsChange::takes_long(learner_->store(), wanted));
  const std::vector<char32_t> other{U'二'};
  ASSERT_TRUE(learner_->store().pause(other));
  EXPECT_TRUE(SettingsChange::takes_long(learner_->store(), wanted));
  EXPECT_FALSE(SettingsChange::takes_long(learner_->store(), learner_->store().settings()));
}

TEST_F(PracticeSettings, StoppedTheyAreAsTheyWere) {
  write(U'一');
  const auto before = learner_->store().settings();
  auto wanted = before;
  wanted.fsrs.weights.front() = 0.5;
  SettingsChange change(inbox_, *learner_);
  change.start(wanted);
  change.stop();
  const auto done = wait_for(change);
  ASSERT_TRUE(learner_->can_write());
  EXPECT_EQ(learner_->store().settings(), done ? wanted : before);
  if (!done) {
    EXPECT_EQ(done.error().code, base::Errc::cancelled);
  }
}

TEST_F(PracticeSettings, AreLeftWholeWhereTheChangeIsDestroyed) {
  write(U'一');
  auto wanted = learner_->store().settings();
  wanted.fsrs.weights.front() = 0.5;
  {
    SettingsChange change(inbox_, *learner_);
    change.start(wanted);
  }
  EXPECT_FALSE(learner_->can_write());
  EXPECT_TRUE(learner_->open_again());
  EXPECT_TRUE(learner_->store().cards().contains(U'一'));
}

}  // namespace
}  // namespace nazori::practice
