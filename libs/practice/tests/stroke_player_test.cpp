// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/stroke_player.h"

#include <gtest/gtest.h>

#include <cmath>

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
