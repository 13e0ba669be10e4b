// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/inked_stroke.h"

#include <gtest/gtest.h>

#include <numbers>

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

}  // namespace
}  // namespace nazori::view
