// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/inked_stroke.h"

#include <gtest/gtest.h>

#include <algorithm>
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
