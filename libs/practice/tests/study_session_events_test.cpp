// SPDX-License-Identifier: Apache-2.0
// What a session announces at each step, and what it saves and adds up.
#include <SQLiteCpp/SQLiteCpp.h>

#include <span>

#include "session_under_test.h"

namespace nazori::practice {
namespace {

using study::Rating;
using study::Stage;
using State = StudySession::State;

using Kind = SessionFeedback::Kind;

class SessionEvents : public SessionTest {
 protected:
  SessionEvents() { learn_from({U'一', U'二', U'三'}); }

  [[nodiscard]] Kind last() const { return events_.back().kind; }
  /// What was saved or undone last, of 一.
  void expect_event(Kind kind) const {
    ASSERT_TRUE(session_->last_event());
    EXPECT_EQ(session_->last_event()->kind, kind);
    EXPECT_EQ(session_->last_event()->characters, std::vector<char32_t>{U'一'});
  }
  /// The same, undone.
  void expect_undone(study::EntryKind entry) const {
    expect_event(Kind::undone);
    EXPECT_EQ(session_->last_event()->entry, entry);
  }
};

TEST_F(SessionEvents, WhatIsRatedIsAnnouncedWithWhenItComesAgain) {
  ASSERT_TRUE(session_->start());
  EXPECT_FALSE(session_->last_event());
  learn();
  session_->rate(Rating::easy);
  expect_event(Kind::rated);
  const SessionFeedback rated = *session_->last_event();
  EXPECT_EQ(rated.rating, Rating::easy);
  EXPECT_EQ(rated.card, learner_->store().card(U'一'));
  EXPECT_EQ(rated.card.due_day, rated.today + std::chrono::days(8));
  EXPECT_EQ(rated.now, clock_.calendar());
  EXPECT_EQ(last(), Kind::rated);
  session_->end();
  EXPECT_EQ(last(), Kind::ended);
  const auto count = events_.size();
  session_->end();
  EXPECT_EQ(events_.size(), count) << "it has ended already";
  EXPECT_EQ(session_->character(), 0U);
  ASSERT_TRUE(session_->start());
  EXPECT_FALSE(session_->last_event()) << "a new session";
}

TEST_F(SessionEvents, WhatIsPutAsideIsAnnouncedAndCanBeUndone) {
  ASSERT_TRUE(session_->start());
  session_->postpone();
  expect_event(Kind::postponed);
  session_->undo();
  expect_undone(study::EntryKind::postpone);
  session_->pause();
  expect_event(Kind::paused);
  session_->undo();
  expect_undone(study::EntryKind::pause);
  session_->reset();
  expect_event(Kind::reset);
  session_->undo();
  expect_undone(study::EntryKind::reset);
  session_->finish_stage(Stage::watch, {});
  session_->undo();
  expect_undone(study::EntryKind::writing);
  const std::vector<char32_t> both{U'一', U'二'};
  ASSERT_TRUE(learner_->store().pause(both));
  ASSERT_TRUE(learner_->store().resume(both));
  session_->undo();
  EXPECT_EQ(session_->last_event()->entry, study::EntryKind::resume);
  EXPECT_EQ(session_->last_event()->characters, both);
  session_->undo();
  session_->undo();
  EXPECT_EQ(last(), Kind::nothing_to_undo);
  EXPECT_EQ(session_->last_event()->kind, Kind::undone) << "nothing was done";
}

TEST_F(SessionEvents, WhatIsForgottenOftenIsSetApart) {
  auto settings = learner_->store().settings();
  settings.leech_lapses = 2;
  settings.new_per_day = 0;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  study::Writing writing;
  writing.rating = Rating::easy;
  ASSERT_TRUE(learner_->store().add_writing(U'一', 1, writing));
  for (int lapse = 0; lapse < 2; ++lapse) {
    clock_.advance(std::chrono::days(60));
    session_->end();
    ASSERT_TRUE(session_->start());
    bring(U'一');
    ASSERT_EQ(session_->stage(), Stage::memory);
    write(false);
    session_->rate(Rating::again);
    if (lapse == 0) {
      session_->end();
      clock_.advance(std::chrono::minutes(30));
      writing.rating = Rating::good;
      ASSERT_TRUE(learner_->store().add_writing(U'一', 1, writing));
    }
  }
  expect_event(Kind::set_apart);
  ASSERT_TRUE(session_->start(true));
  EXPECT_EQ(session_->total(), 1);
  EXPECT_EQ(session_->time_left(), std::chrono::minutes(2));
  for (int stage = 0; stage < 3; ++stage) {
    bring(U'一');
    session_->finish_stage(session_->stage(), {});
    session_->go_on();
  }
  EXPECT_FALSE(session_->is_running());
  EXPECT_EQ(last(), Kind::all_done);
}

TEST_F(SessionEvents, WhatHappensAwayFromTheCharacterCountsForNothing) {
  ASSERT_TRUE(session_->start());
  int wanted = 0;
  session_->character_wanted.connect([&wanted](char32_t) { ++wanted; });
  bring(U'雨');
  EXPECT_TRUE(session_->is_away());
  session_->finish_stage(Stage::watch, {});
  EXPECT_EQ(session_->state(), State::doing);
  EXPECT_EQ(learner_->store().card(U'一').practices, 0);
  session_->enter_stage(Stage::trace);
  EXPECT_EQ(session_->stage(), Stage::watch);
  session_->go_on();
  EXPECT_EQ(wanted, 1);
  EXPECT_FALSE(session_->is_away());
  session_->finish_stage(Stage::trace, {});
  EXPECT_EQ(session_->state(), State::doing) << "another stage is at hand";
  session_->go_on();
  EXPECT_EQ(session_->stage(), Stage::watch) << "nothing is done yet";
  session_->enter_stage(Stage::trace);
  EXPECT_EQ(session_->stage(), Stage::trace) << "the learner may do any stage";
}

TEST_F(SessionEvents, AFinishedStageIsAnnouncedWhenTheNextOneIsOffered) {
  ASSERT_TRUE(session_->start());
  std::vector<State> seen;
  session_->changed.connect([&] { seen.push_back(session_->state()); });
  session_->finish_stage(Stage::watch, {});
  ASSERT_FALSE(seen.empty());
  EXPECT_EQ(seen.back(), State::offered);
  EXPECT_EQ(session_->stage(), Stage::trace);
}

TEST_F(SessionEvents, HelpAndMissesOfAStageAreKeptWithIt) {
  ASSERT_TRUE(session_->start());
  session_->add_hint();
  (void)session_->add_mistake(0);
  (void)session_->add_mistake(1);
  study::WritingResult result;
  result.misses = 1;
  result.shown_strokes = 2;
  session_->finish_stage(Stage::watch, result);
  const auto kept = learner_->store().writings_of(U'一');
  ASSERT_TRUE(kept);
  const auto& last = kept->back().entry.writing.result;
  EXPECT_EQ(last.hints, 1);
  EXPECT_EQ(last.misses, 2) << "the greater of both";
  EXPECT_EQ(last.shown_strokes, 2);
  EXPECT_EQ(kept->back().entry.strokes, 1);
  session_->go_on();
  session_->finish_stage(Stage::trace, {});
  EXPECT_EQ(learner_->store().writings_of(U'一')->back().entry.writing.result.hints, 0) << "another stage";
}

TEST_F(SessionEvents, WhoGivesUpHadEveryStrokeShown) {
  ASSERT_TRUE(session_->start());
  practise();
  session_->give_up(hand());
  EXPECT_FALSE(session_->result().accepted);
  EXPECT_EQ(session_->result().score, 0);
  EXPECT_EQ(session_->result().shown_strokes, 1);
  EXPECT_EQ(session_->proposed(), Rating::again);
  EXPECT_EQ(session_->ink().size(), 1U);
  session_->go_on();
  EXPECT_EQ(learner_->store().writings_of(U'一')->back().entry.writing.rating, Rating::again)
      << "going on takes the proposal";
}

TEST_F(SessionEvents, WithoutASessionNothingCanBePutAsideOrJudged) {
  session_->postpone();
  session_->pause();
  session_->reset();
  session_->rate(Rating::good);
  session_->go_on();
  session_->give_up({});
  session_->judge(grade(true), hand());
  session_->reopen();
  EXPECT_EQ(session_->state(), State::idle);
  EXPECT_EQ(learner_->store().card(U'一').postponed_until, std::nullopt);
  session_->undo();
  EXPECT_EQ(last(), Kind::nothing_to_undo);
  EXPECT_FALSE(session_->is_running());
  learner_->let_go(LearnerEvent::Kind::replacing);
  EXPECT_FALSE(session_->start());
  EXPECT_EQ(last(), Kind::not_writable);
  EXPECT_EQ(events_.back().trouble->kind, LearnerEvent::Kind::replacing);
  events_.clear();
  session_->undo();
  EXPECT_EQ(last(), Kind::not_writable);
}

TEST_F(SessionEvents, APlanThatCannotBeReadEndsTheSessionAndBeginsNone) {
  ASSERT_TRUE(session_->start());
  int ended = 0;
  session_->ended.connect([&ended] { ++ended; });
  SQLite::Database other(learner_->file().string(), SQLite::OPEN_READWRITE, 1'000);
  other.exec("ALTER TABLE list RENAME TO gone");
  learner_->renew_order();
  session_->postpone();
  EXPECT_EQ(last(), Kind::plan_lost) << "not that all is done";
  EXPECT_FALSE(events_.back().error.what.empty());
  EXPECT_EQ(ended, 1);
  EXPECT_FALSE(session_->is_running());
  EXPECT_EQ(session_->character(), 0U);
  EXPECT_FALSE(session_->start());
  EXPECT_EQ(last(), Kind::no_plan);
  EXPECT_FALSE(events_.back().error.what.empty());
  other.exec("ALTER TABLE gone RENAME TO list");
  EXPECT_TRUE(session_->start());
}

TEST_F(SessionEvents, NothingIsDueForALessonWhereNothingIsSetApart) {
  EXPECT_FALSE(session_->start(true));
  EXPECT_EQ(last(), Kind::nothing_due);
  ASSERT_TRUE(session_->start());
  EXPECT_FALSE(session_->is_leech_lesson());
  EXPECT_EQ(session_->time_left(), learner_->plan()->estimate);
}

}  // namespace
}  // namespace nazori::practice
