// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/trace_stage.h"

#include "stage_under_test.h"

namespace nazori::practice {
namespace {

using study::MissReply;

class TraceStageTest : public StageTest {
 protected:
  TraceStageTest() { listen(trace_); }
  void enter() {
    trace_.enter(subject_);
    (void)events();
  }
  void write(int stroke) { hand_.write(line(subject_, stroke)); }

  StageSubject subject_ = three();
  TraceStage trace_{tablet_};
};

TEST_F(TraceStageTest, SaysHowToBeginByWhatIsOnTheTablet) {
  trace_.enter(subject_);
  EXPECT_EQ(events(), std::vector{StageEvent::draw_from_one});
  tablet_.set_strokes_visible(false);
  trace_.enter(subject_);
  EXPECT_EQ(events(), std::vector{StageEvent::follow_groove});
  trace_.enter({});
  EXPECT_EQ(events(), std::vector{StageEvent::touch_tablet});
}

TEST_F(TraceStageTest, TheStrokeThatIsShownIsReportedInBothDirectionsAndAllOfThem) {
  enter();
  trace_.show_next_stroke();
  EXPECT_EQ(last().event, StageEvent::stroke_chosen);
  EXPECT_EQ(last().stroke, 1);
  EXPECT_EQ(last().count, 3);
  trace_.show_next_stroke();
  EXPECT_EQ(last().stroke, 2);
  trace_.show_previous_stroke();
  EXPECT_EQ(last().stroke, 1);
  trace_.show_all_strokes();
  EXPECT_EQ(events(), (std::vector{StageEvent::stroke_chosen, StageEvent::stroke_chosen,
                                   StageEvent::stroke_chosen, StageEvent::draw_from_one}));
}

TEST_F(TraceStageTest, StrokesInOrderAreReportedOneByOneAndFinishTheStage) {
  enter();
  write(1);
  EXPECT_EQ(events(), (std::vector{StageEvent::stroke_began, StageEvent::stroke_written}));
  write(2);
  ASSERT_EQ(reports_.size(), 2U);
  EXPECT_EQ(last().stroke, 2);
  EXPECT_EQ(last().other, 3);
  EXPECT_EQ(last().tone, Tone::good);
  EXPECT_TRUE(results_.empty());
  write(3);
  EXPECT_EQ(last().event, StageEvent::all_written);
  EXPECT_EQ(last().count, 3);
  EXPECT_EQ(results_.size(), 1U);
}

TEST_F(TraceStageTest, AStrokeBeforeItsTurnIsNamedWithTheOneThatComesFirst) {
  enter();
  write(2);
  ASSERT_EQ(reports_.size(), 2U);
  EXPECT_EQ(reports_[0].event, StageEvent::too_early);
  EXPECT_EQ(reports_[0].stroke, 1);
  EXPECT_EQ(reports_[0].other, 2);
  EXPECT_EQ(reports_[0].tone, Tone::advice);
  EXPECT_EQ(reports_[1].event, StageEvent::stroke_written_early);
  EXPECT_EQ(reports_[1].stroke, 2);
  EXPECT_EQ(reports_[1].other, 1);
}

TEST_F(TraceStageTest, AStrokeFromItsEndIsAdvice) {
  enter();
  hand_.write(reversed(line(subject_, 1)));
  EXPECT_EQ(reports_.front().event, StageEvent::from_the_end);
  EXPECT_EQ(reports_.front().stroke, 1);
}

TEST_F(TraceStageTest, AStrokeThatWasLeftBeforeItsEndMustBeFinishedFirst) {
  enter();
  const auto whole = line(subject_, 1);
  hand_.write({whole.front(), whole.front() + (whole.back() - whole.front()) * 0.5});
  EXPECT_EQ(last().event, StageEvent::left_open);
  (void)events();
  write(2);
  EXPECT_EQ(events(), (std::vector{StageEvent::open_stroke_first, StageEvent::stroke_written_but_open}));
}

TEST_F(TraceStageTest, InALessonTooManyMistakesShowTheStrokeAloneUntilItIsWritten) {
  std::vector<int> asked;
  trace_.set_on_mistake([&](int stroke) {
    asked.push_back(stroke);
    return asked.size() < 2 ? MissReply::try_again : MissReply::show;
  });
  enter();
  hand_.write(reversed(line(subject_, 1)));
  EXPECT_EQ(tablet_.current_stroke(), 0);
  hand_.write(reversed(line(subject_, 1)));
  EXPECT_EQ(asked, (std::vector{0, 0}));
  EXPECT_EQ(tablet_.current_stroke(), 1);
  EXPECT_EQ(last().event, StageEvent::stroke_chosen);
  write(1);
  EXPECT_EQ(tablet_.current_stroke(), 0) << "all are shown again";
}

TEST_F(TraceStageTest, OutsideOfALessonNobodyCountsMistakes) {
  enter();
  for (int i = 0; i < 5; ++i) hand_.write(reversed(line(subject_, 1)));
  EXPECT_EQ(tablet_.current_stroke(), 0);
}

TEST_F(TraceStageTest, SteppingShowsOneStrokeAloneAndReportsIt) {
  enter();
  trace_.show_next_stroke();
  EXPECT_EQ(last().event, StageEvent::stroke_chosen);
  EXPECT_EQ(last().stroke, 1);
  EXPECT_EQ(last().count, 3);
  write(1);
  EXPECT_EQ(last().event, StageEvent::stroke_written_alone);
  trace_.show_previous_stroke();
  EXPECT_EQ(last().event, StageEvent::draw_from_one) << "all are shown";
  trace_.show_previous_stroke();
  EXPECT_EQ(last().stroke, 3);
  trace_.set_strokes_visible(false);
  trace_.show_next_stroke();
  trace_.show_next_stroke();
  EXPECT_EQ(last().event, StageEvent::stroke_chosen_hidden);
  trace_.show_all_strokes();
  EXPECT_EQ(tablet_.current_stroke(), 0);
}

TEST_F(TraceStageTest, SnappingIsReportedWithWhatItNeeds) {
  enter();
  trace_.set_snapping(true);
  EXPECT_EQ(last().event, StageEvent::snapping_on);
  trace_.set_strokes_visible(false);
  EXPECT_EQ(last().event, StageEvent::snapping_needs_strokes);
  EXPECT_EQ(last().tone, Tone::advice);
  trace_.set_snapping(false);
  EXPECT_EQ(last().event, StageEvent::snapping_off);
  trace_.set_strokes_visible(true);
  EXPECT_EQ(last().event, StageEvent::draw_from_one);
}

TEST_F(TraceStageTest, TheEraserTakesTheInkOffTheLastStrokeAndClearingOffAll) {
  enter();
  write(1);
  write(2);
  tablet_.eraser_used();
  EXPECT_TRUE(tablet_.ink().is_finished(1));
  EXPECT_FALSE(tablet_.ink().is_finished(2));
  trace_.clear_ink();
  EXPECT_EQ(tablet_.ink().next_stroke(), 1);
  EXPECT_EQ(last().event, StageEvent::draw_from_one);
}

TEST_F(TraceStageTest, NothingIsReportedOnceItWasLeft) {
  enter();
  trace_.leave();
  write(1);
  tablet_.eraser_used();
  EXPECT_TRUE(reports_.empty());
  EXPECT_TRUE(tablet_.ink().is_finished(1));
}

}  // namespace
}  // namespace nazori::practice
