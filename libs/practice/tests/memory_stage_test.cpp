// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/memory_stage.h"

#include <string>

#include "stage_under_test.h"

namespace nazori::practice {
namespace {

using Groove = WritingGroove::Mode;
using State = MemoryStage::State;
using study::MissReply;

class MemoryStageTest : public StageTest {
 protected:
  MemoryStageTest() {
    listen(memory_);
    memory_.judged.connect([this](const writing::Grade& grade) { grades_.push_back(grade); });
    judge_.judged.connect([this](std::uint64_t, const writing::Grade&) { ++answers_; });
    judge_.judging_failed.connect([this](std::uint64_t, const base::Error&) { ++answers_; });
  }
  void enter(char32_t code_point) {
    subject_ = character(code_point);
    memory_.enter(subject_);
  }
  /// A stroke of the subject, from 1, and the judge's answer to it.
  void write(int stroke) { write(line(subject_, stroke)); }
  void write(const std::vector<geometry::TabletPoint>& points) {
    const int before = answers_;
    const auto judged_before = grades_.size();
    hand_.write(points);
    wait(before + 1);
    // A character that is complete is judged once more, as a whole.
    const bool is_complete = memory_.options().judges_each && memory_.has_unjudged() &&
                             !memory_.grade().strokes.empty() && memory_.grade().mistakes.empty() &&
                             static_cast<int>(memory_.strokes().size()) == stroke_count();
    if (is_complete) inbox_.run_until([&] { return grades_.size() > judged_before; });
  }
  void write_all() {
    for (int n = 1; n <= stroke_count(); ++n) write(n);
  }
  void wait(int answers) {
    inbox_.run_until([&] { return answers_ >= answers; });
  }
  [[nodiscard]] int stroke_count() const { return static_cast<int>(subject_.tablet->lines().size()); }

