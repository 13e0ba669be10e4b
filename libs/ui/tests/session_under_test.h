// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <memory>
#include <vector>

#include "nazori/practice/study_session.h"
#include "nazori/widgets/events/event_loop_inbox.h"
#include "nazori/widgets/words/learner_words.h"
#include "nazori/widgets/words/session_words.h"
#include "print_qt.h"

namespace nazori::ui {

/// A session without a window, of a learner whose days and minutes the test moves.
class SessionTest : public testing::Test {
 protected:
  SessionTest() { open(); }

  static std::filesystem::path kanji_db() {
    return std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db";
  }

  void open() {
    session_.reset();
    learner_.reset();
    learner_ = std::make_unique<practice::Learner>(
        inbox_.inbox(),
        practice::Learner::Place{folder_.path().toStdString(), kanji_db(), [this] { return now_; }});
    learner_->announced.connect(
        [this](const practice::LearnerEvent& event) { said_.append(LearnerWords::sentence(event)); });
    learner_->switch_profile("learner");
    session_ = std::make_unique<practice::StudySession>(*learner_, clock_);
    session_->announced.connect([this](const practice::SessionFeedback& feedback) {
      if (const QString s = SessionWords::sentence(feedback); !s.isEmpty()) said_.append(s);
    });
    session_->set_asks_by_words(false);
    session_->character_wanted.connect([this](char32_t c) { bring(c); });
    if (learner_->can_write() && learner_->store().settings().time_zone != "UTC") {
      auto settings = learner_->store().settings();
      settings.time_zone = "UTC";
      settings.new_per_day = 2;
      ASSERT_TRUE(learner_->store().change_settings(settings));
    }
  }

  /// The character is shown.
  void bring(char32_t character) {
    auto sheet = std::make_shared<practice::CharacterSheet>();
    sheet->character = *kanji::KanjiDatabase::open(kanji_db())->find(character);
    session_->set_sheet(sheet);
  }

  static std::vector<practice::HandStroke> hand() {
    practice::HandStroke stroke;
    for (int i = 0; i < 20; ++i) stroke.push_back({{i * 0.002 - 0.02, 0}, i * 0.01, 0.5});
    return {stroke};
  }
  static writing::Grade grade(bool accepted) {
    writing::Grade made;
    made.accepted = accepted;
    made.score = accepted ? 85 : 30;
    if (!accepted) {
      writing::Mistake missing;
      missing.kind = kanji::MistakeKind::missing;
      made.mistakes.push_back(missing);
    }
    return made;
  }
  void write(bool accepted) {
    session_->add_stroke();
    session_->judge(grade(accepted), hand());
  }
  /// A new character up to the question from memory, all of it well.
  void practise() {
    using study::Stage;
    for (const Stage stage : {Stage::watch, Stage::trace, Stage::guided}) {
      ASSERT_EQ(session_->stage(), stage);
      session_->finish_stage(stage, {});
      session_->go_on();
    }
    ASSERT_EQ(session_->stage(), Stage::memory);
  }
  /// A new character from watching to memory, all of it well.
  void learn() {
    practise();
    write(true);
    ASSERT_EQ(session_->state(), practice::StudySession::State::judged);
  }

  /// The announcement while another file replaces the learner's.
  static QString replaced() {
    return QStringLiteral(
        "The study data of learner is being replaced. Nothing is saved until this is done.");
  }

  QTemporaryDir folder_;
  EventLoopInbox inbox_;
  study::Time now_ = *study::parse_time("2026-03-02T10:00Z");
  base::ManualClock clock_{base::Clock::Calendar{}};  ///< how long stages take
  QStringList said_;
  std::unique_ptr<practice::Learner> learner_;
  std::unique_ptr<practice::StudySession> session_;
};

}  // namespace nazori::ui
