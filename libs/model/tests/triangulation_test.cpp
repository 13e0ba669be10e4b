// SPDX-License-Identifier: Apache-2.0
#include "../src/triangulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace nazori::model {
namespace {

std::int64_t twice_area(GridSample a, GridSample b, GridSample c) {
  return static_cast<std::int64_t>(b.column - a.column) * (c.row - a.row) -
         static_cast<std::int64_t>(b.row - a.row) * (c.column - a.column);
}

/// That the triangles cover the grid once, know their neighbours, and that no sample lies in the circle of a
/// triangle.
void expect_sound(const Triangulation& t, int columns, int rows) {
  const auto at = [&](std::int32_t i) { return t.samples()[static_cast<std::size_t>(i)]; };
  std::int64_t area = 0;
  std::map<std::pair<int, int>, int> edges;
  for (std::size_t i = 0; i < t.triangles().size(); ++i) {
    const auto& triangle = t.triangles()[i];
    const std::int64_t own =
        twice_area(at(triangle.corner[0]), at(triangle.corner[1]), at(triangle.corner[2]));
    EXPECT_GT(own, 0);
    area += own;
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = triangle.corner[(k + 1) % 3];
      const int to = triangle.corner[(k + 2) % 3];
      EXPECT_TRUE(edges.emplace(std::pair{from, to}, static_cast<int>(i)).second);
    }
  }
  EXPECT_EQ(area, std::int64_t{2} * (columns - 1) * (rows - 1));
  for (std::size_t i = 0; i < t.triangles().size(); ++i) {
    const auto& triangle = t.triangles()[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto beyond = edges.find({triangle.corner[(k + 2) % 3], triangle.corner[(k + 1) % 3]});
      EXPECT_EQ(triangle.across[k], beyond == edges.end() ? -1 : beyond->second);
    }
  }
}

void expect_delaunay(const Triangulation& t) {
  const auto at = [&](std::int32_t i) { return t.samples()[static_cast<std::size_t>(i)]; };
  for (const auto& triangle : t.triangles()) {
    const GridSample a = at(triangle.corner[0]);
    const GridSample b = at(triangle.corner[1]);
    const GridSample c = at(triangle.corner[2]);
    // The centre of the circle by Cramer's rule.
    const double bx = b.column - a.column;
    const double by = b.row - a.row;
    const double cx = c.column - a.column;
    const double cy = c.row - a.row;
    const double d = 2 * (bx * cy - by * cx);
    const double ux = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / d;
    const double uy = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / d;
    const double radius = std::hypot(ux, uy);
    for (const GridSample& s : t.samples())
      EXPECT_GE(std::hypot(s.column - a.column - ux, s.row - a.row - uy), radius - 1e-6);
  }
}

TEST(Triangulation, SamplesInAnyOrderGiveADelaunayTriangulation) {
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    const int columns = 2 + static_cast<int>(random() % 30);
    const int rows = 2 + static_cast<int>(random() % 30);
    Triangulation t(columns, rows, {});
    for (int i = 0; i < 60; ++i)
      t.insert({static_cast<int>(random() % static_cast<unsigned>(columns)),
                static_cast<int>(random() % static_cast<unsigned>(rows))});
    expect_sound(t, columns, rows);
    expect_delaunay(t);
  }
}

TEST(Triangulation, AllSamplesOfAGridCanBeInserted) {
  Triangulation t(9, 6, {});
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 9; ++column) t.insert({column, row});
  EXPECT_EQ(t.samples().size(), 54U);
  EXPECT_EQ(t.triangles().size(), 2U * 8 * 5);
  expect_sound(t, 9, 6);
}

TEST(Triangulation, ASampleThatIsThereChangesNothing) {
  Triangulation t(9, 9, {});
  t.insert({4, 3});
  t.insert({4, 3});
  t.insert({8, 8});
  EXPECT_EQ(t.samples().size(), 5U);
}

TEST(Triangulation, AfterRefiningNoSampleIsFartherThanTheTolerance) {
  constexpr int kColumns = 41;
  constexpr int kRows = 29;
  std::vector<float> heights;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      heights.push_back(static_cast<float>(std::sin(column * 0.3) * std::cos(row * 0.2) * 4));
  Triangulation t(kColumns, kRows, heights);
  const double left = t.refine(0.05, 100'000);
  EXPECT_LE(left, 0.05);
  expect_sound(t, kColumns, kRows);
  double worst = 0;
  for (const auto& triangle : t.triangles()) {
    const auto corner = [&](std::size_t i) {
      return t.samples()[static_cast<std::size_t>(triangle.corner[i])];
    };
    const auto z = [&](GridSample s) {
      return heights[static_cast<std::size_t>(s.row * kColumns + s.column)];
    };
    const double whole = static_cast<double>(twice_area(corner(0), corner(1), corner(2)));
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column) {
        const GridSample s{column, row};
        const double a = static_cast<double>(twice_area(corner(1), corner(2), s)) / whole;
        const double b = static_cast<double>(twice_area(corner(2), corner(0), s)) / whole;
        const double c = static_cast<double>(twice_area(corner(0), corner(1), s)) / whole;
        if (a < 0 || b < 0 || c < 0) continue;
        worst = std::max(worst, std::abs(a * z(corner(0)) + b * z(corner(1)) + c * z(corner(2)) - z(s)));
      }
    }
  }
  EXPECT_LE(worst, 0.0501);
  EXPECT_NEAR(worst, left, 1e-4);
  EXPECT_LT(t.triangles().size(), 2U * (kColumns - 1) * (kRows - 1) * 3 / 4);
}

TEST(Triangulation, APlaneNeedsTwoTriangles) {
  std::vector<float> heights;
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 30; ++column) heights.push_back(static_cast<float>(column * 2 + row));
  Triangulation t(30, 20, heights);
  EXPECT_LE(t.refine(1e-3, 1000), 1e-3);
  EXPECT_EQ(t.triangles().size(), 2U);
}

TEST(Triangulation, TheNumberOfTrianglesHasALimit) {
  std::vector<float> heights;
  std::mt19937 random(1);
  for (int i = 0; i < 50 * 50; ++i) heights.push_back(static_cast<float>(random() % 100));
  Triangulation t(50, 50, heights);
  EXPECT_GT(t.refine(0.01, 500), 0.01);
  EXPECT_LE(t.triangles().size(), 500U);
  EXPECT_GE(t.triangles().size(), 498U);
  expect_sound(t, 50, 50);
}

}  // namespace
}  // namespace nazori::model
