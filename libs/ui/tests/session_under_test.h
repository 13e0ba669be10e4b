// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <memory>
#include <vector>

#include "study/study_session.h"

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
    learner_ = std::make_unique<Learner>(
        Learner::Place{folder_.path().toStdString(), kanji_db(), [this] { return now_; }});
    QObject::connect(learner_.get(), &Learner::said, [this](Feedback, const QString& s) { said_.append(s); });
    learner_->switch_profile(QStringLiteral("learner"));
    session_ = std::make_unique<StudySession>(*learner_, [this] { return passed_; });
    QObject::connect(session_.get(), &StudySession::said,
                     [this](Feedback, const QString& s) { said_.append(s); });
    session_->set_asks_by_words(false);
    QObject::connect(session_.get(), &StudySession::character_wanted, [this](char32_t c) { bring(c); });
    if (learner_->can_write() && learner_->store().settings().time_zone != "UTC") {
      auto settings = learner_->store().settings();
      settings.time_zone = "UTC";
      settings.new_per_day = 2;
      ASSERT_TRUE(learner_->store().change_settings(settings));
    }
  }

  /// The character comes to the desk.
  void bring(char32_t character) {
    auto sheet = std::make_shared<practice::CharacterSheet>();
    sheet->character = *kanji::KanjiDatabase::open(kanji_db())->find(character);
    session_->take_sheet(sheet);
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
      writing::Fault missing;
      missing.kind = writing::FaultKind::missing;
      made.faults.push_back(missing);
    }
    return made;
  }
  void write(bool accepted) {
    session_->note_stroke();
    session_->take_judgement(grade(accepted), hand());
  }
  /// A new character up to the question from memory, all of it well.
  void practise() {
    using study::Stage;
    for (const Stage stage : {Stage::watch, Stage::trace, Stage::guided}) {
      ASSERT_EQ(session_->stage(), stage);
      session_->take_practice(stage, {});
      session_->go_on();
    }
    ASSERT_EQ(session_->stage(), Stage::memory);
  }
  /// A new character from watching to memory, all of it well.
  void learn() {
    practise();
    write(true);
    ASSERT_EQ(session_->state(), StudySession::State::judged);
  }

  QTemporaryDir folder_;
  study::Time now_ = *study::parse_time("2026-03-02T10:00Z");
  std::chrono::milliseconds passed_{0};  ///< of the session's stopwatch
  QStringList said_;
  std::unique_ptr<Learner> learner_;
  std::unique_ptr<StudySession> session_;
};

}  // namespace nazori::ui
