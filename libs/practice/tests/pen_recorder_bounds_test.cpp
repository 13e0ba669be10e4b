// SPDX-License-Identifier: Apache-2.0
// What of the hand's way becomes ink, to the tenth of a millimetre.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nazori/practice/pen_recorder.h"

namespace nazori::practice {
namespace {

using Event = PenRecorder::Event;

haptics::ServoSample sample(double time_s, double x_m, double depth_m = 0.006, bool touching = true) {
  haptics::ServoSample s;
  s.time_s = time_s;
  s.proxy_m = {x_m, 0, 0};
  s.device_m = {x_m, 0, -depth_m};
  s.touching = touching;
  return s;
}
haptics::ServoSample up(double time_s) { return sample(time_s, 0, 0, false); }

TEST(PenRecorderBounds, AStrokeBeginsWithinEightTenthsOfAMillimetreOfThePress) {
  PenRecorder recorder;
  recorder.press_at({0.02, 0});
  EXPECT_EQ(recorder.follow(sample(0, 0.0190)), Event::none);
  EXPECT_EQ(recorder.follow(sample(0.1, 0.0193)), Event::grew);
  EXPECT_EQ(recorder.follow(sample(0.2, 0.0100)), Event::grew) << "it has arrived";
}

TEST(PenRecorderBounds, AStylusThatTurnsAwayAfterItsNearestPointHasArrived) {
  PenRecorder recorder;
  recorder.press_at({0.02, 0.005});
  EXPECT_EQ(recorder.follow(sample(0, 0.0200)), Event::none) << "5 mm away";
  EXPECT_EQ(recorder.follow(sample(0.1, 0.0212)), Event::none) << "0.14 mm further";
  EXPECT_EQ(recorder.follow(sample(0.2, 0.0217)), Event::grew) << "0.28 mm further";
}

TEST(PenRecorderBounds, WhoLiftsBeforeTheStylusArrivedOnlySlipped) {
  PenRecorder recorder;
  recorder.press_at({0.02, 0});
  EXPECT_EQ(recorder.follow(sample(0, 0.005)), Event::none);
  EXPECT_EQ(recorder.follow(up(0.1)), Event::slip);
  EXPECT_EQ(recorder.follow(sample(0.2, -0.04)), Event::grew) << "the press is forgotten";
}

TEST(PenRecorderBounds, ThePlaceOfAPressIsForgottenOnlyByALift) {
  PenRecorder recorder;
  recorder.press_at({0.02, 0});
  EXPECT_EQ(recorder.follow(up(0)), Event::none) << "the hand was quicker than the stylus";
  EXPECT_EQ(recorder.follow(sample(0.1, 0.005)), Event::none) << "still on its way";
  EXPECT_EQ(recorder.follow(sample(0.2, 0.02)), Event::grew);
}

TEST(PenRecorderBounds, PointsLieThreeTenthsOfAMillimetreApart) {
  PenRecorder recorder;
  recorder.follow(sample(0, 0));
  EXPECT_EQ(recorder.follow(sample(0.1, PenRecorder::kStep_m - 1e-5)), Event::none);
  EXPECT_EQ(recorder.follow(sample(0.2, PenRecorder::kStep_m + 1e-5)), Event::grew);
  EXPECT_EQ(recorder.current().size(), 2U);
}

TEST(PenRecorderBounds, ATouchShorterThanASlipIsNoStroke) {
  for (const double way_m : {PenRecorder::kSlip_m - 1e-5, PenRecorder::kSlip_m + 1e-5}) {
    PenRecorder recorder;
    recorder.follow(sample(0, 0));
    recorder.follow(sample(0.1, way_m / 2));
    recorder.follow(sample(0.2, way_m));
    const bool is_stroke = way_m > PenRecorder::kSlip_m;
    EXPECT_EQ(recorder.follow(up(0.3)), is_stroke ? Event::ended : Event::slip);
    EXPECT_EQ(recorder.take().size(), is_stroke ? 3U : 0U);
  }
}

TEST(PenRecorderBounds, WhereThePenRestsItsFirmestPressCounts) {
  PenRecorder recorder(0.010);
  recorder.follow(sample(0, 0, 0.004));
  recorder.follow(sample(0.1, 0, 0.008));
  recorder.follow(sample(0.2, 0, 0.002));
  ASSERT_EQ(recorder.current().size(), 1U);
  EXPECT_DOUBLE_EQ(recorder.current()[0].pressure, 0.8);
  EXPECT_DOUBLE_EQ(recorder.current()[0].time_s, 0);
}

TEST(PenRecorderBounds, ThePressureAtTheLiftIsThatOfTheLastMoment) {
  PenRecorder recorder(0.010);
  recorder.lean(0.25);
  recorder.follow(sample(0, 0, 0.004));
  recorder.follow(sample(0.1, 0.002, 0.004));
  recorder.lean(0.5);
  recorder.follow(sample(0.2, 0.002, 0.002));
  ASSERT_EQ(recorder.follow(up(0.3)), Event::ended);
  const HandStroke stroke = recorder.take();
  ASSERT_EQ(stroke.size(), 3U);
  EXPECT_DOUBLE_EQ(stroke[1].lean_rad, 0.25);
  EXPECT_DOUBLE_EQ(stroke[2].time_s, 0.2);
  EXPECT_DOUBLE_EQ(stroke[2].pressure, 0.2);
  EXPECT_DOUBLE_EQ(stroke[2].lean_rad, 0.5);
}

TEST(PenRecorderBounds, PressureIsNeverLessThanNone) {
  PenRecorder recorder;
  recorder.follow(sample(0, 0, -0.01));
  EXPECT_EQ(recorder.current()[0].pressure, 0);
}

TEST(PenRecorderBounds, DroppedWithThePenUpTheNextTouchIsAStroke) {
  PenRecorder recorder;
  recorder.follow(sample(0, 0));
  recorder.follow(up(0.1));
  recorder.drop();
  EXPECT_EQ(recorder.follow(sample(0.2, 0)), Event::grew);
}

TEST(PenRecorderBounds, WithThePenUpNothingHappens) {
  PenRecorder recorder;
  EXPECT_EQ(recorder.follow(up(0)), Event::none);
  EXPECT_EQ(recorder.follow(up(1)), Event::none);
}

TEST(PenRecorderBounds, AStrokeUntilTheTimeOfAPointHoldsThatPoint) {
  const HandStroke stroke{{{0, 0}, 1, 0.2, 0.1}, {{0.01, 0.04}, 2, 0.4, 0.5}};
  ASSERT_FALSE(until(stroke, 1).empty());
  EXPECT_EQ(until(stroke, 1).back().at, stroke[0].at);
  EXPECT_EQ(until(stroke, 2).size(), 2U);
  const auto part = until(stroke, 1.25);
  ASSERT_EQ(part.size(), 2U);
  EXPECT_DOUBLE_EQ(part[1].at.x, 0.0025);
  EXPECT_DOUBLE_EQ(part[1].at.y, 0.01);
  EXPECT_DOUBLE_EQ(part[1].time_s, 1.25);
  EXPECT_DOUBLE_EQ(part[1].pressure, 0.25);
  EXPECT_DOUBLE_EQ(part[1].lean_rad, 0.2);
}

TEST(PenRecorderBounds, InkIsWiderForAFirmerPressAndABrushOnItsSide) {
  const auto width = [](double pressure, double lean_rad) {
    return ink_half_width_m({{0, 0}, 0, pressure, lean_rad});
  };
  EXPECT_GT(width(0, 0), 0);
  EXPECT_NEAR(width(0.5, 0), (width(0, 0) + width(1, 0)) / 2, 1e-12);
  EXPECT_GT(width(1, 0), 3 * width(0, 0));
  EXPECT_EQ(width(2, 0), width(1, 0));
  EXPECT_EQ(width(-1, 0), width(0, 0));
  const double flat = std::numbers::pi / 2;
  EXPECT_GT(width(0.5, flat), 1.3 * width(0.5, 0));
  EXPECT_LT(width(0.5, flat), 2 * width(0.5, 0));
  EXPECT_NEAR(width(1, flat) / width(1, 0), width(0, flat) / width(0, 0), 1e-12);
}

TEST(PenRecorderBounds, WrittenInkHasThePlacesTheWidthsAndTheVerdict) {
  const HandStroke stroke{{{0, 0}, 1, 0.2}, {{0.01, 0}, 2, 0.4}, {{0.01, 0}, 3, 0.1}};
  const auto written = to_written(stroke, view::Verdict::nearly);
  EXPECT_EQ(written.verdict, view::Verdict::nearly);
  ASSERT_EQ(written.points.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(written.points[i].at, stroke[i].at);
    EXPECT_EQ(written.points[i].half_width_m, ink_half_width_m(stroke[i]));
  }
}

}  // namespace
}  // namespace nazori::practice
