// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/inked_stroke.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace nazori::view {
namespace {

TEST(InkedStroke, IsWiderForAFirmerPressAndABrushOnItsSide) {
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
  EXPECT_EQ(ink_half_width_m({}), width(0, 0)) << "neither pressure nor lean is known";
}

TEST(InkedStroke, HasThePointsAndTheVerdictButNoRest) {
  const geometry::WrittenStroke<geometry::TabletFrame> stroke{
      {{0, 0}, 1, 0.2}, {{0.01, 0}, 2, 0.4}, {{0.01, 0}, 3, 0.1}};
  const auto drawn = inked(stroke, Verdict::nearly);
  EXPECT_EQ(drawn.verdict, Verdict::nearly);
  EXPECT_EQ(drawn.opacity, 1);
  EXPECT_FALSE(drawn.half_width_m) << "as wide as it was pressed";
  ASSERT_EQ(drawn.points.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(drawn.points[i], stroke[i]);
}

/// A level stroke written at these speeds, one after another [m/s].
geometry::WrittenStroke<geometry::TabletFrame> written(const std::vector<double>& speeds,
                                                       double pressure = 0.5) {
  geometry::WrittenStroke<geometry::TabletFrame> stroke{{{0, 0}, 0, pressure}};
  constexpr double kStep_m = 0.001;
  for (const double speed : speeds)
    stroke.push_back({{stroke.back().at.x + kStep_m, 0}, *stroke.back().time_s + kStep_m / speed, pressure});
  return stroke;
}

TEST(InkedStroke, AWidthIsFromFourTenthsToTwoMillimetresAndThreeFifthsMoreOnItsSide) {
  EXPECT_NEAR(ink_half_width_m({{0, 0}, {}, 0.0}), 0.0004, 1e-12);
  EXPECT_NEAR(ink_half_width_m({{0, 0}, {}, 1.0}), 0.0020, 1e-12);
  EXPECT_NEAR(ink_half_width_m({{0, 0}, {}, 0.25}), 0.0008, 1e-12);
  EXPECT_NEAR(ink_half_width_m({{0, 0}, {}, 0.25, std::numbers::pi / 2}), 0.0008 * 1.6, 1e-12);
  EXPECT_NEAR(ink_half_width_m({{0, 0}, {}, 0.25, std::numbers::pi / 6}), 0.0008 * 1.3, 1e-12);
}

TEST(InkedStroke, OneWidthForAllComesBeforeThoseOfThePointsAndThoseBeforeThePress) {
  InkedStroke stroke;
  stroke.points = {{{0, 0}, {}, 0.0}, {{0.01, 0}, {}, 1.0}};
  EXPECT_NEAR(stroke.half_width_at(0), 0.0004, 1e-12);
  EXPECT_NEAR(stroke.half_width_at(1), 0.0020, 1e-12);
  stroke.half_widths_m = {0.005};
  EXPECT_EQ(stroke.half_width_at(0), 0.005);
  EXPECT_NEAR(stroke.half_width_at(1), 0.0020, 1e-12) << "there is none for it";
  stroke.half_width_m = 0.007;
  EXPECT_EQ(stroke.half_width_at(0), 0.007);
  EXPECT_EQ(stroke.half_width_at(1), 0.007);
}

/// Half of 1.8 mm, and 0.55 of the pressed width.
constexpr double half_brush(double pressed_m) { return 0.0009 + 0.55 * pressed_m; }

TEST(InkedStroke, WithoutTimesTheBrushOpensOverTwoAndAHalfMillimetresFromThreeFifths) {
  geometry::WrittenStroke<geometry::TabletFrame> stroke;
  for (int i = 0; i <= 8; ++i) stroke.push_back({{0.0005 * i, 0}, {}, 0.5});
  const auto drawn = inked(stroke, Verdict::none);
  ASSERT_EQ(drawn.half_widths_m.size(), 9U);
  // A hand of the mean speed: 1.12 less 0.17 times 0.7.
  constexpr double kUsual = 1.12 - 0.17 * 0.7;
  for (std::size_t i = 0; i < 9; ++i) {
    const double opened = std::min(1.0, 0.6 + 0.4 * static_cast<double>(i) / 5);
    EXPECT_NEAR(drawn.half_widths_m[i], kUsual * opened * half_brush(0.0012), 1e-12) << i;
  }
}

TEST(InkedStroke, TheWidthFollowsTheSpeedOnSixMillimetresWithinItsBounds) {
  // First slowly, then twenty times as fast.
  std::vector<double> speeds(30, 0.02);
  speeds.resize(90, 0.4);
  const auto stroke = written(speeds);
  const auto drawn = inked(stroke, Verdict::none, false);
  const double mean = 0.09 / (*stroke.back().time_s - *stroke.front().time_s);
  double speed = 1;
  for (std::size_t i = 0; i <= 90; ++i) {
    if (i > 0) speed += (1 - std::exp(-1.0 / 6)) * (std::min(speeds[i - 1] / mean, 3.0) - speed);
    const double width = std::clamp(1.12 - 0.17 * (speed - 0.3), 0.78, 1.12);
    const double opened = std::min(1.0, 0.6 + 0.4 * static_cast<double>(i) / 2.5);
    EXPECT_NEAR(drawn.half_widths_m[i], width * opened * half_brush(0.0012), 1e-9) << i;
  }
  EXPECT_NEAR(drawn.half_widths_m[90], 0.78 * half_brush(0.0012), 2e-5) << "no thinner";
  // A rest in the middle makes a stroke as broad as it can be.
  auto rested = written(std::vector<double>(60, 0.05));
  for (std::size_t i = 30; i < rested.size(); ++i) *rested[i].time_s += 1000;
  EXPECT_NEAR(inked(rested, Verdict::none, false).half_widths_m[20], 0.78 * half_brush(0.0012), 1e-4);
}

TEST(InkedStroke, ASweepThinsOutOnTheLastThirdOrTwelveMillimetresToAnEighth) {
  for (const int length_mm : {20, 80}) {
    const auto drawn =
        inked(written(std::vector<double>(static_cast<std::size_t>(length_mm), 0.05)), Verdict::none);
    const double sweep_mm = std::min(0.35 * length_mm, 12.0);
    constexpr double kUsual = 1.12 - 0.17 * 0.7;
    for (int i = 3; i <= length_mm; ++i) {
      const double left_mm = length_mm - i;
      const double thinned = left_mm < sweep_mm ? 0.12 + 0.88 * left_mm / sweep_mm : 1;
      EXPECT_NEAR(drawn.half_widths_m[static_cast<std::size_t>(i)], kUsual * thinned * half_brush(0.0012),
                  1e-8)
          << length_mm << ' ' << i;
    }
  }
}

TEST(InkedStroke, IsSweptWhereTheLastSixHundredthsOfASecondAreFasterThanThreeFifthsOfTheMean) {
  const auto is_swept = [](double end_speed) {
    std::vector<double> speeds(60, 0.05);
    // 0.06 s at the end, and the mean hardly changed.
    speeds.resize(60 + static_cast<std::size_t>(std::lround(0.06 * end_speed / 0.001)), end_speed);
    const auto stroke = written(speeds);
    return inked(stroke, Verdict::none).half_widths_m.back() < 0.0006;
  };
  EXPECT_TRUE(is_swept(0.05));
  EXPECT_TRUE(is_swept(0.0334));
  EXPECT_FALSE(is_swept(0.0167));
  // One that was written in no time is not.
  auto still = written(std::vector<double>(10, 0.05));
  for (auto& point : still) point.time_s = 1;
  EXPECT_GT(inked(still, Verdict::none).half_widths_m.back(), 0.001);
}

TEST(InkedStroke, OpensWhereTheBrushComesDownAndIsThinnerWhereTheHandIsFast) {
  std::vector<double> speeds(40, 0.05);
  std::fill(speeds.begin() + 20, speeds.begin() + 30, 0.2);
  std::fill(speeds.begin() + 30, speeds.end(), 0.02);
  const auto drawn = inked(written(speeds), Verdict::none);
  ASSERT_EQ(drawn.half_widths_m.size(), drawn.points.size());
  EXPECT_LT(drawn.half_width_at(0), 0.7 * drawn.half_width_at(10));
  EXPECT_LT(drawn.half_width_at(29), 0.9 * drawn.half_width_at(15));
  EXPECT_GT(drawn.half_width_at(40), drawn.half_width_at(29)) << "slow again";
  EXPECT_GT(inked(written(speeds, 1), Verdict::none).half_width_at(15), 1.2 * drawn.half_width_at(15));
}

TEST(InkedStroke, EndsInAPointWhereTheHandDidNotStop) {
  const std::vector<double> swept(40, 0.05);
  auto stopped = swept;
  std::fill(stopped.end() - 4, stopped.end(), 0.005);
  EXPECT_LT(inked(written(swept), Verdict::none).half_width_at(40), 0.0004);
  EXPECT_GT(inked(written(stopped), Verdict::none).half_width_at(40), 0.001);
  EXPECT_GT(inked(written(swept), Verdict::none, false).half_width_at(40), 0.001)
      << "it is still being written";
}

TEST(InkedStroke, WithoutTimesIsAsWideAllAlong) {
  auto stroke = written(std::vector<double>(40, 0.05));
  for (auto& point : stroke) point.time_s.reset();
  const auto drawn = inked(stroke, Verdict::none);
  for (std::size_t i = 5; i < drawn.points.size(); ++i)
    EXPECT_DOUBLE_EQ(drawn.half_width_at(i), drawn.half_width_at(5));
}

}  // namespace
}  // namespace nazori::view
