// SPDX-License-Identifier: Apache-2.0
// What a session counts: the time of a stage, the misses of a stroke, the characters that are done.
#include <array>

#include "session_under_test.h"

namespace nazori::practice {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;
using study::MissReply;
using study::Rating;
using study::Stage;
using Session = SessionTest;

TEST_F(Session, AStageCountsWholeUpToTenMinutesAndNoLonger) {
  ASSERT_TRUE(session_->start());
  clock_.advance(minutes(10) - milliseconds(1));
  session_->finish_stage(Stage::watch, {});
  const auto& store = learner_->store();
  EXPECT_EQ(*store.time_on(store.today()), minutes(10) - milliseconds(1));
  session_->go_on();
  clock_.advance(minutes(10) + milliseconds(1));
  session_->finish_stage(Stage::trace, {});
  EXPECT_EQ(*store.time_on(store.today()), minutes(20) - milliseconds(1));
}

TEST_F(Session, WritingFromMemoryEndsWithItsLastStrokeWhateverIsThoughtAfterwards) {
  ASSERT_TRUE(session_->start());
  practise();
  clock_.advance(seconds(8));
  session_->add_stroke();
  clock_.advance(seconds(30));
  session_->judge(grade(true), hand());
  EXPECT_EQ(session_->result().duration, seconds(8));
}

TEST_F(Session, GivingUpBeforeTheFirstStrokeCountsTheThinking) {
  ASSERT_TRUE(session_->start());
  practise();
  clock_.advance(seconds(30));
  session_->give_up({});
  EXPECT_EQ(session_->result().duration, seconds(30));
}

TEST_F(Session, AStrokeThatWasShownHasAllItsTriesAgain) {
  ASSERT_TRUE(session_->start());
  constexpr std::array kReplies{MissReply::try_again, MissReply::hint, MissReply::show};
  for (int round = 0; round < 2; ++round)
    for (const MissReply reply : kReplies) EXPECT_EQ(session_->add_mistake(0), reply) << "round " << round;
}

TEST_F(Session, ACharacterThatIsTakenBackIsStillToDo) {
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  learn();
  session_->rate(Rating::easy);
  const char32_t second = session_->character();
  ASSERT_EQ(session_->done(), 1);
  session_->finish_stage(Stage::watch, {});
  session_->undo();
  EXPECT_EQ(session_->character(), second);
  EXPECT_EQ(session_->done(), 1) << "the one before is done all the same";
  session_->undo();
  EXPECT_EQ(session_->character(), first);
  EXPECT_EQ(session_->done(), 0);
  EXPECT_EQ(session_->total(), 2);
}

TEST_F(Session, ACharacterOfAnEarlierSessionThatIsTakenBackWasNeverDoneInThisOne) {
  ASSERT_TRUE(session_->start());
  learn();
  session_->rate(Rating::easy);
  session_->end();
  ASSERT_TRUE(session_->start());
  session_->undo();
  EXPECT_EQ(session_->done(), 0);
  EXPECT_EQ(session_->total(), 2);
}

}  // namespace
}  // namespace nazori::practice
