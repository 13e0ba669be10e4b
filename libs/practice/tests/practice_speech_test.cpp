// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/practice_speech.h"

#include <gmock/gmock.h>

#include "nazori/practice/dictation_stage.h"
#include "session_under_test.h"
#include "stage_under_test.h"

namespace nazori::practice {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Cause = PracticeSpeech::Cause;

/// What is spoken, with its cause: "question か".
class PracticeSpeechTest : public LearnerTest {
 protected:
  PracticeSpeechTest() {
    practice_.character_shown.connect([this](char32_t character) { shown_.push_back(character); });
    practice_.wanted.connect([this] { practice_.enter(); });
    speech_.wanted.connect([this](const std::string& kana, Cause cause) {
      const char* const names[] = {"wanted ", "question ", "answer "};
      spoken_.push_back(names[static_cast<int>(cause)] + kana);
    });
    session_.set_asks_by_words(false);
  }
  void learn_from(std::vector<char32_t> characters) {
    ASSERT_TRUE(learner_->store().save_list({"few", std::move(characters)}));
    auto settings = learner_->store().settings();
    settings.new_lists = {"list:few"};
    settings.new_order = study::NewOrder::own;
    ASSERT_TRUE(learner_->store().change_settings(settings));
    learner_->renew_order();
  }
  void show(char32_t character) {
    const auto before = shown_.size();
    practice_.show(character);
    inbox_.run_until([&] { return shown_.size() > before; });
  }
  void start() {
    const auto before = shown_.size();
    ASSERT_TRUE(session_.start());
    inbox_.run_until([&] { return shown_.size() > before; });
  }
  void write(const Tablet& model) {
    for (const auto& path : model->paths()) {
      std::vector<geometry::TabletPoint> line;
      for (const auto& p : path.points) line.push_back({p.x, p.y});
      hand_.write(line);
    }
  }
  std::vector<std::string> spoken() { return std::exchange(spoken_, {}); }

  TabletControl tablet_{inbox_, clock_, {}};
  TestHand hand_{tablet_};
  CharacterLibrary library_{inbox_, kanji_db()};
  TabletWorkshop workshop_{inbox_};
  WritingJudge judge_{inbox_, kanji_db()};
  StudySession session_{*learner_, clock_};
  CharacterPractice practice_{{inbox_, clock_, tablet_, library_, workshop_, judge_, session_}};
  PracticeSpeech speech_{practice_, session_};
  std::vector<char32_t> shown_;
  std::vector<std::string> spoken_;
};

TEST(ReadingToSpeak, IsTheKanaItselfOrAReadingOfEachKind) {
  CharacterSheet sheet;
  sheet.character.code_point = U'か';
  EXPECT_EQ(reading_to_speak(sheet), "か");
  sheet.character.code_point = U'休';
  sheet.character.entry.on_readings = {"キュウ", "ク"};
  sheet.character.entry.kun_readings = {"-やす", "やす.む", "やす.まる"};
  EXPECT_EQ(reading_to_speak(sheet), "キュウ、やすむ");
  sheet.character.entry.on_readings.clear();
  EXPECT_EQ(reading_to_speak(sheet), "やすむ");
  sheet.character.entry.kun_readings = {"-やす"};
  EXPECT_EQ(reading_to_speak(sheet), "");
}

TEST_F(PracticeSpeechTest, NothingIsSpokenByItselfWhileCharactersAreLookedAt) {
  practice_.enter();
  show(U'か');
  show(U'休');
  EXPECT_THAT(spoken(), IsEmpty());
  EXPECT_TRUE(speech_.speak());
  EXPECT_THAT(spoken(), ElementsAre("wanted キュウ、やすむ"));
}

TEST_F(PracticeSpeechTest, AKanaIsHeardWhenItIsTaughtAskedAndAnswered) {
  learn_from({U'し'});
  practice_.enter();
  start();
  EXPECT_THAT(spoken(), ElementsAre("question し"));
  practice_.enter_stage(practice_.memory());
  EXPECT_THAT(spoken(), ElementsAre("question し")) << "it is asked for by its sound";
  write(practice_.tablet());
  inbox_.run_until([&] { return session_.state() == StudySession::State::judged; });
  EXPECT_THAT(spoken(), ElementsAre("answer し"));
}

TEST_F(PracticeSpeechTest, AKanjiIsHeardOnlyAfterTheAnswer) {
  learn_from({U'休'});
  practice_.enter();
  start();
  practice_.enter_stage(practice_.memory());
  EXPECT_THAT(spoken(), IsEmpty());
  practice_.memory().show_answer();
  EXPECT_THAT(spoken(), ElementsAre("answer キュウ、やすむ"));
}

TEST_F(PracticeSpeechTest, ADictationSpeaksTheWordWhenItIsAskedForOnDemandAndAtTheEnd) {
  practice_.enter();
  show(U'十');
  auto& dictation = practice_.get<DictationStage>();
  practice_.enter_stage(dictation);
  inbox_.run_until([&] { return !dictation.is_busy(); });
  const std::string word = dictation.word()->word.reading;
  EXPECT_THAT(spoken(), ElementsAre("question " + word));
  EXPECT_TRUE(speech_.speak());
  dictation.speak();
  EXPECT_THAT(spoken(), ElementsAre("wanted " + word, "wanted " + word));
  for (const auto& box : std::vector(dictation.boxes())) {
    write(box.model);
    inbox_.run_until([&] { return !dictation.is_busy(); });
  }
  ASSERT_EQ(dictation.state(), DictationStage::State::judged);
  EXPECT_THAT(spoken(), ElementsAre("answer " + word));
}

TEST_F(PracticeSpeechTest, WithoutACharacterThereIsNothingToSpeak) {
  EXPECT_FALSE(speech_.speak());
  EXPECT_THAT(spoken(), IsEmpty());
}

}  // namespace
}  // namespace nazori::practice
