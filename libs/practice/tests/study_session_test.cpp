// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <iterator>

#include "nazori/practice/session_steps.h"
#include "session_under_test.h"

namespace nazori::practice {
namespace {

using study::Rating;
using study::Stage;
using State = StudySession::State;

using Session = SessionTest;

TEST_F(Session, ANewCharacterGoesFromWatchingToMemoryAndIsKept) {
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  EXPECT_EQ(session_->total(), 2);
  learn();
  EXPECT_EQ(session_->proposed(), Rating::good);
  session_->go_on();
  EXPECT_NE(session_->character(), first);
  EXPECT_EQ(session_->done(), 1);
  const auto card = learner_->store().card(first);
  EXPECT_EQ(card.memory.reps, 1);
  EXPECT_EQ(card.practices, 3);
  EXPECT_EQ(card.memory.phase, study::Phase::learning);
}

TEST_F(Session, WhatFailsIsPractisedAtOnceWithHelpAndComesAgain) {
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  learn();
  session_->rate(Rating::good);
  clock_.advance(std::chrono::minutes(11));
  session_->end();
  ASSERT_TRUE(session_->start());
  ASSERT_EQ(session_->character(), first);
  EXPECT_EQ(session_->task().kind, study::TaskKind::step);
  EXPECT_EQ(session_->stage(), Stage::memory);
  write(false);
  EXPECT_EQ(session_->proposed(), Rating::again);
  session_->rate(Rating::again);
  EXPECT_EQ(session_->character(), first) << "practised before anything else comes";
  EXPECT_EQ(session_->stage(), Stage::guided);
  EXPECT_GT(session_->help(), 0.5);
  session_->finish_stage(Stage::guided, {});
  EXPECT_TRUE(session_->is_over());
  session_->go_on();
  EXPECT_NE(session_->character(), first);
}

TEST_F(Session, TheLearnersRatingCountsAndBothAreInTheLog) {
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  learn();
  session_->rate(Rating::easy);
  const auto writings = learner_->store().writings_of(first);
  ASSERT_TRUE(writings);
  const auto& last = writings->back().entry.writing;
  EXPECT_EQ(last.rating, Rating::easy);
  EXPECT_EQ(last.proposed, Rating::good);
  EXPECT_TRUE(writings->back().has_ink);
  EXPECT_EQ(learner_->store().card(first).memory.phase, study::Phase::review);
}

TEST_F(Session, UndoGoesBackToTheCharacterAlsoAfterARestart) {
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  learn();
  session_->rate(Rating::easy);
  ASSERT_NE(session_->character(), first);
  open();
  EXPECT_EQ(learner_->store().card(first).memory.reps, 1) << "what was rated is there after a restart";
  ASSERT_TRUE(session_->start());
  session_->undo();
  EXPECT_EQ(session_->character(), first);
  EXPECT_EQ(session_->stage(), Stage::memory);
  EXPECT_EQ(learner_->store().card(first).memory.reps, 0);
  session_->undo();
  EXPECT_EQ(session_->stage(), Stage::guided) << "any number, one after another";
}

TEST_F(Session, WhatIsJudgedButNotRatedIsNotKept) {
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  learn();
  session_->end();
  EXPECT_EQ(learner_->store().card(first).memory.reps, 0);
  EXPECT_EQ(learner_->store().card(first).next_stage, Stage::memory);
}

TEST_F(Session, LookingBeforeWritingFromMemoryCostsLookingAfterwardsDoesNot) {
  ASSERT_TRUE(session_->start());
  learn();
  session_->rate(Rating::good);
  clock_.advance(std::chrono::minutes(11));
  session_->end();
  ASSERT_TRUE(session_->start());
  ASSERT_EQ(session_->task().kind, study::TaskKind::step);
  session_->enter_stage(Stage::watch);
  session_->enter_stage(Stage::memory);
  write(true);
  EXPECT_EQ(session_->proposed(), Rating::again) << "all strokes were shown";
  session_->undo();
  EXPECT_EQ(session_->state(), State::doing);
  session_->enter_stage(Stage::memory);
  write(true);
  EXPECT_EQ(session_->proposed(), Rating::good);
  session_->enter_stage(Stage::watch);
  EXPECT_EQ(session_->state(), State::judged);
  session_->enter_stage(Stage::memory);
  write(false);
  EXPECT_EQ(session_->proposed(), Rating::good) << "what was judged first stays";
}

TEST_F(Session, AStageThatIsNoPartOfTheLessonCountsAsLooking) {
  ASSERT_TRUE(session_->start());
  learn();
  session_->rate(Rating::good);
  clock_.advance(std::chrono::minutes(11));
  session_->end();
  ASSERT_TRUE(session_->start());
  session_->leave_lesson();
  EXPECT_EQ(session_->stage(), Stage::memory) << "it is still what is asked for";
  session_->enter_stage(Stage::memory);
  write(true);
  EXPECT_EQ(session_->proposed(), Rating::again);
}

TEST_F(Session, AfterTheSetMissesAStrokeIsShownAndThatCosts) {
  ASSERT_TRUE(session_->start());
  EXPECT_EQ(session_->add_mistake(0), study::MissReply::try_again);
  EXPECT_EQ(session_->add_mistake(0), study::MissReply::hint);
  EXPECT_EQ(session_->add_mistake(1), study::MissReply::try_again) << "another stroke counts anew";
  EXPECT_EQ(session_->add_mistake(1), study::MissReply::hint);
  EXPECT_EQ(session_->add_mistake(1), study::MissReply::show);
}

TEST_F(Session, ACorrectionAfterTheJudgementIsAMiss) {
  ASSERT_TRUE(session_->start());
  learn();
  session_->rate(Rating::good);
  session_->end();
  clock_.advance(std::chrono::minutes(11));
  ASSERT_TRUE(session_->start());
  write(false);
  EXPECT_EQ(session_->proposed(), Rating::again);
  session_->reopen();
  EXPECT_EQ(session_->state(), State::doing);
  write(true);
  EXPECT_EQ(session_->proposed(), Rating::hard);
}

TEST_F(Session, PostponedPausedAndResetCharactersGiveWayToTheNext) {
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  session_->postpone();
  EXPECT_NE(session_->character(), first);
  EXPECT_EQ(learner_->store().card(first).postponed_until, learner_->store().today() + std::chrono::days(1));
  const char32_t second = session_->character();
  session_->pause();
  EXPECT_TRUE(learner_->store().card(second).paused);
  EXPECT_NE(session_->character(), second);
  session_->undo();
  EXPECT_EQ(session_->character(), second);
}

TEST_F(Session, EndsWithWhatWasDoneWhenNothingIsLeft) {
  auto settings = learner_->store().settings();
  settings.new_per_day = 1;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  ASSERT_TRUE(session_->start());
  int ended = 0;
  session_->ended.connect([&ended] { ++ended; });
  learn();
  session_->rate(Rating::easy);
  EXPECT_EQ(ended, 1);
  EXPECT_FALSE(session_->is_running());
  const auto days = learner_->store().study_days();
  ASSERT_EQ(days->size(), 1U);
  EXPECT_EQ(days->front().reviews, 1);
  EXPECT_EQ(days->front().writings, 4) << "three stages before the one from memory";
  EXPECT_FALSE(session_->start());
  EXPECT_EQ(events_.back().kind, SessionFeedback::Kind::nothing_due);
}

TEST_F(Session, OfALeechEndsWithoutAReview) {
  auto settings = learner_->store().settings();
  settings.new_per_day = 1;
  settings.leech_lapses = 2;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  learn();
  session_->rate(Rating::easy);
  while (!learner_->store().card(first).leech) {
    clock_.advance(std::chrono::days(40));
    study::Writing again;
    again.stage = Stage::memory;
    again.rating = Rating::again;
    again.result.accepted = false;
    ASSERT_TRUE(learner_->store().add_writing(first, 1, again));
    clock_.advance(std::chrono::minutes(15));
    again.rating = Rating::good;
    again.result.accepted = true;
    ASSERT_TRUE(learner_->store().add_writing(first, 1, again));
  }
  const int reps = learner_->store().card(first).memory.reps;
  ASSERT_TRUE(session_->start(true));
  EXPECT_EQ(session_->character(), first);
  EXPECT_TRUE(session_->is_leech_lesson());
  EXPECT_EQ(folded_panels(*session_), (FoldedPanels{true, false})) << "its parts stand beside the tablet";
  for (const Stage stage : {Stage::watch, Stage::trace, Stage::guided}) {
    EXPECT_FALSE(session_->is_over());
    session_->finish_stage(stage, {});
    EXPECT_EQ(session_->is_over(), stage == Stage::guided);
    session_->go_on();
  }
  EXPECT_FALSE(session_->is_running());
  EXPECT_FALSE(learner_->store().card(first).leech);
  EXPECT_EQ(learner_->store().card(first).memory.reps, reps);
}

TEST_F(Session, IsRefusedWhereAnotherWindowHoldsTheStore) {
  Learner second(inbox_, place());
  std::vector<LearnerEvent> announced;
  second.announced.connect([&announced](const LearnerEvent& event) { announced.push_back(event); });
  EXPECT_FALSE(second.switch_profile("learner"));
  EXPECT_FALSE(second.can_write());
  ASSERT_EQ(announced.size(), 1U);
  EXPECT_EQ(announced.front().kind, LearnerEvent::Kind::in_use);
  StudySession of_second(second, clock_);
  std::vector<SessionFeedback> refused;
  of_second.announced.connect([&refused](const SessionFeedback& event) { refused.push_back(event); });
  EXPECT_FALSE(of_second.start());
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused.front().kind, SessionFeedback::Kind::not_writable);
  EXPECT_EQ(refused.front().trouble, second.trouble());
  session_.reset();
  learner_.reset();
  EXPECT_TRUE(second.open_again());
  EXPECT_TRUE(of_second.start());
}

TEST_F(Session, ADamagedStoreIsLeftByteForByte) {
  const auto path = learner_->file();
  session_.reset();
  learner_.reset();
  const std::string damaged(5000, 'x');
  std::ofstream(path, std::ios::binary) << damaged;
  Learner learner(inbox_, place());
  EXPECT_FALSE(learner.switch_profile("learner"));
  ASSERT_TRUE(learner.trouble());
  EXPECT_EQ(learner.trouble()->kind, LearnerEvent::Kind::damaged);
  StudySession session(learner, clock_);
  EXPECT_FALSE(session.start());
  std::ifstream in(path, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), damaged);
}

TEST_F(Session, AnotherProfileIsAnotherLearnerAndABadNameChangesNothing) {
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  learn();
  session_->rate(Rating::good);
  EXPECT_TRUE(learner_->switch_profile("花子"));
  EXPECT_FALSE(session_->is_running());
  EXPECT_FALSE(learner_->store().cards().contains(first));
  EXPECT_FALSE(learner_->switch_profile("../x"));
  EXPECT_EQ(learner_->profile(), "花子");
  EXPECT_TRUE(learner_->can_write());
  EXPECT_TRUE(learner_->switch_profile("learner"));
  EXPECT_TRUE(learner_->store().cards().contains(first));
}

}  // namespace
}  // namespace nazori::practice