  StageSubject subject_;
  WritingJudge judge_{inbox_, test::database()};
  MemoryStage memory_{inbox_, tablet_, judge_};
  std::vector<writing::Grade> grades_;
  int answers_ = 0;
};

TEST_F(MemoryStageTest, AsksForTheCharacterHidesItAndJudgesItWhenItIsComplete) {
  enter(U'十');
  EXPECT_EQ(events(), std::vector{StageEvent::write_character});
  EXPECT_TRUE(memory_.hides_character());
  EXPECT_NE(tablet_.tablet(), subject_.tablet) << "nothing is carved";
  write(1);
  EXPECT_EQ(last().event, StageEvent::stroke_right);
  EXPECT_EQ(last().stroke, 1);
  EXPECT_EQ(last().count, 1) << "one is left";
  EXPECT_TRUE(memory_.has_unjudged());
  write(2);
  EXPECT_EQ(last().event, StageEvent::judged);
  ASSERT_EQ(grades_.size(), 1U);
  EXPECT_TRUE(grades_[0].accepted);
  EXPECT_EQ(memory_.state(), State::judged);
  EXPECT_FALSE(memory_.hides_character());
  EXPECT_FALSE(memory_.has_unjudged());
}

TEST_F(MemoryStageTest, AStrokeThatIsNoneOfTheCharacterIsRefusedAndStaysUntilItIsUndone) {
  enter(U'十');
  const std::vector<geometry::TabletPoint> slash{{-0.04, -0.04}, {-0.03, 0.02}};
  write(slash);
  EXPECT_EQ(last().tone, Tone::wrong);
  EXPECT_EQ(memory_.strokes().size(), 1U);
  ASSERT_EQ(tablet_.overlay().writing.size(), 1U);
  EXPECT_EQ(tablet_.overlay().writing[0].verdict, view::Verdict::wrong);
  memory_.undo();
  EXPECT_EQ(last().event, StageEvent::stroke_undone);
  EXPECT_EQ(last().count, 0);
  EXPECT_TRUE(tablet_.overlay().writing.empty());
  memory_.undo();
  EXPECT_EQ(last().count, 0) << "there is nothing more to undo";
}

TEST_F(MemoryStageTest, AStrokeThatWasPassedOverIsNamedAsLongAsItIsMissing) {
  enter(U'三');
  write(2);
  write(3);
  EXPECT_EQ(memory_.strokes().size(), 2U);
  const auto all = events();
  EXPECT_TRUE(std::count(all.begin(), all.end(), StageEvent::stroke_right_other_missing) > 0 ||
              std::count(all.begin(), all.end(), StageEvent::mistake) > 0);
  EXPECT_TRUE(grades_.empty()) << "it is not complete";
}

TEST_F(MemoryStageTest, JudgedAtTheEndNothingIsSaidOfAStrokeBefore) {
  enter(U'十');
  memory_.set_judges_each(false);
  EXPECT_EQ(last().event, StageEvent::judges_at_end);
  write(1);
  EXPECT_EQ(last().event, StageEvent::strokes_unjudged);
  EXPECT_EQ(last().count, 1);
  EXPECT_EQ(tablet_.overlay().writing[0].verdict, view::Verdict::none);
  write(2);
  EXPECT_TRUE(grades_.empty());
  memory_.finish_writing();
  inbox_.run_until([&] { return !grades_.empty(); });
  EXPECT_EQ(tablet_.overlay().writing[0].verdict, view::Verdict::right);
  memory_.set_judges_each(true);
  EXPECT_EQ(last().event, StageEvent::judges_each);
}

TEST_F(MemoryStageTest, AnEmptyTabletIsNotJudged) {
  enter(U'十');
  memory_.finish_writing();
  EXPECT_EQ(last().event, StageEvent::nothing_written);
  EXPECT_EQ(last().tone, Tone::advice);
  EXPECT_EQ(answers_, 0);
}

TEST_F(MemoryStageTest, TheFirstHintShowsTheNextStrokeTheSecondAllThatAreMissing) {
  int hints = 0;
  memory_.hint_given.connect([&] { ++hints; });
  enter(U'三');
  write(1);
  memory_.give_hint();
  EXPECT_EQ(last().event, StageEvent::hint_given);
  EXPECT_EQ(last().stroke, 2);
  EXPECT_EQ(tablet_.overlay().writing.size(), 2U);
  EXPECT_EQ(tablet_.overlay().writing[1].verdict, view::Verdict::shown);
  memory_.give_hint();
  EXPECT_EQ(last().event, StageEvent::all_hints_given);
  EXPECT_EQ(tablet_.overlay().writing.size(), 3U);
  EXPECT_EQ(hints, 2);
  write(2);
  EXPECT_EQ(tablet_.overlay().writing.size(), 2U) << "hints go when the next stroke is written";
  write(3);
  memory_.give_hint();
  EXPECT_EQ(last().event, StageEvent::all_strokes_there);
  EXPECT_EQ(hints, 2);
}

TEST_F(MemoryStageTest, TheAnswerShowsAllStrokesAndWritingGoesOnFromThere) {
  int shown = 0, continued = 0;
  memory_.answer_was_shown.connect([&] { ++shown; });
  memory_.continued.connect([&] { ++continued; });
  enter(U'三');
  memory_.show_answer();
  EXPECT_EQ(last().event, StageEvent::answer_shown);
  EXPECT_EQ(shown, 1);
  EXPECT_EQ(tablet_.overlay().writing.size(), 3U);
  EXPECT_EQ(memory_.state(), State::answer_shown);
  EXPECT_FALSE(memory_.hides_character());
  write(1);
  EXPECT_EQ(continued, 1);
  EXPECT_EQ(memory_.state(), State::writing);
  EXPECT_TRUE(memory_.hides_character());
}

TEST_F(MemoryStageTest, InALessonARefusedStrokeMakesRoomForTheNextTry) {
  std::vector<int> asked;
  memory_.set_on_mistake([&](int stroke) {
    asked.push_back(stroke);
    return asked.size() == 1 ? MissReply::try_again : asked.size() == 2 ? MissReply::hint : MissReply::show;
  });
  enter(U'十');
  const std::vector<geometry::TabletPoint> slash{{-0.04, -0.04}, {-0.03, 0.02}};
  write(slash);
  EXPECT_EQ(last().more, MistakeHelp::none);
  write(slash);
  EXPECT_EQ(memory_.strokes().size(), 1U) << "the first one is gone";
  EXPECT_EQ(last().more, MistakeHelp::hint);
  write(slash);
  EXPECT_EQ(asked, (std::vector{0, 0, 0}));
  EXPECT_EQ(last().event, StageEvent::stroke_hinted);
  EXPECT_EQ(last().stroke, 1);
  EXPECT_TRUE(memory_.strokes().empty());
  ASSERT_EQ(tablet_.overlay().writing.size(), 1U);
  EXPECT_EQ(tablet_.overlay().writing[0].verdict, view::Verdict::shown);
  write_all();
  EXPECT_TRUE(grades_.at(0).accepted);
}

TEST_F(MemoryStageTest, InALessonTheGrooveIsNotShownWhateverWasChosen) {
  memory_.set_options({true, Groove::shown, writing::kNormal});
  enter(U'十');
  EXPECT_FALSE(memory_.hides_character()) << "the groove shows it";
  const int shown = tablet_.tablet()->height_map().size();
  memory_.set_on_mistake([](int) { return MissReply::try_again; });
  memory_.enter(subject_);
  EXPECT_TRUE(memory_.hides_character());
  EXPECT_NE(tablet_.tablet()->height_map().size(), shown);
}

TEST_F(MemoryStageTest, AnotherGrooveMayBeChosenWhileWriting) {
  enter(U'十');
  int hiding = 0;
  memory_.hiding_changed.connect([&] { ++hiding; });
  memory_.set_groove(Groove::shown);
  EXPECT_EQ(hiding, 1);
  EXPECT_FALSE(memory_.hides_character());
  EXPECT_EQ(memory_.options().groove, Groove::shown);
}

TEST_F(MemoryStageTest, AnotherStrictnessJudgesWhatIsWrittenAgain) {
  enter(U'十');
  memory_.set_strictness(writing::kStrict);
  EXPECT_EQ(answers_, 0);
  write_all();
  ASSERT_EQ(grades_.size(), 1U);
  memory_.set_strictness(writing::kLenient);
  inbox_.run_until([&] { return grades_.size() == 2; });
  EXPECT_DOUBLE_EQ(memory_.options().strictness, writing::kLenient);
}

TEST_F(MemoryStageTest, AWritingIsKeptWhileTheLearnerLooksAtSomethingElse) {
  enter(U'十');
  write(1);
  memory_.leave();
  EXPECT_TRUE(tablet_.overlay().writing.empty());
  memory_.set_resumes(true, false);
  const int before = answers_;
  memory_.enter(subject_);
  EXPECT_EQ(memory_.strokes().size(), 1U);
  wait(before + 1);
  write(2);
  EXPECT_TRUE(grades_.at(0).accepted);
  memory_.leave();
  (void)events();
  memory_.enter(subject_);
  EXPECT_EQ(memory_.state(), State::judged);
  EXPECT_EQ(events(), std::vector{StageEvent::judged});
}

TEST_F(MemoryStageTest, WithoutResumingOrForAnotherLearnerItBeginsAgain) {
  enter(U'十');
  write(1);
  memory_.leave();
  memory_.set_resumes(false, false);
  memory_.enter(subject_);
  EXPECT_TRUE(memory_.strokes().empty());
  write(1);
  memory_.forget();
  EXPECT_TRUE(memory_.strokes().empty());
  EXPECT_EQ(last().event, StageEvent::write_character);
  write(1);
  memory_.leave();
  memory_.forget();
  memory_.set_resumes(true, false);
  memory_.enter(subject_);
  EXPECT_TRUE(memory_.strokes().empty());
}

TEST_F(MemoryStageTest, AnUnratedWritingIsKeptWhateverIsWrittenMeanwhileAndGoesWithItsRating) {
  memory_.set_on_mistake([](int) { return MissReply::try_again; });
  enter(U'十');
  write_all();
  ASSERT_EQ(memory_.state(), State::judged);
  memory_.leave();
  memory_.set_on_mistake({});
  memory_.set_resumes(false, true);
  const auto first = subject_;
  enter(U'一');
  write(1);
  memory_.leave();
  memory_.set_on_mistake([](int) { return MissReply::try_again; });
  memory_.set_resumes(true, true);
  memory_.enter(first);
  EXPECT_EQ(memory_.state(), State::judged);
  EXPECT_EQ(memory_.strokes().size(), 2U);
  memory_.leave();
  memory_.set_resumes(true, false);
  memory_.enter(first);
  EXPECT_TRUE(memory_.strokes().empty()) << "it was rated meanwhile";
}

TEST_F(MemoryStageTest, AVerdictThatComesAfterTheAnswerWasShownIsNotReported) {
  enter(U'一');
  hand_.write(line(subject_, 1));
  memory_.show_answer();
  (void)events();
  wait(1);
  EXPECT_TRUE(events().empty());
  EXPECT_TRUE(grades_.empty());
  EXPECT_EQ(memory_.state(), State::answer_shown);
}

TEST_F(MemoryStageTest, AVerdictOfAWritingThatIsGoneIsDropped) {
  enter(U'一');
  hand_.write(line(subject_, 1));
  memory_.leave();
  wait(1);
  EXPECT_TRUE(grades_.empty());
  EXPECT_EQ(events(), std::vector{StageEvent::write_character});
}

TEST_F(MemoryStageTest, NoMoreStrokesThanTheJudgeReads) {
  enter(U'一');
  for (std::size_t i = 0; i < writing::kMaxInkStrokes + 2; ++i) hand_.write({{0, 0}, {0.01, 0}});
  EXPECT_EQ(memory_.strokes().size(), writing::kMaxInkStrokes);
  EXPECT_EQ(last().event, StageEvent::tablet_full);
}

TEST_F(MemoryStageTest, TheModelLiesOverTheWritingWhileItIsAskedForAndAReplayShowsAMoment) {
  enter(U'十');
  write(1);
  memory_.set_model_over(true);
  EXPECT_EQ(tablet_.overlay().writing.size(), 3U) << "one written, two of the model";
  memory_.set_model_over(false);
  const auto whole = tablet_.overlay().writing[0].points.size();
  memory_.show_moment(0.1);
  EXPECT_LT(tablet_.overlay().writing[0].points.size(), whole);
  memory_.show_moment(std::nullopt);
  EXPECT_EQ(tablet_.overlay().writing[0].points.size(), whole);
  int stopped = 0;
  memory_.replay_stopped.connect([&] { ++stopped; });
  memory_.set_model_over(true);
  memory_.start_over();
  EXPECT_GE(stopped, 1);
  EXPECT_TRUE(tablet_.overlay().writing.empty()) << "no model over an empty tablet";
}

TEST_F(MemoryStageTest, WithoutADatabaseTheWritingIsKeptAndTheFailureReported) {
  WritingJudge nowhere(inbox_, std::filesystem::path("/nowhere/kanji.db"));
  MemoryStage memory(inbox_, tablet_, nowhere);
  bool has_failed = false;
  memory.feedback.connect([&](const StageFeedback& what) {
    if (what.event != StageEvent::judging_failed) return;
    has_failed = true;
    EXPECT_TRUE(what.error);
  });
  subject_ = character(U'一');
  memory.enter(subject_);
  hand_.write(line(subject_, 1));
  inbox_.run_until([&] { return has_failed; });
  EXPECT_EQ(memory.strokes().size(), 1U);
}

TEST(MemoryStageOptions, AreStoredByNameAndComeBack) {
  MemoryStage::Options options{false, WritingGroove::Mode::appears, 0.85};
  base::Settings settings{{"stage", "memory"}};
  options.save(settings);
  EXPECT_EQ(
      settings,
      (base::Settings{
          {"groove", "appears"}, {"judge_each", "false"}, {"stage", "memory"}, {"strictness", "0.85"}}));
  MemoryStage::Options read;
  read.load(settings);
  EXPECT_FALSE(read.judges_each);
  EXPECT_EQ(read.groove, WritingGroove::Mode::appears);
  EXPECT_EQ(read.strictness, 0.85);
}

TEST(MemoryStageOptions, WhatCannotBeReadIsAsAtFirst) {
  for (const char* strictness : {"", "much", "-0.1", "1.5"}) {
    MemoryStage::Options read;
    read.load({{"groove", "deep"}, {"judge_each", "perhaps"}, {"strictness", strictness}});
    EXPECT_TRUE(read.judges_each);
    EXPECT_EQ(read.groove, WritingGroove::Mode::hidden);
    EXPECT_EQ(read.strictness, writing::kNormal) << strictness;
  }
}

TEST_F(MemoryStageTest, AnotherCharacterThanTheOneAskedIsNamedAtOnceWithoutGivingTheAnswerAway) {
  enter(U'日');
  const auto other = character(U'大');
  for (int n = 1; n <= 3; ++n) write(line(other, n));
  inbox_.run_until([&] { return !memory_.is_busy(); });
  EXPECT_EQ(last().event, StageEvent::other_character);
  EXPECT_EQ(last().tone, Tone::wrong);
  EXPECT_EQ(last().written, U'大');
  EXPECT_EQ(last().asked, 0U) << "it is still to be written from memory";
  memory_.finish_writing();
  inbox_.run_until([&] { return !memory_.is_busy(); });
  EXPECT_EQ(last().event, StageEvent::other_character);
  EXPECT_EQ(last().written, U'大');
  EXPECT_EQ(last().asked, U'日');
  EXPECT_FALSE(grades_.at(0).accepted);
}

TEST_F(MemoryStageTest, AnotherCharacterIsNamedInALessonTooThoughItsStrokesWereRefused) {
  memory_.set_on_mistake([](int) { return MissReply::try_again; });
  enter(U'日');
  const auto other = character(U'大');
  for (int n = 1; n <= 3; ++n) write(line(other, n));
  inbox_.run_until([&] { return !memory_.is_busy(); });
  EXPECT_EQ(last().event, StageEvent::other_character);
  EXPECT_EQ(last().written, U'大');
}

TEST_F(MemoryStageTest, ALookalikeIsNamedByTheVerdict) {
  enter(U'土');
  memory_.set_judges_each(false);
  const auto other = character(U'士');
  for (int n = 1; n <= 3; ++n) write(line(other, n));
  memory_.finish_writing();
  inbox_.run_until([&] { return !memory_.is_busy() && !grades_.empty(); });
  EXPECT_EQ(last().event, StageEvent::other_character);
  EXPECT_EQ(last().written, U'士');
  EXPECT_EQ(last().asked, U'土');
}

TEST_F(MemoryStageTest, TheBeginningOfTheCharacterIsNotTakenForAnother) {
  enter(U'林');
  for (int n = 1; n <= 3; ++n) write(n);
  write(reversed(line(subject_, 4)));
  inbox_.run_until([&] { return !memory_.is_busy(); });
  const auto all = events();
  EXPECT_EQ(std::count(all.begin(), all.end(), StageEvent::other_character), 0) << "木 is how 林 begins";
}

TEST_F(MemoryStageTest, JudgedAtTheEndNothingIsNamedBefore) {
  enter(U'日');
  memory_.set_judges_each(false);
  const auto other = character(U'大');
  for (int n = 1; n <= 3; ++n) write(line(other, n));
  inbox_.run_until([&] { return !memory_.is_busy(); });
  const auto all = events();
  EXPECT_EQ(std::count(all.begin(), all.end(), StageEvent::other_character), 0);
}

TEST_F(MemoryStageTest, TheRightStrokesAreDrawnOverAWritingThatCouldBeBetterUntilItGoesOn) {
  const auto drawn = [this] {
    const auto& writing = tablet_.overlay().writing;
    return std::count_if(writing.begin(), writing.end(), [](const view::InkedStroke& stroke) {
      return stroke.verdict == view::Verdict::shown && stroke.opacity == 1;
    });
  };
  enter(U'十');
  EXPECT_FALSE(memory_.can_show_right()) << "it would show the answer";
  memory_.set_judges_each(false);
  write(reversed(line(subject_, 1)));
  write(2);
  memory_.finish_writing();
  inbox_.run_until([&] { return !memory_.is_busy() && !grades_.empty(); });
  ASSERT_TRUE(memory_.can_show_right());
  memory_.show_right(true);
  EXPECT_TRUE(memory_.is_showing_right());
  EXPECT_EQ(drawn(), 0);
  for (int i = 0; i < 1000 && memory_.is_showing_right(); ++i) memory_.advance_right(0.05);
  EXPECT_FALSE(memory_.is_showing_right());
  EXPECT_EQ(drawn(), 1) << "only the stroke that was drawn from its end";
  memory_.start_over();
  EXPECT_EQ(drawn(), 0);
  EXPECT_FALSE(memory_.can_show_right());
}

}  // namespace
}  // namespace nazori::practice
