// SPDX-License-Identifier: Apache-2.0
#include "nazori/geometry/point.h"

#include <gtest/gtest.h>

#include "nazori/geometry/frames.h"

namespace nazori::geometry {
namespace {

TEST(Point, SumsDifferencesAndMultiplesGoCoordinateByCoordinate) {
  const GlyphPoint a{5, -3};
  const GlyphPoint b{2, 7};
  EXPECT_EQ(a + b, (GlyphPoint{7, 4}));
  EXPECT_EQ(a - b, (GlyphPoint{3, -10}));
  EXPECT_EQ(a * 4, (GlyphPoint{20, -12}));
  EXPECT_EQ(4 * a, (GlyphPoint{20, -12}));
  EXPECT_EQ(dot(a, b), -11);
  EXPECT_EQ(GlyphPoint{}, (GlyphPoint{0, 0}));
}

TEST(Point, LengthIsExactWhereTheSquaresLeaveTheRangeOfDoubles) {
  for (const double unit : {1.0, 1e-200, 1e-161, 1e-150, 1e-140, 1e140, 1e150, 1e200, 1e300}) {
    EXPECT_DOUBLE_EQ(length(GlyphPoint{3 * unit, -4 * unit}) / unit, 5) << unit;
    EXPECT_DOUBLE_EQ(distance(GlyphPoint{unit, unit}, GlyphPoint{6 * unit, 13 * unit}) / unit, 13) << unit;
  }
  EXPECT_EQ(length(GlyphPoint{}), 0);
}

TEST(Point, ATabletIsTenCentimetresWideAndOneDeepUnlessToldOtherwise) {
  EXPECT_EQ(TabletShape{}.width_m, 0.1);
  EXPECT_EQ(TabletShape{}.depth_m, 0.01);
}

}  // namespace
}  // namespace nazori::geometry
