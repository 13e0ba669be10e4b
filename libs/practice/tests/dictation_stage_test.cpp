// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/dictation_stage.h"

#include <set>
#include <string>

#include "nazori/practice/event_names.h"
#include "stage_under_test.h"

namespace nazori::practice {
namespace {

using State = DictationStage::State;
using Events = std::vector<std::string_view>;

class DictationStageTest : public StageTest {
 protected:
  DictationStageTest() {
    listen(dictation_);
    judge_.judged.connect([this](std::uint64_t, const writing::Grade&) { ++answers_; });
  }
  /// A character with the words of `texts` instead of those of the database.
  static StageSubject subject(char32_t code_point, const std::vector<std::string>& texts) {
    const auto of_database = character(code_point);
    auto sheet = std::make_shared<CharacterSheet>(*of_database.sheet);
    for (const auto& text : texts)
      sheet->words.push_back({text, "よみ", {"meaning of " + text}, {1}, "n", true});
    sheet->dictation = dictation_words(sheet->words, code_point, [](char32_t) { return true; });
    return {sheet, of_database.tablet};
  }
  void enter(char32_t code_point, const std::vector<std::string>& texts) {
    dictation_.enter(subject(code_point, texts));
    wait();
  }
  /// Until nothing is being looked up or judged.
  void wait() {
    inbox_.run_until([&] { return !dictation_.is_busy(); });
  }
  /// A stroke of a character, from 1.
  void write(char32_t code_point, int stroke) { write(line(character(code_point), stroke)); }
  void write(const std::vector<geometry::TabletPoint>& points) {
    hand_.write(points);
    wait();
  }
  void write_all(char32_t code_point) {
    const auto model = character(code_point);
    for (int n = 1; n <= static_cast<int>(model.tablet->lines().size()); ++n) write(line(model, n));
  }
  /// The names of what was reported since the last call.
  Events names() {
    Events all;
    for (const auto& what : std::exchange(reports_, {})) all.push_back(name_of(what));
    return all;
  }
  [[nodiscard]] std::vector<view::Verdict> on_tablet() {
    std::vector<view::Verdict> all;
    for (const auto& stroke : tablet_.overlay().writing) all.push_back(stroke.verdict);
    return all;
  }
  [[nodiscard]] const DictationStage::Box& box(std::size_t i) const { return dictation_.boxes().at(i); }

