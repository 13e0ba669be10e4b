// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/brush_session.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "learner_under_test.h"
#include "nazori/practice/character_history.h"
#include "nazori/practice/hard_characters.h"
#include "nazori/study/statistics.h"

namespace nazori::practice {
namespace {

using std::chrono::days;
using std::chrono::milliseconds;
using study::Rating;
using study::Stage;
using testing::ElementsAre;
using testing::IsEmpty;
using Kind = SessionFeedback::Kind;
using State = BrushSession::State;

class BrushSessionTest : public LearnerTest {
 protected:
  BrushSessionTest() {
    open_learner();
    session_ = std::make_unique<BrushSession>(*learner_, clock_);
    session_->announced.connect([this](const SessionFeedback& event) { events_.push_back(event); });
    session_->character_wanted.connect([this](char32_t one) { wanted_.push_back(one); });
    session_->ended.connect([this] { ++ended_; });
  }
  ~BrushSessionTest() override { session_.reset(); }

  /// These characters are well known, and three a day come with the brush.
  void know(const std::vector<char32_t>& characters) {
    auto settings = learner_->store().settings();
    settings.brush_per_day = 3;
    ASSERT_TRUE(learner_->store().change_settings(settings));
    for (const char32_t one : characters) {
      study::Writing writing;
      writing.rating = Rating::easy;
      ASSERT_TRUE(learner_->store().add_writing(one, 1, writing));
    }
    clock_.advance(days(9));
    for (const char32_t one : characters) {
      study::Writing writing;
      writing.rating = Rating::easy;
      ASSERT_TRUE(learner_->store().add_writing(one, 1, writing));
      ASSERT_EQ(study::strength_of(learner_->store().card(one)), study::Strength::mature);
    }
  }
  static writing::Grade grade(bool accepted) {
    writing::Grade made;
    made.accepted = accepted;
    made.score = accepted ? 80 : 20;
    return made;
  }
  static study::Handwriting ink() { return {{{{10, 20}, 0.0, 0.5, {}}, {{50, 20}, 0.4, 0.5, {}}}}; }
  study::Card card(char32_t one) { return learner_->store().card(one); }
  /// The last writing with the brush.
  study::LogEntry last_writing(char32_t one) {
    const auto all = learner_->store().writings_of(one);
    EXPECT_TRUE(all && !all->empty());
    return all->back().entry;
  }

