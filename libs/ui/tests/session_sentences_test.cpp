// SPDX-License-Identifier: Apache-2.0
// What a session announces at each step, and what it saves and sums up.
#include "session_under_test.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

using study::Rating;
using study::Stage;
using State = practice::StudySession::State;

class SessionSentences : public SessionTest {
 protected:
  void SetUp() override {
    install_language(QStringLiteral("en"));
    ASSERT_TRUE(learner_->store().save_list({"few", {U'一', U'二', U'三'}}));
    auto settings = learner_->store().settings();
    settings.new_lists = {"list:few"};
    settings.new_order = study::NewOrder::own;
    ASSERT_TRUE(learner_->store().change_settings(settings));
    learner_->renew_order();
  }
  std::string said() const { return said_.isEmpty() ? std::string() : said_.last().toStdString(); }
  std::string note() const { return SessionWords::sentence(session_->last_event()).toStdString(); }
};

TEST_F(SessionSentences, WhatIsRatedIsSaidWithWhenItComesAgain) {
  ASSERT_TRUE(session_->start());
  EXPECT_EQ(note(), "");
  learn();
  session_->rate(Rating::easy);
  EXPECT_EQ(note(), "Saved: 一, Easy. Next review in 8 days.");
  EXPECT_EQ(said(), note());
  session_->end();
  EXPECT_EQ(said(), "Session ended. Everything you rated is saved.");
  const auto count = said_.size();
  session_->end();
  EXPECT_EQ(said_.size(), count) << "it has ended already";
  EXPECT_EQ(session_->character(), 0U);
  ASSERT_TRUE(session_->start());
  EXPECT_EQ(note(), "") << "a new session";
}

TEST_F(SessionSentences, WhatIsPutAsideIsSaidWithHowToTakeItBack) {
  ASSERT_TRUE(session_->start());
  session_->postpone();
  EXPECT_EQ(note(), "Postponed 一 to tomorrow. Ctrl+Shift+Z: undo.");
  session_->undo();
  EXPECT_EQ(note(), "Undone: 一 is no longer postponed.");
  session_->pause();
  EXPECT_EQ(note(), "Suspended 一 until you resume it. Ctrl+Shift+Z: undo.");
  session_->undo();
  EXPECT_EQ(note(), "Undone: 一 is no longer suspended.");
  session_->reset();
  EXPECT_EQ(note(), "Started 一 over as a new character. Ctrl+Shift+Z: undo.");
  session_->undo();
  EXPECT_EQ(note(), "Undone: your progress with 一 is back.");
  session_->finish_stage(Stage::watch, {});
  session_->undo();
  EXPECT_EQ(note(), "Undone: the last entry for 一.");
  const std::vector<char32_t> both{U'一', U'二'};
  ASSERT_TRUE(learner_->store().pause(both));
  ASSERT_TRUE(learner_->store().resume(both));
  session_->undo();
  EXPECT_EQ(note(), "Undone: 一二 is suspended again.");
  session_->undo();
  session_->undo();
  EXPECT_EQ(said(), "Nothing to undo.");
}

TEST_F(SessionSentences, OfManyCharactersThatAreTakenBackTheFirstAreNamed) {
  const std::u32string all = U"一二三四五六七八九十百千日月火水木金土休人";
  ASSERT_EQ(all.size(), 21U);
  const auto undone = [&](std::size_t count) {
    EXPECT_TRUE(learner_->store().pause(std::span(all).first(count)));
    session_->undo();
    return said();
  };
  EXPECT_FALSE(undone(20).find("…") != std::string::npos);
  EXPECT_FALSE(undone(21).find("…") != std::string::npos);
  const std::u32string more = all + U'本';
  EXPECT_TRUE(learner_->store().pause(std::span(more)));
  session_->undo();
  EXPECT_NE(said().find("…"), std::string::npos) << said();
}

TEST_F(SessionSentences, WhatIsForgottenOftenIsSetApart) {
  auto settings = learner_->store().settings();
  settings.leech_lapses = 2;
  settings.new_per_day = 0;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  study::Writing writing;
  writing.rating = Rating::easy;
  ASSERT_TRUE(learner_->store().add_writing(U'一', 1, writing));
  for (int lapse = 0; lapse < 2; ++lapse) {
    now_ += std::chrono::days(60);
    session_->end();
    ASSERT_TRUE(session_->start());
    bring(U'一');
    ASSERT_EQ(session_->stage(), Stage::memory);
    write(false);
    session_->rate(Rating::again);
    if (lapse == 0) {
      session_->end();
      now_ += std::chrono::minutes(30);
      writing.rating = Rating::good;
      ASSERT_TRUE(learner_->store().add_writing(U'一', 1, writing));
    }
  }
  EXPECT_EQ(note(), "一 was forgotten too often and taken out of reviews. Relearn it from Home.");
  ASSERT_TRUE(session_->start(true));
  EXPECT_EQ(session_->total(), 1);
  EXPECT_EQ(session_->time_left(), std::chrono::minutes(2));
  for (int stage = 0; stage < 3; ++stage) {
    bring(U'一');
    session_->finish_stage(session_->stage(), {});
    session_->go_on();
  }
  EXPECT_FALSE(session_->is_running());
  EXPECT_EQ(said(), "All done for now. Everything is saved.");
}

TEST_F(SessionSentences, WithoutASessionNothingCanBePutAsideOrJudged) {
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
  EXPECT_EQ(said(), "Nothing to undo.");
  EXPECT_FALSE(session_->is_running());
  learner_->let_go(practice::LearnerEvent::Kind::replacing);
  EXPECT_FALSE(session_->start());
  EXPECT_EQ(said(), replaced().toStdString());
  said_.clear();
  session_->undo();
  EXPECT_EQ(said(), replaced().toStdString());
}

TEST_F(SessionSentences, NothingIsDueForALessonWhereNothingIsSetApart) {
  EXPECT_FALSE(session_->start(true));
  EXPECT_EQ(said(), "Nothing is due now.");
  ASSERT_TRUE(session_->start());
  EXPECT_FALSE(session_->is_leech_lesson());
  EXPECT_EQ(session_->time_left(), learner_->plan()->estimate);
}

}  // namespace
}  // namespace nazori::ui
