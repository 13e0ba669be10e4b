// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "learner_under_test.h"
#include "nazori/practice/study_session.h"

namespace nazori::practice {

/// A session of a learner with two new characters a day.
class SessionTest : public LearnerTest {
 protected:
  SessionTest() { open(); }
  ~SessionTest() override { session_.reset(); }

  /// As after the program was started again.
  void open() {
    session_.reset();
    open_learner();
    session_ = std::make_unique<StudySession>(*learner_, clock_);
    session_->set_asks_by_words(false);
    session_->announced.connect([this](const SessionFeedback& event) { events_.push_back(event); });
    session_->character_wanted.connect([this](char32_t character) { bring(character); });
    if (learner_->can_write() && learner_->store().settings().new_per_day != 2) {
      auto settings = learner_->store().settings();
      settings.new_per_day = 2;
      ASSERT_TRUE(learner_->store().change_settings(settings));
    }
  }
  /// Only these characters are learned, in this order.
  void learn_from(std::vector<char32_t> characters) {
    ASSERT_TRUE(learner_->store().save_list({"few", std::move(characters)}));
    auto settings = learner_->store().settings();
    settings.new_lists = {"list:few"};
    settings.new_order = study::NewOrder::own;
    ASSERT_TRUE(learner_->store().change_settings(settings));
    learner_->renew_order();
  }

  /// Makes the tablet show the character.
  void bring(char32_t character) {
    auto sheet = std::make_shared<CharacterSheet>();
    sheet->character = *learner_->database()->find(character);
    session_->set_sheet(sheet);
  }

  static std::vector<HandStroke> hand() {
    HandStroke stroke;
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
  /// Takes a new character up to the question from memory, without mistakes.
  void practise() {
    using study::Stage;
    for (const Stage stage : {Stage::watch, Stage::trace, Stage::guided}) {
      ASSERT_EQ(session_->stage(), stage);
      session_->finish_stage(stage, {});
      session_->go_on();
    }
    ASSERT_EQ(session_->stage(), Stage::memory);
  }
  /// Takes a new character from watching to memory, without mistakes.
  void learn() {
    practise();
    write(true);
    ASSERT_EQ(session_->state(), StudySession::State::judged);
  }

  std::vector<SessionFeedback> events_;
  std::unique_ptr<StudySession> session_;
};

}  // namespace nazori::practice
