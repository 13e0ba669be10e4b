// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/watch_stage.h"

#include "stage_under_test.h"

namespace nazori::practice {
namespace {

using std::chrono::milliseconds;

class WatchStageTest : public StageTest {
 protected:
  WatchStageTest() { listen(watch_); }
  /// Plays frame by frame until the writing stops or that time has passed.
  void play(double most_s) {
    for (double passed_s = 0; watch_.is_playing() && passed_s < most_s; passed_s += 0.016) {
      clock_.advance(milliseconds{16});
      watch_.advance();
    }
  }
  [[nodiscard]] std::vector<double> ink() {
    const auto overlay = tablet_.overlay();
    return {overlay.groove_ink.begin(), overlay.groove_ink.end()};
  }
  WatchStage watch_{tablet_, clock_};
};

TEST_F(WatchStageTest, NamesEachStrokeOnceAsItIsWrittenAndIsFinishedAtTheEnd) {
  watch_.enter(three());
  EXPECT_TRUE(watch_.is_playing());
  play(60);
  EXPECT_FALSE(watch_.is_playing());
  ASSERT_EQ(reports_.size(), 4U);
  for (int n = 1; n <= 3; ++n) {
    const auto& report = reports_[static_cast<std::size_t>(n - 1)];
    EXPECT_EQ(report.event, StageEvent::stroke_watched);
    EXPECT_EQ(report.stroke, n);
    EXPECT_EQ(report.count, 3);
    EXPECT_EQ(report.ending, n == 3 ? kanji::StrokeEnding::taper : kanji::StrokeEnding::stop);
  }
  EXPECT_EQ(last().event, StageEvent::all_watched);
  EXPECT_EQ(last().tone, Tone::good);
  EXPECT_EQ(last().count, 3);
  EXPECT_EQ(results_.size(), 1U);
}

TEST_F(WatchStageTest, GoesByTheClockAndTwiceAsFastAtTwiceTheSpeed) {
  watch_.enter(three());
  clock_.advance(milliseconds{700});
  watch_.advance();
  const auto usual = ink();
  watch_.set_playing(false);
  watch_.show_moment(0);
  watch_.faster();
  watch_.faster();
  EXPECT_NEAR(watch_.speed(), 2, 1e-12);
  watch_.set_playing(true);
  clock_.advance(milliseconds{350});
  watch_.advance();
  EXPECT_GT(usual[0], 0);
  EXPECT_NEAR(tablet_.overlay().groove_ink[0], usual[0], 1e-9);
}

TEST_F(WatchStageTest, TheSpeedStaysBetweenAQuarterAndFourTimes) {
  watch_.enter(three());
  for (int i = 0; i < 10; ++i) watch_.faster();
  EXPECT_DOUBLE_EQ(watch_.speed(), 4);
  EXPECT_EQ(last().event, StageEvent::speed_changed);
  EXPECT_DOUBLE_EQ(last().value, 4);
  for (int i = 0; i < 20; ++i) watch_.slower();
  EXPECT_DOUBLE_EQ(watch_.speed(), 0.25);
}

TEST_F(WatchStageTest, ALoopBeginsAgainAndEachRoundIsFinished) {
  watch_.set_looping(true);
  watch_.enter(three());
  play(3 * watch_.player().duration_s());
  EXPECT_TRUE(watch_.is_playing());
  EXPECT_GE(results_.size(), 2U);
  const auto all = events();
  EXPECT_EQ(std::count(all.begin(), all.end(), StageEvent::all_watched), 0);
  EXPECT_GE(std::count(all.begin(), all.end(), StageEvent::stroke_watched), 6);
}

TEST_F(WatchStageTest, StepsGoToTheEndsOfStrokesAndBackToTheStart) {
  watch_.enter(three());
  const auto inked = [&] {
    const auto ink = tablet_.overlay().groove_ink;
    return static_cast<int>(
        std::count_if(ink.begin(), ink.end(), [](double share) { return share > 1 - 1e-9; }));
  };
  watch_.step(+1);
  EXPECT_FALSE(watch_.is_playing());
  EXPECT_EQ(inked(), 0) << "the start of the first stroke";
  for (int n = 1; n <= 3; ++n) {
    EXPECT_TRUE(results_.empty());
    watch_.step(+1);
    EXPECT_EQ(inked(), n);
  }
  EXPECT_EQ(results_.size(), 1U) << "stepping to the end is watching, too";
  watch_.step(-1);
  EXPECT_EQ(inked(), 2);
  watch_.step(-1);
  watch_.step(-1);
  watch_.step(-1);
  EXPECT_EQ(inked(), 0);
  EXPECT_EQ(watch_.current_stroke(), 1);
}

TEST_F(WatchStageTest, WithReducedMotionNothingMovesUntilItIsAskedFor) {
  watch_.set_reduced_motion(true);
  watch_.enter(three());
  EXPECT_EQ(events(), std::vector{StageEvent::watch_paused});
  EXPECT_FALSE(watch_.is_playing());
  clock_.advance(milliseconds{5000});
  watch_.advance();
  EXPECT_EQ(ink(), std::vector<double>(3, 0.0));
  watch_.set_playing(true);
  clock_.advance(milliseconds{1000});
  watch_.advance();
  EXPECT_GT(tablet_.overlay().groove_ink[0], 0);
}

TEST_F(WatchStageTest, PlayingAgainAtTheEndStartsFromTheBeginning) {
  watch_.enter(three());
  play(60);
  (void)events();
  watch_.set_playing(true);
  EXPECT_EQ(ink(), std::vector<double>(3, 0.0));
  play(60);
  EXPECT_EQ(events().size(), 4U);
}

TEST_F(WatchStageTest, NamesTheTypeOfAStrokeWhereTheCharacterIsKnown) {
  const auto subject = character(U'休');
  watch_.enter(subject);
  play(60);
  ASSERT_EQ(reports_.size(), 7U);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(reports_[i].type, subject.sheet->character.strokes[i].type);
  EXPECT_FALSE(reports_[0].type.empty());
}

TEST_F(WatchStageTest, ATabletWithoutStrokesOrNoneDoesNotPlay) {
  watch_.enter({});
  EXPECT_FALSE(watch_.is_playing());
  EXPECT_EQ(watch_.current_stroke(), 0);
  watch_.step(+1);
  watch_.advance();
  EXPECT_TRUE(results_.empty());
}

TEST_F(WatchStageTest, LeavingStopsTheBrushAndTakesItAway) {
  watch_.enter(three());
  clock_.advance(milliseconds{700});
  watch_.advance();
  watch_.leave();
  EXPECT_FALSE(watch_.is_playing());
  EXPECT_EQ(ink(), std::vector<double>(3, 0.0)) << "the learner's own ink";
}

}  // namespace
}  // namespace nazori::practice
