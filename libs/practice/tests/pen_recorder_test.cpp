// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/pen_recorder.h"

#include <gtest/gtest.h>

namespace {

using nazori::haptics::ServoSample;
using nazori::practice::PenRecorder;
using Event = PenRecorder::Event;

ServoSample sample(double time_s, double x_m, double depth_m, bool touching = true) {
  ServoSample s;
  s.time_s = time_s;
  s.proxy_m = {x_m, 0, 0};
  s.device_m = {x_m, 0, -depth_m};
  s.touching = touching;
  return s;
}

TEST(PenRecorder, OneStrokeIsFromTheTouchToTheLift) {
  PenRecorder recorder;
  EXPECT_EQ(recorder.follow(sample(0, 0, 0, false)), Event::none);
  for (int i = 0; i <= 20; ++i) EXPECT_EQ(recorder.follow(sample(i * 0.01, i * 0.001, 0.006)), Event::grew);
  EXPECT_EQ(recorder.follow(sample(0.3, 0.02, 0, false)), Event::ended);
  const auto stroke = recorder.take();
  ASSERT_EQ(stroke.size(), 21U);
  EXPECT_DOUBLE_EQ(stroke.front().at.x, 0);
  EXPECT_DOUBLE_EQ(stroke.back().at.x, 0.02);
  EXPECT_DOUBLE_EQ(stroke.back().time_s, 0.2);
  EXPECT_TRUE(recorder.current().empty());
}

TEST(PenRecorder, PressureIsHowDeepTheHandPushesOfFullPress) {
  PenRecorder recorder(0.010);
  recorder.follow(sample(0, 0, 0.0025));
  recorder.follow(sample(0.1, 0.001, 0.005));
  recorder.follow(sample(0.2, 0.002, 0.050));
  EXPECT_DOUBLE_EQ(recorder.current()[0].pressure, 0.25);
  EXPECT_DOUBLE_EQ(recorder.current()[1].pressure, 0.5);
  EXPECT_DOUBLE_EQ(recorder.current()[2].pressure, 1.0);
}

TEST(PenRecorder, ARestingPenAddsNoPointsAndATapIsNoStroke) {
  PenRecorder recorder;
  recorder.follow(sample(0, 0, 0.001));
  for (int i = 1; i < 100; ++i) EXPECT_EQ(recorder.follow(sample(i * 0.001, 1e-5, 0.001)), Event::none);
  EXPECT_EQ(recorder.current().size(), 1U);
  EXPECT_EQ(recorder.follow(sample(0.2, 0, 0, false)), Event::slip);
}

TEST(PenRecorder, HowLongThePenRestedBeforeTheLiftIsKept) {
  PenRecorder recorder;
  for (int i = 0; i <= 10; ++i) recorder.follow(sample(i * 0.01, i * 0.001, 0.006));
  recorder.follow(sample(0.4, 0.01, 0.006));
  EXPECT_EQ(recorder.follow(sample(0.41, 0.01, 0, false)), Event::ended);
  const auto stroke = recorder.take();
  ASSERT_EQ(stroke.size(), 12U);
  EXPECT_DOUBLE_EQ(stroke.back().time_s, 0.4);
  EXPECT_DOUBLE_EQ(stroke.back().at.x, 0.01);
  EXPECT_EQ(nazori::practice::to_written(stroke, nazori::view::Verdict::none).points.size(), 11U)
      << "rest draws nothing";
}

TEST(PenRecorder, ATickThatComesTooLateDoesNotCutAStrokeInTwo) {
  PenRecorder recorder;
  for (int i = 0; i <= 10; ++i) recorder.follow(sample(i * 0.01, i * 0.001, 0.006));
  ServoSample late = sample(0.2, 0.011, 0.006, false);
  late.events = static_cast<std::uint16_t>(nazori::haptics::ServoEvent::fault);
  EXPECT_EQ(recorder.follow(late), Event::none);
  for (int i = 11; i <= 20; ++i)
    EXPECT_EQ(recorder.follow(sample(0.1 + i * 0.01, i * 0.001, 0.006)), Event::grew);
  EXPECT_EQ(recorder.follow(sample(0.4, 0.02, 0, false)), Event::ended);
  EXPECT_DOUBLE_EQ(recorder.take().front().at.x, 0);
}

TEST(PenRecorder, AStrokeUntilAMomentEndsWhereThePenWas) {
  const nazori::practice::HandStroke stroke{{{0, 0}, 1, 0.2}, {{0.01, 0}, 2, 0.4}, {{0.01, 0.02}, 3, 0.4}};
  EXPECT_TRUE(nazori::practice::until(stroke, 0.5).empty());
  const auto part = nazori::practice::until(stroke, 1.5);
  ASSERT_EQ(part.size(), 2U);
  EXPECT_DOUBLE_EQ(part.back().at.x, 0.005);
  EXPECT_DOUBLE_EQ(part.back().pressure, 0.3);
  EXPECT_EQ(nazori::practice::until(stroke, 9).size(), 3U);
}

TEST(PenRecorder, WhatIsDroppedDoesNotComeBackWhenThePenIsLifted) {
  PenRecorder recorder;
  for (int i = 0; i <= 10; ++i) recorder.follow(sample(i * 0.01, i * 0.001, 0.006));
  recorder.drop();
  EXPECT_EQ(recorder.follow(sample(0.2, 0.02, 0.006)), Event::none);
  EXPECT_EQ(recorder.follow(sample(0.3, 0.02, 0, false)), Event::none);
  EXPECT_EQ(recorder.follow(sample(0.4, 0.03, 0.006)), Event::grew) << "the next touch is a new stroke";
}

TEST(PenRecorder, TheWayOfTheStylusToWhereTheHandPressedIsNotWritten) {
  PenRecorder recorder;
  recorder.press_at({0.02, 0});
  for (int i = 0; i <= 40; ++i) recorder.follow(sample(i * 0.001, i * 0.001, 0.006));
  EXPECT_GE(recorder.current().front().at.x, 0.019);
  EXPECT_NEAR(recorder.current().back().at.x, 0.04, 1e-9);
}

TEST(PenRecorder, AHandThatMovedOnBeforeTheStylusArrivedLosesNoMoreThanTheWayThere) {
  PenRecorder recorder;
  recorder.press_at({0.02, 0.005});  // the stylus passes 5 mm beside it
  for (int i = 0; i <= 40; ++i) recorder.follow(sample(i * 0.001, i * 0.001, 0.006));
  EXPECT_NEAR(recorder.current().front().at.x, 0.022, 0.002);
}

TEST(PenRecorder, InkForTheJudgeLiesInTheGlyphFrameWithTheTabletAsItsBox) {
  const nazori::geometry::TabletShape shape;
  const auto ink = nazori::practice::to_ink({{{{-0.05, 0.05}, 0, 0.5}, {{0.05, -0.05}, 1, 0.7}}}, shape);
  ASSERT_EQ(ink.strokes.size(), 1U);
  EXPECT_NEAR(ink.strokes[0].points[0].x, 0, 1e-9);
  EXPECT_NEAR(ink.strokes[0].points[0].y, 0, 1e-9);
  EXPECT_NEAR(ink.strokes[0].points[1].x, 109, 1e-9);
  EXPECT_NEAR(ink.strokes[0].points[1].y, 109, 1e-9);
  EXPECT_EQ(ink.strokes[0].times_s.size(), 2U);
  EXPECT_EQ(ink.strokes[0].pressures, (std::vector{0.5, 0.7}));
  EXPECT_DOUBLE_EQ(ink.box->side, 109);
}

}  // namespace
