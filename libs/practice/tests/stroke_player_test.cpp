// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/stroke_player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "nazori/geometry/polyline.h"

namespace {

using nazori::haptics::StrokePath;
using nazori::haptics::Vec3;
using nazori::kanji::StrokeEnding;
using nazori::practice::StrokePlayer;
using nazori::tablet::TabletLine;

StrokePlayer player(const std::vector<std::vector<Vec3>>& points, std::vector<StrokeEnding> endings) {
  std::vector<StrokePath> paths;
  std::vector<TabletLine> lines;
  for (std::size_t i = 0; i < points.size(); ++i) {
    paths.push_back({points[i]});
    lines.emplace_back().ending = endings[i];
  }
  StrokePlayer made;
  made.set_strokes(paths, lines);
  return made;
}

/// Speed of the brush in the plane where it has covered this share of stroke 1 [m/s].
double speed_at(const StrokePlayer& player, double share, double length_m) {
  constexpr double kStep_s = 0.001;
  for (double t = player.start_s(1); t < player.end_s(1); t += kStep_s)
    if (player.share_at(1, t) >= share)
      return (player.share_at(1, t + kStep_s) - player.share_at(1, t)) * length_m / kStep_s;
  return -1;
}

const std::vector<Vec3> kLevel{{-0.03, 0, -0.01}, {0.03, 0, -0.01}};

TEST(StrokePlayer, TheBrushStartsSlowlyAndSlowsDownToAStop) {
  const auto brush = player({kLevel}, {StrokeEnding::stop});
  const double middle = speed_at(brush, 0.5, 0.06);
  EXPECT_NEAR(middle, StrokePlayer::kSpeed_m_s, 0.002);
  EXPECT_LT(speed_at(brush, 0.02, 0.06), middle / 2);
  EXPECT_LT(speed_at(brush, 0.98, 0.06), middle / 2);
}

TEST(StrokePlayer, ASweepIsLiftedWhileItMoves) {
  const auto brush = player({kLevel}, {StrokeEnding::taper});
  EXPECT_GE(speed_at(brush, 0.97, 0.06), speed_at(brush, 0.5, 0.06));
}

TEST(StrokePlayer, TheBrushSlowsDownAtACornerAndBeforeAKick) {
  // Across, then down.
  const auto corner = player({{{-0.02, 0.02, 0}, {0.02, 0.02, 0}, {0.02, -0.02, 0}}}, {StrokeEnding::stop});
  EXPECT_LT(speed_at(corner, 0.5, 0.08), speed_at(corner, 0.25, 0.08) / 2);
  // Down, then a short hook to the upper left.
  const auto kick = player({{{0, 0.02, 0}, {0, -0.02, 0}, {-0.005, -0.015, 0}}}, {StrokeEnding::hook});
  const double length_m = 0.04 + std::hypot(0.005, 0.005);
  EXPECT_LT(speed_at(kick, 0.04 / length_m, length_m), speed_at(kick, 0.5, length_m) / 2);
}

TEST(StrokePlayer, BetweenTwoStrokesTheBrushIsLiftedAndMovesToTheNext) {
  const std::vector<Vec3> below{{-0.03, -0.02, -0.01}, {0.03, -0.02, -0.01}};
  const auto brush = player({kLevel, below}, {StrokeEnding::stop, StrokeEnding::stop});
  EXPECT_GT(brush.start_s(2), brush.end_s(1));
  const auto between = brush.at((brush.end_s(1) + brush.start_s(2)) / 2);
  EXPECT_FALSE(between.writing);
  EXPECT_EQ(between.stroke, 2);
  EXPECT_GT(between.tip_m.z, -0.005);
  EXPECT_TRUE(brush.at(brush.start_s(2) + 0.01).writing);
  EXPECT_NEAR(brush.at(brush.start_s(2)).tip_m.x, -0.03, 1e-6);
}

/// The time of a straight stroke: half a millimetre at a time, at the speed of its middle. The brush gains
/// speed over 7 mm from 22 % on, and loses it so before a stop; a sweep ends at 115 %.
double straight_s(double length_m, bool stops) {
  double sum = 0;
  const int pieces = static_cast<int>(std::lround(length_m / 0.0005));
  for (int i = 0; i < pieces; ++i) {
    const double at_m = (i + 0.5) * length_m / pieces;
    const double left_m = length_m - at_m;
    double pace = std::min(1.0, 0.22 + 0.78 * at_m / 0.007);
    if (stops)
      pace = std::min(pace, 0.22 + 0.78 * left_m / 0.007);
    else if (left_m < 0.007)
      pace = std::min(2 * pace, 1.15);
    sum += length_m / pieces / (0.055 * pace);
  }
  return sum;
}

TEST(StrokePlayer, ItsTimesAreThoseOfItsSpeedsAndPauses) {
  const std::vector<Vec3> far{{-0.03, -0.05, -0.01}, {-0.01, -0.05, -0.01}};
  const std::vector<Vec3> near{{-0.01, -0.04, -0.01}, {0.03, -0.04, -0.01}};
  for (const auto ending :
       {StrokeEnding::stop, StrokeEnding::either, StrokeEnding::taper, StrokeEnding::hook}) {
    const bool stops = ending == StrokeEnding::stop || ending == StrokeEnding::either;
    const auto brush = player({kLevel, far, near}, {ending, StrokeEnding::stop, StrokeEnding::stop});
    EXPECT_NEAR(brush.start_s(1), 0.28, 1e-12);
    EXPECT_NEAR(brush.end_s(1), 0.28 + 0.14 + straight_s(0.06, stops), 1e-9);
    // The way in the air is at 120 mm/s, and at least 0.28 s; before it a stroke that stops is held.
    const double way_m = std::hypot(0.06, 0.05);
    EXPECT_NEAR(brush.start_s(2) - brush.end_s(1), (stops ? 0.16 : 0) + way_m / 0.12, 1e-9);
    EXPECT_NEAR(brush.end_s(2) - brush.start_s(2), 0.14 + straight_s(0.02, true), 1e-9);
    EXPECT_NEAR(brush.start_s(3) - brush.end_s(2), 0.16 + 0.28, 1e-9);
    EXPECT_NEAR(brush.duration_s(), brush.end_s(3) + 0.28, 1e-12);
  }
}

TEST(StrokePlayer, ARightAngleIsTheSlowestPlaceWithinTwoMillimetres) {
  const auto corner = player({{{-0.02, 0.02, 0}, {0.02, 0.02, 0}, {0.02, -0.02, 0}}}, {StrokeEnding::stop});
  const auto speed = [&](double at_m) { return speed_at(corner, at_m / 0.08, 0.08); };
  EXPECT_NEAR(speed(0.0397), 0.055 * 0.22, 2e-4);
  EXPECT_NEAR(speed(0.0375), 0.055, 2e-4);
  EXPECT_NEAR(speed(0.0425), 0.055, 2e-4);
}

TEST(StrokePlayer, InTheAirTheBrushMovesOnArcs) {
  const std::vector<Vec3> below{{-0.03, -0.02, -0.004}, {0.03, -0.02, -0.01}};
  const auto brush = player({kLevel, below}, {StrokeEnding::stop, StrokeEnding::stop});
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  const auto expect_tip = [&](double time_s, const Vec3& tip_m, int stroke) {
    const auto pose = brush.at(time_s);
    EXPECT_NEAR(pose.tip_m.x, tip_m.x, 1e-12) << time_s;
    EXPECT_NEAR(pose.tip_m.y, tip_m.y, 1e-12) << time_s;
    EXPECT_NEAR(pose.tip_m.z, tip_m.z, 1e-12) << time_s;
    EXPECT_EQ(pose.stroke, stroke);
    EXPECT_FALSE(pose.writing);
  };
  for (const double t : {0.0, 0.25, 0.6}) {
    const double part = smooth(t);
    const double arc_m = 0.008 * 4 * part * (1 - part);
    expect_tip(0.28 * t, {-0.03, 0, -0.01 + 0.008 * (1 - part) + arc_m}, 1);
    EXPECT_EQ(brush.at(0.28 * t).share, 0);
    if (t == 0) continue;
    const double from_s = brush.end_s(1), to_s = brush.start_s(2);
    expect_tip(from_s + (to_s - from_s) * t, {0.03 - 0.06 * part, -0.02 * part, -0.01 + 0.006 * part + arc_m},
               2);
    // After the last stroke it is lifted straight up.
    expect_tip(brush.end_s(2) + 0.28 * t, {0.03, -0.02, -0.01 + 0.008 * t}, 2);
    EXPECT_EQ(brush.at(brush.end_s(2) + 0.28 * t).share, 1);
  }
  expect_tip(1000, {0.03, -0.02, -0.01 + 0.008}, 2);
  expect_tip(-5, {-0.03, 0, -0.01 + 0.008}, 1);
}

TEST(StrokePlayer, AStrokeWithoutPointsIsADotInTheMiddle) {
  const auto brush = player({{}, {{0.01, 0.02, 0}}}, {StrokeEnding::stop, StrokeEnding::stop});
  ASSERT_EQ(brush.stroke_count(), 2);
  EXPECT_NEAR(brush.end_s(1) - brush.start_s(1), 0.14, 1e-12);
  EXPECT_EQ(brush.share_at(1, brush.start_s(1) + 0.07), 0);
  EXPECT_EQ(brush.share_at(1, brush.end_s(1)), 1);
  EXPECT_EQ(brush.at(brush.start_s(1) + 0.07).tip_m, Vec3(0));
  EXPECT_EQ(brush.at(brush.start_s(2) + 0.07).tip_m, Vec3(0.01, 0.02, 0));
}

TEST(StrokePlayer, TheShareWrittenOnlyGrowsAndTheBrushStaysOnTheLine) {
  const auto brush = player({kLevel}, {StrokeEnding::stop});
  double last = 0;
  for (double t = 0; t <= brush.duration_s(); t += 0.01) {
    const double share = brush.share_at(1, t);
    EXPECT_GE(share, last);
    last = share;
    const auto pose = brush.at(t);
    if (pose.writing) {
      EXPECT_NEAR(pose.tip_m.x, -0.03 + 0.06 * share, 1e-6);
    }
  }
  EXPECT_DOUBLE_EQ(last, 1);
}

TEST(StrokePlayer, NoStrokesAreNoFailure) {
  StrokePlayer brush;
  EXPECT_EQ(brush.duration_s(), 0);
  EXPECT_EQ(brush.at(1).stroke, 0);
}

TEST(StrokePlayer, TheWrittenPartGrowsFromTheStartToTheWholeStroke) {
  const auto brush = player({{{-0.02, 0.02, 0}, {0.02, 0.02, 0}, {0.02, -0.02, 0}}, kLevel},
                            {StrokeEnding::stop, StrokeEnding::stop});
  EXPECT_TRUE(brush.written(1, 0).empty());
  EXPECT_TRUE(brush.written(2, brush.end_s(1)).empty()) << "not begun";
  double before_m = 0;
  for (double t = brush.start_s(1); t <= brush.end_s(1); t += 0.05) {
    const auto line = brush.written(1, t);
    if (line.empty()) continue;
    EXPECT_EQ(line.front().x, -0.02);
    const double length_m = nazori::geometry::arc_length<nazori::geometry::TabletFrame>(line);
    EXPECT_NEAR(length_m, brush.share_at(1, t) * 0.08, 1e-9);
    EXPECT_GE(length_m, before_m);
    before_m = length_m;
    const auto tip_m = brush.at(t).tip_m;
    EXPECT_NEAR(line.back().x, tip_m.x, 1e-12);
    EXPECT_NEAR(line.back().y, tip_m.y, 1e-12);
  }
  const auto whole = brush.written(1, brush.duration_s());
  EXPECT_NEAR(whole.back().x, 0.02, 1e-12);
  EXPECT_NEAR(whole.back().y, -0.02, 1e-12);
}

}  // namespace
