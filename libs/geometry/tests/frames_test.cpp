// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "nazori/geometry/frames.h"

namespace nazori::geometry {
namespace {

constexpr TabletShape kShape{0.100, 0.010};

template <class Frame>
void expect_near(Point2<Frame> a, Point2<Frame> b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(Frames, TheGlyphBoxSpansTheMapFromEdgeToEdge) {
  expect_near(glyph_to_grid({0, 0}, 128), GridPoint{0, 0}, 0);
  expect_near(glyph_to_grid({109, 109}, 128), GridPoint{127, 127}, 1e-12);
  expect_near(glyph_to_grid({54.5, 0}, 3), GridPoint{1, 0}, 1e-12);
}

TEST(Frames, TheTabletHasItsOriginInTheMiddleAndYUp) {
  expect_near(glyph_to_tablet({0, 0}, kShape), TabletPoint{-0.05, 0.05}, 1e-15);
  expect_near(glyph_to_tablet({109, 109}, kShape), TabletPoint{0.05, -0.05}, 1e-15);
  expect_near(glyph_to_tablet({54.5, 54.5}, kShape), TabletPoint{0, 0}, 1e-15);
  expect_near(grid_to_tablet({0, 0}, 1024, kShape), TabletPoint{-0.05, 0.05}, 1e-15);
  expect_near(grid_to_tablet({1023, 1023}, 1024, kShape), TabletPoint{0.05, -0.05}, 1e-15);
}

TEST(Frames, DownInTheGlyphIsDownOnTheTablet) {
  EXPECT_LT(glyph_to_tablet({50, 80}, kShape).y, glyph_to_tablet({50, 20}, kShape).y);
  EXPECT_GT(glyph_to_tablet({80, 50}, kShape).x, glyph_to_tablet({20, 50}, kShape).x);
}

TEST(Frames, EveryRoadBetweenTwoFramesLeadsToTheSamePoint) {
  std::mt19937 random(20051);
  std::uniform_real_distribution<double> coordinate(-20, 130);
  for (const int size : {2, 3, 128, 1000, 8192}) {
    for (int i = 0; i < 200; ++i) {
      const GlyphPoint p{coordinate(random), coordinate(random)};
      const TabletShape shape{0.04 + 0.001 * i, 0.01};
      expect_near(grid_to_glyph(glyph_to_grid(p, size), size), p, 1e-10);
      expect_near(tablet_to_glyph(glyph_to_tablet(p, shape), shape), p, 1e-10);
      expect_near(grid_to_tablet(glyph_to_grid(p, size), size, shape), glyph_to_tablet(p, shape), 1e-14);
      expect_near(tablet_to_grid(glyph_to_tablet(p, shape), size, shape), glyph_to_grid(p, size), 1e-8);
    }
  }
}

}  // namespace
}  // namespace nazori::geometry
