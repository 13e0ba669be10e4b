// SPDX-License-Identifier: Apache-2.0
#include "ink_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "drawn_ink.h"
#include "gaps.h"
#include "ridge.h"

namespace nazori::author::test {
namespace {

using geometry::GridPoint;

/// The graph of a drawing in rows of letters, '#' the pixels of the skeleton.
InkGraph graph_in(const std::vector<std::string>& rows) {
  const int side = static_cast<int>(rows.size());
  std::vector<std::uint8_t> skeleton;
  for (const std::string& row : rows)
    for (const char c : row) skeleton.push_back(c == '#' ? 1 : 0);
  EXPECT_EQ(skeleton.size(), rows.size() * rows.size());
  DistanceMap distance{side, std::vector<float>(skeleton.size(), 3.5F), std::vector<Pixel>(skeleton.size())};
  distance.distance[0] = 9;
  return graph_of(skeleton, distance);
}

TEST(GraphOf, ALineIsABranchWithTwoFreeEnds) {
  const InkGraph graph = graph_in({"......", ".#....", "..#...", "..#...", "...##.", "......"});
  EXPECT_TRUE(graph.nodes.empty());
  ASSERT_EQ(graph.branches.size(), 1U);
  const Branch& branch = graph.branches[0];
  EXPECT_EQ(branch.points, (std::vector<GridPoint>{{1, 1}, {2, 2}, {2, 3}, {3, 4}, {4, 4}}));
  EXPECT_EQ(branch.from, -1);
  EXPECT_EQ(branch.to, -1);
  EXPECT_FALSE(branch.is_ring);
}

TEST(GraphOf, APixelAloneIsABranch) {
  const InkGraph graph = graph_in({"....", ".#..", "....", "...."});
  ASSERT_EQ(graph.branches.size(), 1U);
  EXPECT_EQ(graph.branches[0].points, (std::vector<GridPoint>{{1, 1}}));
  EXPECT_EQ(graph.branches[0].from, -1);
  EXPECT_EQ(graph.branches[0].to, -1);
  EXPECT_TRUE(graph.nodes.empty());
}

TEST(GraphOf, ARingHasNoEnds) {
  const InkGraph graph = graph_in({"......", "..##..", ".#..#.", ".#..#.", "..##..", "......"});
  EXPECT_TRUE(graph.nodes.empty());
  ASSERT_EQ(graph.branches.size(), 1U);
  EXPECT_TRUE(graph.branches[0].is_ring);
  EXPECT_EQ(graph.branches[0].points.size(), 8U);
  const GridPoint first = graph.branches[0].points.front();
  const GridPoint last = graph.branches[0].points.back();
  EXPECT_LT(geometry::distance(first, last), 1.5);
}

TEST(GraphOf, WhereThreeMeetIsANodeInTheirMiddle) {
  // The crossing of two diagonals is one pixel with four neighbours.
  const InkGraph graph =
      graph_in({".......", ".#...#.", "..#.#..", "...#...", "..#.#..", ".#...#.", "......."});
  ASSERT_EQ(graph.nodes.size(), 1U);
  EXPECT_EQ(graph.nodes[0].at, (GridPoint{3, 3}));
  EXPECT_EQ(graph.nodes[0].radius, 3) << "half a sample less than the distance";
  ASSERT_EQ(graph.branches.size(), 4U);
  for (const Branch& branch : graph.branches) {
    EXPECT_EQ(branch.points.size(), 2U);
    EXPECT_EQ(std::max(branch.from, branch.to), 0);
    EXPECT_EQ(std::min(branch.from, branch.to), -1);
  }
}

TEST(GraphOf, PixelsWithManyNeighboursBesideEachOtherAreOneNode) {
  // A branch down from a flat line: the pixel, its two sides and the one below have three neighbours or more.
  const InkGraph graph =
      graph_in({".......", ".......", ".#####.", "...#...", "...#...", "...#...", "......."});
  ASSERT_EQ(graph.nodes.size(), 1U);
  EXPECT_EQ(graph.nodes[0].at, (GridPoint{3, 2.25}));
  EXPECT_EQ(graph.branches.size(), 3U);
}

TEST(GraphOf, ABranchOfOnePixelKnowsBothItsNodes) {
  // Two diagonal crossings with one pixel between them.
  const InkGraph graph =
      graph_in({"...........", "...........", ".#.......#.", "..#.....#..", "...#.#.#...", "....#.#....",
                "...#.#.#...", "..#.....#..", ".#.......#.", "...........", "..........."});
  // The pixels at (5, 4) and (5, 6) join the nodes at (4, 5) and (6, 5).
  ASSERT_EQ(graph.nodes.size(), 2U);
  int between = 0;
  for (const Branch& branch : graph.branches) {
    if (branch.points.size() != 1) continue;
    ++between;
    EXPECT_EQ(branch.from + branch.to, 1);
    EXPECT_NE(branch.from, branch.to);
  }
  EXPECT_EQ(between, 2);
  EXPECT_EQ(graph.branches.size(), 6U);
}

/// A flat bar of ink between two columns, 20 samples wide on each side but for what `half` says.
template <class Half>
InkMap bar_with(Half half) {
  return ink_with([&](double x, double y) {
    const double along = std::max({100 - x, x - 400, 0.0});
    return 1 + 0.25 * (half(x) - std::hypot(along, y - 200));
  });
}

TEST(MiddleLines, OfABarWithRoundEndsAreItsAxis) {
  const InkMap map = bar_with([](double) { return 20.2; });
  const InkGraph graph = middle_lines(map);
  EXPECT_TRUE(graph.nodes.empty());
  ASSERT_EQ(graph.branches.size(), 1U);
  for (const GridPoint p : graph.branches[0].points) EXPECT_NEAR(p.y, 200, 1);
  const auto [left, right] =
      std::minmax(graph.branches[0].points.front().x, graph.branches[0].points.back().x);
  EXPECT_NEAR(left, 100, 6);
  EXPECT_NEAR(right, 400, 6);
}

TEST(MiddleLines, OfAThinLineAreItself) {
  const InkMap map =
      ink_with([](double x, double y) { return x > 99 && x < 301 && std::abs(y - 200) < 1.5 ? 2 : 0; });
  const InkGraph graph = middle_lines(map);
  ASSERT_EQ(graph.branches.size(), 1U);
  EXPECT_NEAR(graph.branches[0].points.front().x, 100, 2);
  EXPECT_NEAR(graph.branches[0].points.back().x, 300, 2);
  for (const GridPoint p : graph.branches[0].points) EXPECT_NEAR(p.y, 200, 1);
}

TEST(MiddleLines, ABumpIsAnArmWhereItReachesFarBeyondTheDisc) {
  // A wall upwards from the middle of the bar, eight wide on each side.
  const auto branches = [](double beyond) {
    const InkMap map = ink_with([&](double x, double y) {
      const double along = std::max({100 - x, x - 400, 0.0});
      const double bar = 20.2 - std::hypot(along, y - 200);
      const double bump =
          8.2 - std::hypot(x - 250, std::max(0.0, 200 - 20 - beyond + 8 - y) + std::max(0.0, y - 200));
      return 1 + 0.25 * std::max(bar, bump);
    });
    return middle_lines(map).branches.size();
  };
  EXPECT_EQ(branches(4), 1U);
  EXPECT_EQ(branches(20), 3U);
}

/// A bar whose half width is this in the middle, between two that are 20 wide.
double waist(double x, double least) { return std::min(20.2, least + std::abs(x - 250) * 1.2); }

TEST(DividedAtGaps, WhereInkIsNarrowTwoStrokesTouch) {
  const auto parts = [](double least) {
    const InkMap map = bar_with([&](double x) { return waist(x, least); });
    return divided_at_gaps(middle_lines(map), map).branches;
  };
  EXPECT_EQ(parts(16.2).size(), 1U);
  ASSERT_EQ(parts(12.2).size(), 2U);
  for (const Branch& branch : parts(12.2)) {
    EXPECT_TRUE(branch.front_tip.has_value() != branch.back_tip.has_value());
    const TouchingTip tip = branch.front_tip ? *branch.front_tip : *branch.back_tip;
    EXPECT_NEAR(tip.at.x, 250, 3);
    // What is left of each stroke ends where it is whole, not farther than the gap.
    const GridPoint end = branch.front_tip ? branch.points.front() : branch.points.back();
    EXPECT_GE(std::abs(end.x - 250), 5);
    EXPECT_LE(std::abs(end.x - 250), 25);
  }
}

TEST(DividedAtGaps, InAGrooveTheDepthDecides) {
  const auto parts = [](float least, float ground = 0.8F) {
    InkMap map = bar_with([](double) { return 20.2; });
    map.is_groove = true;
    for (int y = 0; y < kInkSide; ++y)
      for (int x = 0; x < kInkSide; ++x)
        map.depth[map.index(x, y)] = std::min(ground, least + std::abs(static_cast<float>(x) - 250) * 0.01F);
    return divided_at_gaps(middle_lines(map), map).branches.size();
  };
  EXPECT_EQ(parts(0.76F), 1U) << "0.95 of what is around it";
  EXPECT_EQ(parts(0.72F), 2U) << "0.90";
  EXPECT_EQ(parts(0.4F), 2U);
}

TEST(RidgeOf, HasThePointsAndTheFreeEndsOfTheMiddleLines) {
  const InkMap map = bar_with([](double) { return 20.2; });
  const Ridge ridge = ridge_of(middle_lines(map), map, 1.1);
  ASSERT_EQ(ridge.ends.size(), 2U);
  const auto x = [](std::size_t column) { return static_cast<double>(column) * 109 / 511; };
  const auto [left, right] = std::minmax(
      ridge.ends[0], ridge.ends[1], [](const RidgeEnd& a, const RidgeEnd& b) { return a.at.x < b.at.x; });
  EXPECT_NEAR(left.at.x, x(100), 0.1);
  EXPECT_NEAR(right.at.x, x(400), 0.1);
  EXPECT_NEAR(left.out.x, -1, 0.01);
  EXPECT_NEAR(right.out.x, 1, 0.01);
  EXPECT_FALSE(left.touches || right.touches);
  for (std::size_t i = 0; i < ridge.points.size(); ++i) {
    EXPECT_NEAR(ridge.points[i].at.y, 200.0 * 109 / 511, 0.15);
    EXPECT_NEAR(std::abs(ridge.points[i].along.x), 1, 0.02);
    EXPECT_TRUE(ridge.points[i].is_sure);
    // Three samples apart, but at the ends, which were moved.
    if (i > 1 && i + 2 < ridge.points.size()) {
      EXPECT_NEAR(geometry::distance(ridge.points[i].at, ridge.points[i - 1].at), 3.0 * 109 / 511, 0.05);
    }
  }
}

TEST(RidgeOf, BesideANodeThePlaceIsNotSure) {
  InkGraph graph;
  graph.nodes = {{{200, 200}, 20}};
  for (const double side : {-1.0, 1.0}) {
    Branch branch;
    for (int k = 1; k <= 90; ++k) branch.points.push_back({200 + side * k, 200});
    branch.from = 0;
    if (side > 0) branch.back_tip = TouchingTip{{291, 200}, false};
    graph.branches.push_back(branch);
  }
  const InkMap map = bar_with([](double) { return 20.2; });
  const Ridge ridge = ridge_of(graph, map, 1.1);
  for (const RidgePoint& p : ridge.points) {
    const double away = std::abs(p.at.x * 511 / 109 - 200);
    EXPECT_EQ(p.is_sure, away >= 22) << away;
  }
  ASSERT_EQ(ridge.ends.size(), 2U);
  EXPECT_FALSE(ridge.ends[0].touches);
  EXPECT_TRUE(ridge.ends[1].touches);
  EXPECT_NEAR(ridge.ends[1].at.x, 290.0 * 109 / 511, 1e-9) << "it is not moved";
}

TEST(RidgeOf, ARingHasNoEnds) {
  InkGraph graph;
  Branch ring;
  for (int k = 0; k < 120; ++k) {
    const double a = k * 2 * 3.14159265358979323846 / 120;
    ring.points.push_back({200 + 60 * std::cos(a), 200 + 60 * std::sin(a)});
  }
  ring.is_ring = true;
  graph.branches = {ring};
  const InkMap map = bar_with([](double) { return 20.2; });
  EXPECT_TRUE(ridge_of(graph, map, 1.1).ends.empty());
  EXPECT_FALSE(ridge_of(graph, map, 1.1).points.empty());
}

}  // namespace
}  // namespace nazori::author::test
