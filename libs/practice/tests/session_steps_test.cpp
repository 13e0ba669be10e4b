// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/session_steps.h"

#include <gtest/gtest.h>

#include "session_under_test.h"

namespace nazori::practice {
namespace {

class Steps : public SessionTest {};

TEST_F(Steps, ThereIsOneNextStepAtEachPointOfALesson) {
  EXPECT_EQ(next_step(*session_, false), NextStep::none) << "no session";
  learn_from({U'人'});
  ASSERT_TRUE(session_->start());
  EXPECT_EQ(next_step(*session_, false), NextStep::none) << "it is being watched";
  session_->finish_stage(study::Stage::watch, {});
  EXPECT_EQ(next_step(*session_, false), NextStep::stage);
  session_->go_on();
  EXPECT_EQ(next_step(*session_, false), NextStep::none);
  session_->finish_stage(study::Stage::trace, {});
  session_->go_on();
  session_->finish_stage(study::Stage::guided, {});
  session_->go_on();
  ASSERT_TRUE(session_->asks_from_memory());
  EXPECT_EQ(next_step(*session_, false), NextStep::finish_writing);
  write(true);
  EXPECT_EQ(next_step(*session_, false), NextStep::rate);
  EXPECT_EQ(next_step(*session_, true), NextStep::finish_writing) << "it goes on being written";
  session_->rate(study::Rating::easy);
  EXPECT_FALSE(session_->is_running());
}

TEST_F(Steps, AfterAFailureThePracticeLeadsToTheNextCharacter) {
  learn_from({U'人'});
  ASSERT_TRUE(session_->start());
  learn();
  session_->rate(study::Rating::easy);
  ASSERT_TRUE(session_->start_with({U'人'}));
  write(false);
  session_->rate(study::Rating::again);
  ASSERT_EQ(session_->stage(), study::Stage::guided);
  session_->finish_stage(study::Stage::guided, {});
  EXPECT_EQ(next_step(*session_, false), NextStep::next_character);
}

TEST_F(Steps, AnotherCharacterOnTheTabletLeadsBack) {
  learn_from({U'人'});
  ASSERT_TRUE(session_->start());
  bring(U'雨');
  EXPECT_EQ(next_step(*session_, false), NextStep::go_back);
  EXPECT_EQ(next_step(*session_, true), NextStep::finish_writing) << "what was written is checked first";
  EXPECT_EQ(folded_panels(*session_), FoldedPanels{}) << "the learner looks something up";
}

TEST_F(Steps, ThePanelsAreFoldedWhileSomethingIsWrittenAndTheInformationComesBackWithTheVerdict) {
  EXPECT_EQ(folded_panels(*session_), FoldedPanels{});
  learn_from({U'人'});
  ASSERT_TRUE(session_->start());
  EXPECT_EQ(folded_panels(*session_), (FoldedPanels{true, true}));
  practise();
  EXPECT_EQ(folded_panels(*session_), (FoldedPanels{true, true})) << "it would show the answer";
  write(true);
  EXPECT_EQ(folded_panels(*session_), (FoldedPanels{true, false}));
  session_->end();
  EXPECT_EQ(folded_panels(*session_), FoldedPanels{});
}

TEST_F(Steps, TheProgressCountsCharactersAndWholeMinutes) {
  EXPECT_EQ(progress_of(*session_), SessionProgress{});
  ASSERT_TRUE(session_->start_with({U'一', U'二', U'三'}));
  EXPECT_EQ(progress_of(*session_), (SessionProgress{1, 0, 3, 3})) << "a minute each";
  session_->postpone();
  EXPECT_EQ(progress_of(*session_), (SessionProgress{1, 0, 2, 2}));
  learn();
  session_->rate(study::Rating::easy);
  EXPECT_EQ(progress_of(*session_), (SessionProgress{2, 1, 2, 1}));
}

}  // namespace
}  // namespace nazori::practice