  std::unique_ptr<BrushSession> session_;
  std::vector<SessionFeedback> events_;
  std::vector<char32_t> wanted_;
  int ended_ = 0;
};

TEST_F(BrushSessionTest, BeginsOnlyWhereSomethingIsDueWithTheBrush) {
  EXPECT_FALSE(session_->start());
  ASSERT_EQ(events_.size(), 1U);
  EXPECT_EQ(events_[0].kind, Kind::nothing_due);
  EXPECT_EQ(events_[0].stage, Stage::brush);
  EXPECT_EQ(session_->character(), 0U);
  know({U'一'});
  EXPECT_TRUE(session_->start());
  EXPECT_EQ(session_->state(), State::writing);
  EXPECT_EQ(session_->character(), U'一');
  EXPECT_THAT(wanted_, ElementsAre(U'一'));
  EXPECT_EQ(session_->total(), 1);
}

TEST_F(BrushSessionTest, ARatingAfterTheAdviceIsSavedApartFromMemoryAndTheNextCharacterComes) {
  know({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  const study::Card before = card(first);
  session_->rate(Rating::good);
  EXPECT_EQ(card(first), before) << "nothing was compared yet";
  clock_.advance(milliseconds(30'000));
  session_->add_stroke();
  clock_.advance(milliseconds(5'000));
  session_->judge(grade(true), ink());
  EXPECT_EQ(session_->state(), State::advised);
  EXPECT_EQ(session_->proposed(), Rating::good);
  const auto foretold = session_->after(Rating::hard);
  ASSERT_TRUE(foretold);
  session_->rate(Rating::hard);
  study::Card after = card(first);
  EXPECT_EQ(after.brush, foretold->brush);
  EXPECT_EQ(after.brush.memory.reps, 1);
  after.brush = before.brush;
  EXPECT_EQ(after, before);
  const auto entry = last_writing(first);
  EXPECT_EQ(entry.writing.stage, Stage::brush);
  EXPECT_EQ(entry.writing.rating, Rating::hard);
  EXPECT_EQ(entry.writing.proposed, Rating::good);
  EXPECT_EQ(entry.writing.result.score, 80);
  EXPECT_EQ(entry.writing.result.help, 0);
  EXPECT_EQ(entry.writing.result.duration, milliseconds(30'000)) << "to the last stroke";
  const auto saved = learner_->store().ink_of(entry.id);
  ASSERT_TRUE(saved);
  ASSERT_EQ(saved->size(), 1U);
  EXPECT_EQ(saved->front().back().at, (geometry::GlyphPoint{50, 20}));
  ASSERT_FALSE(events_.empty());
  EXPECT_EQ(events_.back().kind, Kind::rated);
  EXPECT_EQ(events_.back().stage, Stage::brush);
  EXPECT_EQ(events_.back().rating, Rating::hard);
  EXPECT_THAT(events_.back().characters, ElementsAre(first));
  EXPECT_EQ(events_.back().card, card(first));
  EXPECT_EQ(events_.back().today, learner_->store().today());
  EXPECT_EQ(session_->state(), State::writing);
  EXPECT_NE(session_->character(), first);
  EXPECT_EQ(session_->done(), 1);
  EXPECT_EQ(session_->total(), 2);
}

TEST_F(BrushSessionTest, EndsWhenEverythingIsRated) {
  know({U'一'});
  ASSERT_TRUE(session_->start());
  session_->judge(grade(true), ink());
  session_->rate(Rating::good);
  EXPECT_FALSE(session_->is_running());
  EXPECT_EQ(ended_, 1);
  EXPECT_EQ(events_.back().kind, Kind::all_done);
  session_->end();
  EXPECT_EQ(ended_, 1);
}

TEST_F(BrushSessionTest, WhatIsNotTheCharacterIsSuggestedAsAgain) {
  know({U'一'});
  ASSERT_TRUE(session_->start());
  session_->judge(grade(false), ink());
  EXPECT_EQ(session_->proposed(), Rating::again);
  session_->reopen();
  EXPECT_EQ(session_->state(), State::writing);
  session_->judge(std::nullopt, ink());
  EXPECT_EQ(session_->proposed(), Rating::again);
  EXPECT_EQ(session_->result().score, 0);
  session_->reopen();
  session_->judge(grade(true), ink());
  EXPECT_EQ(session_->proposed(), Rating::good);
}

TEST_F(BrushSessionTest, TheMostHelpOfTheModelIsSavedAndHidesNoSecretAnyMore) {
  know({U'一', U'二', U'三'});
  ASSERT_TRUE(session_->start());
  char32_t now = session_->character();
  EXPECT_TRUE(session_->asks_from_memory());
  session_->show_model(BrushModel::beneath);
  EXPECT_FALSE(session_->asks_from_memory());
  session_->show_model(BrushModel::none);
  EXPECT_FALSE(session_->asks_from_memory()) << "it was seen";
  session_->judge(grade(true), ink());
  session_->rate(Rating::good);
  EXPECT_EQ(last_writing(now).writing.result.help, 1);
  now = session_->character();
  EXPECT_TRUE(session_->asks_from_memory()) << "another character, without a model";
  session_->show_model(BrushModel::beside);
  session_->judge(grade(true), ink());
  EXPECT_FALSE(session_->asks_from_memory());
  session_->rate(Rating::good);
  EXPECT_EQ(last_writing(now).writing.result.help, 0.5);
  now = session_->character();
  EXPECT_FALSE(session_->asks_from_memory()) << "the model still stands beside the paper";
  session_->show_model(BrushModel::none);
  session_->judge(grade(true), ink());
  session_->rate(Rating::good);
  EXPECT_EQ(last_writing(now).writing.result.help, 0.5);
}

TEST_F(BrushSessionTest, WritingOnAfterTheAdviceHasSeenTheModel) {
  know({U'一'});
  ASSERT_TRUE(session_->start());
  session_->judge(grade(true), ink());
  session_->reopen();
  EXPECT_FALSE(session_->asks_from_memory());
  session_->judge(grade(true), ink());
  EXPECT_EQ(session_->result().help, 0.5);
}

TEST_F(BrushSessionTest, UndoBringsTheCharacterBack) {
  know({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  const study::Card before = card(first);
  session_->judge(grade(true), ink());
  session_->rate(Rating::good);
  session_->undo();
  EXPECT_EQ(card(first), before);
  EXPECT_EQ(session_->character(), first);
  EXPECT_EQ(session_->state(), State::writing);
  EXPECT_EQ(session_->done(), 0);
  EXPECT_EQ(session_->total(), 2);
  EXPECT_EQ(events_.back().kind, Kind::undone);
  EXPECT_THAT(events_.back().characters, ElementsAre(first));
}

TEST_F(BrushSessionTest, UndoAlsoWorksAfterTheEnd) {
  know({U'一'});
  ASSERT_TRUE(session_->start());
  session_->judge(grade(true), ink());
  session_->rate(Rating::good);
  ASSERT_FALSE(session_->is_running());
  session_->undo();
  EXPECT_EQ(card(U'一').brush, study::BrushReviews());
  EXPECT_FALSE(session_->is_running());
  EXPECT_TRUE(session_->start()) << "it is due again";
}

TEST_F(BrushSessionTest, APlanThatCannotBeReadEndsItAndBeginsNone) {
  know({U'一', U'二', U'三'});
  ASSERT_TRUE(learner_->store().save_list({"few", {U'一'}}));
  auto settings = learner_->store().settings();
  settings.new_lists = {"list:few"};
  ASSERT_TRUE(learner_->store().change_settings(settings));
  SQLite::Database other(learner_->file().string(), SQLite::OPEN_READWRITE, 1'000);
  const auto lose_and_find = [&](const std::function<void()>& action, Kind kind) {
    other.exec("ALTER TABLE list RENAME TO gone");
    learner_->renew_order();
    action();
    EXPECT_EQ(events_.back().kind, kind);
    EXPECT_EQ(events_.back().stage, Stage::brush);
    EXPECT_FALSE(events_.back().error.what.empty());
    EXPECT_FALSE(session_->is_running());
    other.exec("ALTER TABLE gone RENAME TO list");
  };
  lose_and_find([&] { EXPECT_FALSE(session_->start()); }, Kind::no_plan);
  ASSERT_TRUE(session_->start());
  lose_and_find([&] { session_->skip(); }, Kind::plan_lost);
  EXPECT_EQ(ended_, 1);
  EXPECT_EQ(session_->total(), 0);
  ASSERT_TRUE(session_->start());
  session_->judge(grade(true), ink());
  session_->rate(Rating::good);
  lose_and_find([&] { session_->undo(); }, Kind::plan_lost);
  EXPECT_EQ(ended_, 2);
}

TEST_F(BrushSessionTest, ASkippedCharacterStaysDueButDoesNotComeAgainInThisSession) {
  know({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  const char32_t first = session_->character();
  session_->skip();
  EXPECT_NE(session_->character(), first);
  EXPECT_EQ(session_->total(), 1);
  session_->judge(grade(true), ink());
  session_->rate(Rating::good);
  EXPECT_FALSE(session_->is_running());
  EXPECT_EQ(card(first).brush, study::BrushReviews());
  ASSERT_TRUE(session_->start());
  EXPECT_EQ(session_->character(), first);
}

TEST_F(BrushSessionTest, MistakesOfTheBrushAreNotAmongThoseOfTheStylus) {
  know({U'一'});
  writing::Grade wrong = grade(false);
  for (int i = 0; i < 3; ++i) wrong.mistakes.emplace_back().kind = kanji::MistakeKind::missing;
  for (int day = 0; day < 2; ++day) {
    ASSERT_TRUE(session_->start());
    session_->judge(wrong, ink());
    session_->rate(Rating::again);
    clock_.advance(days(1));
  }
  EXPECT_EQ(last_writing(U'一').writing.result.mistakes.size(), 3U);
  EXPECT_EQ(last_writing(U'一').writing.proposed, Rating::again);
  EXPECT_THAT(hard_strokes(*learner_, U'一', 3), IsEmpty());
  const auto trouble = stroke_trouble(learner_->store(), U'一', study::kFirstDay);
  ASSERT_TRUE(trouble);
  EXPECT_FALSE(*trouble);
}

TEST_F(BrushSessionTest, TooLongATimeIsNotCounted) {
  know({U'一'});
  ASSERT_TRUE(session_->start());
  clock_.advance(std::chrono::hours(2));
  session_->judge(grade(true), ink());
  EXPECT_EQ(session_->result().duration, std::chrono::minutes(10));
}

TEST_F(BrushSessionTest, AnotherLearnerEndsIt) {
  know({U'一'});
  ASSERT_TRUE(session_->start());
  ASSERT_TRUE(learner_->switch_profile("aiko"));
  EXPECT_FALSE(session_->is_running());
  EXPECT_EQ(ended_, 1);
}

}  // namespace
}  // namespace nazori::practice
