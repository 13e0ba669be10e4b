// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/guided_stage.h"

#include "stage_under_test.h"

namespace nazori::practice {
namespace {

using Guide = GuidedStage::Guide;
using study::MissReply;

class GuidedStageTest : public StageTest {
 protected:
  GuidedStageTest() { listen(guided_); }
  void write_all() {
    for (int n = 1; n <= 3; ++n) hand_.write(line(subject_, n));
  }

  StageSubject subject_ = three();
  GuidedStage guided_{tablet_};
};

TEST_F(GuidedStageTest, HelpFadesWithEachTimeWithoutAMistakeAndThenThereIsNone) {
  guided_.enter(subject_);
  EXPECT_EQ(last().event, StageEvent::follow_hidden);
  const double lines[] = {0.45, 0.2, 0.0, 0.0};
  const double pull[] = {1.0, 0.6, 0.3, 0.0};
  for (int time = 0; time < 4; ++time) {
    const auto overlay = tablet_.overlay();
    EXPECT_DOUBLE_EQ(overlay.lines_opacity, lines[time]);
    EXPECT_EQ(overlay.numbers_visible, time == 0);
    EXPECT_EQ(overlay.arrows_visible, time < 2);
    EXPECT_EQ(tablet_.snapping_in_effect(), time < 3);
    EXPECT_DOUBLE_EQ(tablet_.guides()->snapping_strength, pull[time]);
    write_all();
    EXPECT_EQ(last().event, time < 2 ? StageEvent::guided_less_help : StageEvent::guided_without_help);
    EXPECT_EQ(guided_.successes(), time + 1);
  }
  EXPECT_TRUE(results_.empty()) << "outside of a lesson nothing is finished";
}

TEST_F(GuidedStageTest, WithAMistakeHelpStaysAsItWas) {
  guided_.enter(subject_);
  hand_.write(line(subject_, 2));
  hand_.write(line(subject_, 1));
  hand_.write(line(subject_, 3));
  EXPECT_EQ(last().event, StageEvent::guided_with_mistakes);
  EXPECT_EQ(last().tone, Tone::advice);
  EXPECT_EQ(guided_.successes(), 0);
}

TEST_F(GuidedStageTest, ALessonDecidesTheHelpAndHearsHowItWent) {
  guided_.set_help(0.4);
  guided_.enter(subject_);
  EXPECT_DOUBLE_EQ(tablet_.overlay().lines_opacity, 0.45 * 0.4);
  EXPECT_FALSE(tablet_.overlay().numbers_visible);
  write_all();
  EXPECT_EQ(last().event, StageEvent::guided_without_mistake);
  ASSERT_EQ(results_.size(), 1U);
  EXPECT_DOUBLE_EQ(results_[0].help, 0.4);
  guided_.start_over();
  hand_.write(line(subject_, 2));
  hand_.write(line(subject_, 1));
  hand_.write(line(subject_, 3));
  EXPECT_EQ(last().event, StageEvent::lesson_with_mistakes);
  EXPECT_EQ(results_.size(), 2U);
}

TEST_F(GuidedStageTest, WithMuchHelpNumbersAreShownWithLittleNot) {
  guided_.set_help(0.51);
  guided_.enter(subject_);
  EXPECT_TRUE(tablet_.overlay().numbers_visible);
  guided_.set_help(0.5);
  guided_.enter(subject_);
  EXPECT_FALSE(tablet_.overlay().numbers_visible);
  guided_.set_help(0.0);
  guided_.enter(subject_);
  EXPECT_FALSE(tablet_.snapping_in_effect());
  EXPECT_FALSE(tablet_.overlay().strokes_visible);
}

TEST_F(GuidedStageTest, OnlyTheStartingPointsLieOnABlankTabletAndTheWritingIsShown) {
  guided_.set_guide(Guide::starting_points);
  EXPECT_TRUE(reports_.empty()) << "it is not entered";
  guided_.enter(subject_);
  EXPECT_EQ(last().event, StageEvent::write_from_starts);
  EXPECT_NE(tablet_.tablet(), subject_.tablet);
  EXPECT_EQ(tablet_.stroke_count(), 3);
  EXPECT_TRUE(tablet_.overlay().numbers_visible);
  hand_.write(line(subject_, 1));
  EXPECT_EQ(tablet_.overlay().writing.size(), 1U);
  hand_.write(line(subject_, 2));
  EXPECT_EQ(tablet_.overlay().writing.size(), 2U);
  tablet_.eraser_used();
  EXPECT_EQ(tablet_.overlay().writing.size(), 1U);
  guided_.leave();
  EXPECT_TRUE(tablet_.overlay().writing.empty());
}

TEST_F(GuidedStageTest, LeadingIsSaidToBeMissingWhereTheDeviceHasNoForce) {
  guided_.enter(subject_);
  EXPECT_EQ(last().leading, Leading::none);
  guided_.set_leading(true);
  EXPECT_EQ(last().leading, Leading::missing);
  EXPECT_TRUE(guided_.leading());
}

TEST_F(GuidedStageTest, TooManyMistakesInALessonShowTheStrokeWithAllItsHelp) {
  guided_.set_help(0.0);
  guided_.set_on_mistake([](int stroke) {
    EXPECT_EQ(stroke, 0);
    return MissReply::show;
  });
  guided_.enter(subject_);
  hand_.write(reversed(line(subject_, 1)));
  EXPECT_EQ(reports_[1].event, StageEvent::stroke_shown_alone);
  EXPECT_EQ(reports_[1].stroke, 1);
  EXPECT_EQ(tablet_.current_stroke(), 1);
  EXPECT_TRUE(tablet_.overlay().numbers_visible);
  EXPECT_DOUBLE_EQ(tablet_.overlay().lines_opacity, 1);
  hand_.write(line(subject_, 1));
  EXPECT_EQ(tablet_.current_stroke(), 0);
  EXPECT_FALSE(tablet_.overlay().numbers_visible);
}

TEST_F(GuidedStageTest, ThatTheDeviceGivesWayIsReportedOnceEachTime) {
  guided_.enter(subject_);
  (void)events();
  const auto resisted = static_cast<std::uint16_t>(haptics::ServoEvent::resisted);
  for (int i = 0; i < 3; ++i) hand_.sample({0, 0.08}, false, resisted);
  EXPECT_EQ(events(), std::vector{StageEvent::gives_way});
  guided_.start_over();
  (void)events();
  hand_.sample({0, 0.08}, false, resisted);
  EXPECT_EQ(events(), std::vector{StageEvent::gives_way});
}

TEST_F(GuidedStageTest, AnotherCharacterStartsWithAllHelpTheSameGoesOn) {
  const auto rest = character(U'三');
  guided_.enter(rest);
  for (int n = 1; n <= 3; ++n) hand_.write(line(rest, n));
  ASSERT_EQ(guided_.successes(), 1);
  guided_.leave();
  guided_.enter(rest);
  EXPECT_EQ(guided_.successes(), 1);
  EXPECT_EQ(last().count, 1);
  guided_.enter(character(U'二'));
  EXPECT_EQ(guided_.successes(), 0);
}

}  // namespace
}  // namespace nazori::practice
