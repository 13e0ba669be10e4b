// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/placement_run.h"

#include <gtest/gtest.h>

#include "database_under_test.h"
#include "learner_under_test.h"
#include "nazori/practice/learning_choices.h"
#include "nazori/tablet/carved_tablet.h"
#include "stage_under_test.h"

namespace nazori::practice {
namespace {

class Placement : public LearnerTest {
 protected:
  Placement() {
    run_.ended.connect([this](const PlacementResult& result) { results_.push_back(result); });
    run_.stopped.connect([this] { ++stops_; });
    run_.answered_question.connect([this](PlacementAnswer answer) { answers_.push_back(answer); });
  }
  /// The strokes of the character that is asked for, as the model has them.
  void write(char32_t character) {
    const auto found = learner_->database()->find(character);
    const auto carved = tablet::CarvedTablet::from_lines(tablet::tablet_lines(found->lines()), 128);
    for (const auto& path : (*carved)->paths()) {
      std::vector<geometry::TabletPoint> points;
      for (const auto& p : path.points) points.push_back({p.x, p.y});
      hand_.write(points);
    }
    ASSERT_TRUE(run_.has_writing());
    const auto before = answers_.size();
    run_.finish_writing();
    inbox_.run_until([&] { return answers_.size() > before; });
  }

  TabletControl tablet_{inbox_, clock_, {}};
  WritingJudge judge_{inbox_, test::database()};
  TestHand hand_{tablet_};
  PlacementRun run_{*learner_, tablet_, judge_, clock_};
  std::vector<PlacementResult> results_;
  std::vector<PlacementAnswer> answers_;
  int stops_ = 0;
};

TEST_F(Placement, WritingIsJudgedAndTheNextCharacterIsAsked) {
  ASSERT_TRUE(run_.start({U'一', U'二', U'十', U'人'}));
  run_.enter();
  std::vector<char32_t> known{U'一', U'二'};
  while (run_.is_running()) {
    const auto meaning = run_.question()->meanings.front();
    EXPECT_EQ(run_.question()->shown, 0U) << "it is asked from memory";
    if (meaning == "one") {
      write(U'一');
    } else if (meaning == "two") {
      write(U'二');
      EXPECT_EQ(answers_.back(), PlacementAnswer::written) << "every stroke counts, however fast they follow";
    } else {
      run_.do_not_know();
    }
    EXPECT_FALSE(run_.has_writing()) << "the tablet is empty for the next";
  }
  ASSERT_EQ(results_.size(), 1U);
  EXPECT_EQ(results_[0].known, known);
  EXPECT_EQ(results_[0].characters, 4);
  EXPECT_EQ(results_[0].grade, 1);
  EXPECT_EQ(stops_, 0);
}

TEST_F(Placement, AnotherCharacterIsRefused) {
  ASSERT_TRUE(run_.start({U'一'}));
  run_.enter();
  write(U'木');
  EXPECT_EQ(answers_, std::vector{PlacementAnswer::refused});
  ASSERT_EQ(results_.size(), 1U);
  EXPECT_TRUE(results_[0].known.empty());
}

TEST_F(Placement, EndsWithoutAResultWhenItIsStopped) {
  ASSERT_TRUE(run_.start({U'一', U'二'}));
  run_.enter();
  run_.do_not_know();
  run_.stop();
  EXPECT_FALSE(run_.is_running());
  EXPECT_FALSE(run_.question());
  EXPECT_EQ(stops_, 1);
  EXPECT_TRUE(results_.empty());
  run_.stop();
  run_.do_not_know();
  EXPECT_EQ(stops_, 1) << "it was over";
  EXPECT_FALSE(run_.start({})) << "nothing to ask";
}

TEST_F(Placement, AnotherLearnerEndsIt) {
  ASSERT_TRUE(run_.start({U'一', U'二'}));
  learner_->switch_profile("other");
  EXPECT_FALSE(run_.is_running());
  EXPECT_EQ(stops_, 1);
}

TEST_F(Placement, TheTabletIsGivenBackAndTheQuestionStaysWhileItIsLeft) {
  ASSERT_TRUE(run_.start({U'一', U'二', U'三'}));
  run_.enter();
  const auto question = run_.question();
  run_.leave();
  hand_.write({{-0.03, 0}, {0.03, 0}});
  EXPECT_FALSE(run_.has_writing());
  run_.enter();
  EXPECT_EQ(run_.question(), question);
  hand_.write({{-0.03, 0}, {0.03, 0}});
  EXPECT_TRUE(run_.has_writing());
  run_.undo_stroke();
  EXPECT_FALSE(run_.has_writing());
  hand_.write({{-0.03, 0}, {0.03, 0}});
  run_.clear();
  EXPECT_FALSE(run_.has_writing());
  run_.finish_writing();
  EXPECT_TRUE(answers_.empty()) << "nothing is written";
}

TEST_F(Placement, AfterTwoMinutesTheEighthAnswerIsTheLast) {
  ASSERT_TRUE(run_.start(*characters_to_check(*learner_, {})));
  run_.enter();
  int questions = 0;
  while (run_.is_running()) {
    clock_.advance(std::chrono::seconds(31));
    run_.do_not_know();
    ++questions;
  }
  EXPECT_EQ(questions, 8);
  EXPECT_EQ(results_.size(), 1U);
}

}  // namespace
}  // namespace nazori::practice