  WritingJudge judge_{inbox_, test::database()};
  CharacterLibrary library_{inbox_, test::database()};
  std::set<char32_t> known_;
  DictationStage dictation_{
      {inbox_, clock_, tablet_, library_, judge_, [this](char32_t one) { return known_.count(one) > 0; }}};
  int answers_ = 0;
};

TEST_F(DictationStageTest, AsksForAWordByReadingAndMeaningOnAnEmptyTablet) {
  enter(U'十', {"十人"});
  EXPECT_EQ(last().own, DictationStage::kWordAsked);
  EXPECT_EQ(last().count, 2);
  const auto details = dictation_.details(last());
  ASSERT_EQ(details.size(), 2U);
  EXPECT_EQ(std::get<std::string>(details[0].value), "よみ");
  EXPECT_EQ(std::get<std::string>(details[1].value), "meaning of 十人");
  EXPECT_TRUE(dictation_.hides_character());
  EXPECT_EQ(tablet_.stroke_count(), 0) << "no stroke of the character is there";
  EXPECT_EQ(dictation_.boxes().size(), 2U);
  EXPECT_EQ(dictation_.position(), 0U);
}

TEST_F(DictationStageTest, ACharacterThatIsRightGoesOnToTheNextAndTheWordHasAVerdict) {
  enter(U'十', {"十人"});
  (void)names();
  write(U'十', 1);
  EXPECT_EQ(names(), (Events{"stroke_right"}));
  write(U'十', 2);
  EXPECT_EQ(names(), (Events{DictationStage::kCharacterWritten}));
  EXPECT_TRUE(box(0).is_accepted());
  EXPECT_EQ(box(0).writing.strokes.size(), 2U) << "it is shown in its box";
  EXPECT_EQ(dictation_.position(), 1U);
  EXPECT_TRUE(on_tablet().empty()) << "the tablet is empty for the next";
  write_all(U'人');
  EXPECT_EQ(names(), (Events{"stroke_right", DictationStage::kWordJudged}));
  EXPECT_EQ(dictation_.state(), State::judged);
  EXPECT_TRUE(dictation_.is_accepted());
  EXPECT_GT(dictation_.score(), 80);
  EXPECT_FALSE(dictation_.hides_character());
  ASSERT_EQ(results_.size(), 1U) << "it is announced as of any stage";
  EXPECT_TRUE(results_[0].accepted);
  EXPECT_EQ(results_[0].score, dictation_.score());
}

TEST_F(DictationStageTest, AWrongStrokeIsToldAndTheVerdictNamesTheMistakesOfEachCharacter) {
  enter(U'十', {"十人"});
  const auto model = character(U'十');
  write(reversed(line(model, 1)));
  EXPECT_EQ(last().event, StageEvent::mistake);
  EXPECT_EQ(last().tone, Tone::wrong);
  EXPECT_EQ(on_tablet(), std::vector{view::Verdict::wrong});
  write(line(model, 2));
  EXPECT_EQ(dictation_.position(), 0U) << "it is not right, so it stays until it is finished";
  dictation_.finish_writing();
  wait();
  EXPECT_EQ(last().own, DictationStage::kCharacterWritten);
  EXPECT_EQ(last().tone, Tone::wrong);
  write_all(U'人');
  EXPECT_EQ(last().own, DictationStage::kWordJudged);
  EXPECT_FALSE(dictation_.is_accepted());
  const auto details = dictation_.details(last());
  EXPECT_EQ(std::get<std::string>(details.at(0).value), "十人");
  const auto& characters = std::get<std::vector<StageDetails>>(details.at(3).value);
  ASSERT_EQ(characters.size(), 2U);
  EXPECT_EQ(std::get<std::vector<std::string>>(characters[0].at(3).value),
            (std::vector<std::string>{"reversed"}));
  EXPECT_TRUE(std::get<std::vector<std::string>>(characters[1].at(3).value).empty());
  ASSERT_EQ(results_.size(), 1U);
  ASSERT_EQ(results_[0].mistakes.size(), 1U) << "those of the character that is practised";
  EXPECT_EQ(results_[0].mistakes[0].kind, kanji::MistakeKind::reversed);
}

TEST_F(DictationStageTest, UndoTakesBackStrokesAlsoThoseOfTheCharacterBefore) {
  enter(U'十', {"十人"});
  write_all(U'十');
  write(U'人', 1);
  dictation_.undo();
  wait();
  EXPECT_EQ(last().event, StageEvent::stroke_undone);
  EXPECT_EQ(dictation_.position(), 1U);
  EXPECT_TRUE(on_tablet().empty());
  dictation_.undo();
  wait();
  EXPECT_EQ(dictation_.position(), 0U);
  EXPECT_FALSE(box(0).is_finished);
  EXPECT_EQ(on_tablet(), std::vector{view::Verdict::right});
  write(U'十', 2);
  EXPECT_EQ(dictation_.position(), 1U);
  write_all(U'人');
  ASSERT_EQ(dictation_.state(), State::judged);
  dictation_.undo();
  wait();
  EXPECT_EQ(dictation_.state(), State::writing) << "a word that is judged can be corrected";
  EXPECT_EQ(on_tablet().size(), 1U);
  dictation_.undo();
  dictation_.undo();
  dictation_.undo();
  (void)names();
  dictation_.undo();
  EXPECT_TRUE(names().empty()) << "there is nothing more to undo";
}

TEST_F(DictationStageTest, ClearBeginsTheCharacterAgainAndAfterTheVerdictTheWord) {
  enter(U'十', {"十人"});
  write_all(U'十');
  write(U'人', 1);
  dictation_.start_over();
  EXPECT_TRUE(on_tablet().empty());
  EXPECT_EQ(dictation_.position(), 1U) << "what is finished stays";
  write_all(U'人');
  ASSERT_EQ(dictation_.state(), State::judged);
  dictation_.start_over();
  wait();
  EXPECT_EQ(dictation_.position(), 0U);
  EXPECT_FALSE(box(0).is_finished);
  EXPECT_EQ(dictation_.word()->word.text, "十人");
}

TEST_F(DictationStageTest, AHintShowsTheNextStrokeAndIsCounted) {
  enter(U'十', {"十人"});
  dictation_.give_hint();
  EXPECT_EQ(last().event, StageEvent::hint_given);
  EXPECT_EQ(last().stroke, 1);
  EXPECT_EQ(on_tablet(), std::vector{view::Verdict::shown});
  dictation_.give_hint();
  EXPECT_EQ(last().event, StageEvent::all_hints_given);
  EXPECT_EQ(on_tablet().size(), 2U);
  write_all(U'十');
  EXPECT_EQ(box(0).hints, 2);
  write_all(U'人');
  EXPECT_TRUE(dictation_.is_accepted());
  EXPECT_EQ(results_.at(0).hints, 2);
}

TEST_F(DictationStageTest, AWordWhoseAnswerWasShownIsNotWrittenFromMemory) {
  enter(U'十', {"十人"});
  dictation_.finish_writing();
  EXPECT_EQ(last().event, StageEvent::nothing_written);
  dictation_.show_answer();
  EXPECT_EQ(last().event, StageEvent::answer_shown);
  EXPECT_EQ(on_tablet().size(), 2U);
  dictation_.finish_writing();
  EXPECT_EQ(dictation_.position(), 1U) << "the learner may go on without writing it";
  write_all(U'人');
  EXPECT_EQ(dictation_.state(), State::judged);
  EXPECT_FALSE(dictation_.is_accepted());
  EXPECT_LT(dictation_.score(), 51);
  EXPECT_EQ(results_.at(0).shown_strokes, 2);
}

TEST_F(DictationStageTest, AnotherWordComesOnRequestAndAfterTheVerdictWithFinish) {
  enter(U'十', {"十人", "二十", "十一"});
  dictation_.next_word();
  wait();
  EXPECT_EQ(dictation_.word()->word.text, "二十");
  EXPECT_EQ(box(0).character, U'二');
  write_all(U'二');
  write_all(U'十');
  ASSERT_EQ(dictation_.state(), State::judged);
  write(U'十', 1);
  EXPECT_EQ(last().own, DictationStage::kWordOver);
  dictation_.finish_writing();
  wait();
  EXPECT_EQ(dictation_.word()->word.text, "十一");
  dictation_.next_word();
  wait();
  EXPECT_EQ(dictation_.word()->word.text, "十人") << "after the last the first";
}

TEST_F(DictationStageTest, AWordOfKanjiThatTheLearnerKnowsIsAskedForFirst) {
  known_ = {U'一'};
  enter(U'十', {"十人", "十一"});
  EXPECT_EQ(dictation_.word()->word.text, "十一");
}

TEST_F(DictationStageTest, WithoutAWordItSaysSoAndNothingCanBeWritten) {
  const auto alone = subject(U'十', {"十"});
  EXPECT_FALSE(dictation_.can_practise(alone));
  EXPECT_TRUE(dictation_.can_practise(subject(U'十', {"十人"})));
  enter(U'十', {"十"});
  EXPECT_EQ(names(), (Events{DictationStage::kNoWord}));
  EXPECT_EQ(dictation_.state(), State::unavailable);
  write(U'十', 1);
  for (const auto& command : dictation_.commands()) command.run();
  EXPECT_TRUE(names().empty());
  EXPECT_TRUE(on_tablet().empty());
  EXPECT_FALSE(dictation_.hides_character());
}

TEST_F(DictationStageTest, SpeechIsAskedForWithTheReading) {
  std::vector<std::string> spoken;
  dictation_.speech_wanted.connect([&](const std::string& reading) { spoken.push_back(reading); });
  enter(U'十', {"十人"});
  dictation_.speak();
  EXPECT_EQ(spoken, std::vector<std::string>{"よみ"});
  EXPECT_EQ(last().own, DictationStage::kSpeechWanted) << "where nobody speaks, the question is shown again";
}

TEST_F(DictationStageTest, TheWordIsKeptWhileTheLearnerLooksAtSomethingElse) {
  enter(U'十', {"十人", "二十"});
  dictation_.next_word();
  wait();
  write_all(U'二');
  write(U'十', 1);
  const auto subject = dictation_.subject();
  dictation_.leave();
  EXPECT_TRUE(tablet_.overlay().writing.empty());
  dictation_.enter(subject);
  wait();
  EXPECT_EQ(dictation_.word()->word.text, "二十");
  EXPECT_EQ(dictation_.position(), 1U);
  EXPECT_EQ(on_tablet().size(), 1U);
  write(U'十', 2);
  EXPECT_TRUE(dictation_.is_accepted());
  dictation_.leave();
  dictation_.enter(subject);
  EXPECT_EQ(last().own, DictationStage::kWordJudged);
  EXPECT_EQ(on_tablet().size(), 2U);
}

TEST_F(DictationStageTest, AWordThatWasStillComingIsAskedForAgain) {
  enter(U'十', {"十人", "二十"});
  const auto subject = dictation_.subject();
  dictation_.next_word();
  ASSERT_EQ(dictation_.state(), State::coming);
  dictation_.leave();
  dictation_.enter(subject);
  wait();
  EXPECT_EQ(dictation_.state(), State::writing);
  EXPECT_EQ(dictation_.word()->word.text, "二十");
  EXPECT_EQ(box(0).character, U'二');
}

TEST_F(DictationStageTest, TheSameCharacterShownAgainGoesOnAsWell) {
  enter(U'十', {"十人"});
  const auto subject = dictation_.subject();
  write(U'十', 1);
  dictation_.enter(subject);
  wait();
  EXPECT_EQ(on_tablet().size(), 1U);
  dictation_.undo();
  dictation_.enter(subject);
  wait();
  EXPECT_TRUE(on_tablet().empty()) << "what was taken back does not come back";
}

TEST_F(DictationStageTest, ACharacterWithoutAWordLeavesNothingOnTheTablet) {
  enter(U'十', {"十人"});
  write(U'十', 1);
  enter(U'一', {"一"});
  EXPECT_EQ(dictation_.state(), State::unavailable);
  EXPECT_TRUE(on_tablet().empty());
  write(U'一', 1);
  EXPECT_TRUE(on_tablet().empty());
}

TEST_F(DictationStageTest, AnotherCharacterHasAnotherWord) {
  enter(U'十', {"十人"});
  write(U'十', 1);
  enter(U'一', {"一人"});
  EXPECT_EQ(dictation_.word()->word.text, "一人");
  EXPECT_TRUE(on_tablet().empty());
}

TEST_F(DictationStageTest, AnotherLearnerSeesNothingThatWasWritten) {
  enter(U'十', {"十人"});
  write_all(U'十');
  dictation_.forget();
  wait();
  EXPECT_EQ(dictation_.position(), 0U);
  EXPECT_FALSE(box(0).is_finished);
  EXPECT_TRUE(box(0).writing.strokes.empty());
}

TEST_F(DictationStageTest, TheEraserOfThePenTakesBackAStroke) {
  enter(U'十', {"十人"});
  write(U'十', 1);
  ASSERT_EQ(on_tablet().size(), 1U);
  tablet_.eraser_used();
  EXPECT_TRUE(on_tablet().empty());
}

TEST_F(DictationStageTest, AnotherCharacterThanTheOneAskedIsNamedWhenItIsFinished) {
  enter(U'日', {"日本"});
  const auto other = character(U'大');
  for (int n = 1; n <= 3; ++n) write(line(other, n));
  EXPECT_EQ(last().event, StageEvent::other_character);
  EXPECT_EQ(last().asked, 0U);
  dictation_.finish_writing();
  wait();
  EXPECT_EQ(dictation_.position(), 1U) << "the next is being written";
  EXPECT_EQ(last().event, StageEvent::other_character);
  EXPECT_EQ(last().written, U'大');
  EXPECT_EQ(last().asked, U'日');
  EXPECT_EQ(box(0).other, U'大');
  EXPECT_EQ(box(1).other, 0U);
  dictation_.undo();
  EXPECT_EQ(box(0).other, 0U);
}

}  // namespace
}  // namespace nazori::practice
