// SPDX-License-Identifier: Apache-2.0
#include "../src/convex_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nazori::scan {
namespace {

TEST(OutlineOf, HasTheCornersOfAllPixelsClockwise) {
  std::vector<Pixel> pixels;
  for (int y = 2; y <= 6; ++y)
    for (int x = 1; x <= 9; ++x) pixels.push_back({x, y});
  pixels.push_back({5, 0});
  const ConvexOutline outline = outline_of(pixels);
  EXPECT_EQ(outline, (ConvexOutline{{1, 2}, {5, 0}, {9, 2}, {9, 6}, {1, 6}}));
  // 8 x 4 and a triangle of 8 x 2.
  EXPECT_DOUBLE_EQ(area_of(outline), 32 + 8);
}

TEST(OutlineOf, OnePixelOrALineHasNoArea) {
  EXPECT_EQ(outline_of({{3, 4}}), (ConvexOutline{{3, 4}}));
  EXPECT_EQ(area_of(outline_of({{3, 4}})), 0);
  const ConvexOutline line = outline_of({{1, 1}, {2, 2}, {4, 4}, {3, 3}});
  EXPECT_EQ(line, (ConvexOutline{{1, 1}, {4, 4}}));
  EXPECT_EQ(area_of(line), 0);
}

TEST(QuadrilateralIn, HasTheCornersThatWereCutOff) {
  // A square from 0 to 100 without its corners, each another one.
  const ConvexOutline cut{{4, 0}, {98, 0}, {100, 3}, {100, 95}, {96, 100}, {1, 100}, {0, 98}, {0, 2}};
  const auto found = quadrilateral_in(cut, 0.95);
  ASSERT_TRUE(found);
  const std::array<PhotoPoint, 4> wanted{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR((*found)[i].x, wanted[i].x, 1e-9) << i;
    EXPECT_NEAR((*found)[i].y, wanted[i].y, 1e-9) << i;
  }
}

TEST(QuadrilateralIn, BeginsAtTheCornerOfTheUpperLeft) {
  const ConvexOutline square{{100, 10}, {90, 100}, {0, 90}, {10, 0}};
  const auto found = quadrilateral_in(square, 0.95);
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)[0], (PhotoPoint{10, 0}));
  EXPECT_EQ((*found)[1], (PhotoPoint{100, 10}));
  EXPECT_EQ((*found)[3], (PhotoPoint{0, 90}));
}

TEST(QuadrilateralIn, IsNoneOfACircleATriangleOrALine) {
  ConvexOutline circle;
  for (int i = 0; i < 40; ++i)
    circle.push_back(
        {50 + 50 * std::cos(i * std::numbers::pi / 20), 50 + 50 * std::sin(i * std::numbers::pi / 20)});
  EXPECT_FALSE(quadrilateral_in(circle, 0.95));
  // A square around a circle has 4 / pi of its area.
  EXPECT_TRUE(quadrilateral_in(circle, 0.75));
  EXPECT_FALSE(quadrilateral_in(circle, 0.80));
  EXPECT_FALSE(quadrilateral_in({{0, 0}, {10, 0}, {0, 10}}, 0.5));
  EXPECT_FALSE(quadrilateral_in({{0, 0}, {10, 10}}, 0.5));
}

TEST(RowsInside, AreTheWholePixelsBetweenTheSides) {
  // A triangle with its tip above.
  const auto rows = rows_inside({{5, 1}, {9, 5}, {1, 5}}, 20, 20);
  ASSERT_EQ(rows.size(), 5U);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(rows[static_cast<std::size_t>(i)].row, 1 + i);
    EXPECT_EQ(rows[static_cast<std::size_t>(i)].first, 5 - i);
    EXPECT_EQ(rows[static_cast<std::size_t>(i)].last, 5 + i);
  }
}

TEST(RowsInside, EndAtThePicture) {
  const auto rows = rows_inside({{-3.5, -2.5}, {30, -2.5}, {30, 30}, {-3.5, 30}}, 8, 6);
  ASSERT_EQ(rows.size(), 6U);
  for (const RowInside& row : rows) {
    EXPECT_EQ(row.first, 0);
    EXPECT_EQ(row.last, 7);
  }
  EXPECT_TRUE(rows_inside({{10, 0}, {12, 0}, {12, 5}, {10, 5}}, 8, 6).empty());
  EXPECT_TRUE(rows_inside({{-5, 0}, {-2, 0}, {-2, 5}, {-5, 5}}, 8, 6).empty());
}

}  // namespace
}  // namespace nazori::scan
