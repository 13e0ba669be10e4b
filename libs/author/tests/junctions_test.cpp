// SPDX-License-Identifier: Apache-2.0
#include "junctions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "drawn_ink.h"

namespace nazori::author::test {
namespace {

using geometry::GridPoint;
using Line = geometry::Polyline<geometry::GridFrame>;

constexpr GridPoint kMiddle{250, 250};

GridPoint way(double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return {std::cos(a), std::sin(a)};
}

/// A branch of unit steps away from a place, from the first step to the last.
Branch ray(GridPoint at, double degrees, int first, int last) {
  Branch branch;
  for (int k = first; k <= last; ++k) branch.points.push_back(at + way(degrees) * k);
  return branch;
}

/// Rays from one node, which are as wide as it: no arm thins out.
InkGraph star(const std::vector<double>& directions, double radius, int length = 100) {
  InkGraph graph;
  graph.nodes.push_back({kMiddle, radius});
  for (const double degrees : directions) {
    graph.branches.push_back(ray(kMiddle, degrees, 1, length));
    graph.branches.back().from = 0;
  }
  return graph;
}

InkMap all_ink() {
  return ink_with([](double, double) { return 2; });
}

double direction_of(GridPoint from, GridPoint to) {
  return std::atan2(to.y - from.y, to.x - from.x) * 180 / std::numbers::pi;
}

TEST(ArmsOf, BeginWhereTheInkOfTheirNodeEnds) {
  const Arms arms = arms_of(star({0, 90, 180}, 10), all_ink(), 1.1);
  ASSERT_EQ(arms.arms.size(), 3U);
  ASSERT_EQ(arms.junctions.size(), 1U);
  EXPECT_EQ(arms.junctions[0].at, kMiddle);
  EXPECT_EQ(arms.junctions[0].radius, 10);
  for (const Arm& arm : arms.arms) {
    EXPECT_EQ(arm.from, 0);
    EXPECT_EQ(arm.to, -1);
    ASSERT_EQ(arm.points.size(), 90U) << "from the eleventh step, at 11 samples";
    EXPECT_NEAR(geometry::distance(arm.points.front(), kMiddle), 11, 1e-9);
    EXPECT_NEAR(geometry::distance(arm.points.back(), kMiddle), 100, 1e-9);
    EXPECT_FALSE(arm.thins_out);
    EXPECT_FALSE(arm.is_ring);
  }
}

TEST(ArmsOf, AreCutAtBothEndsAndKeepTheirDirection) {
  InkGraph graph;
  graph.nodes = {{{100, 100}, 10}, {{200, 100}, 20}};
  Branch branch = ray({100, 100}, 0, 1, 99);
  branch.from = 0;
  branch.to = 1;
  graph.branches = {branch};
  const Arms arms = arms_of(graph, all_ink(), 1.0);
  ASSERT_EQ(arms.arms.size(), 1U);
  EXPECT_NEAR(arms.arms[0].points.front().x, 110, 1e-9);
  EXPECT_NEAR(arms.arms[0].points.back().x, 180, 1e-9);
  EXPECT_EQ(arms.arms[0].from, 0);
  EXPECT_EQ(arms.arms[0].to, 1);
  // A ring touches no node.
  Branch ring = ray({300, 300}, 0, 0, 20);
  ring.is_ring = true;
  graph.branches = {ring};
  EXPECT_TRUE(arms_of(graph, all_ink(), 1.0).arms[0].is_ring);
  EXPECT_EQ(arms_of(graph, all_ink(), 1.0).arms[0].points.size(), 21U);
}

TEST(ArmsOf, NodesWhoseInkMeetsAreOneJunction) {
  const auto junctions = [](int apart) {
    InkGraph graph;
    graph.nodes = {{{100, 100}, 10}, {{100.0 + apart, 104}, 14}, {{400, 400}, 5}};
    Branch between = ray({100, 100}, 0, 1, apart - 1);
    between.from = 0;
    between.to = 1;
    Branch left = ray({100, 100}, 180, 1, 60);
    left.from = 0;
    Branch right = ray({100.0 + apart, 104}, 0, 1, 60);
    right.from = 1;
    graph.branches = {between, left, right};
    return arms_of(graph, all_ink(), 1.0);
  };
  const Arms one = junctions(24);
  ASSERT_EQ(one.junctions.size(), 2U);
  EXPECT_EQ(one.junctions[0].at, (GridPoint{112, 102}));
  EXPECT_EQ(one.junctions[0].radius, 14);
  EXPECT_EQ(one.junctions[1].at, (GridPoint{400, 400}));
  ASSERT_EQ(one.arms.size(), 2U);
  EXPECT_EQ(one.arms[0].from, 0);
  EXPECT_EQ(one.arms[1].from, 0);
  const Arms two = junctions(25);
  EXPECT_EQ(two.junctions.size(), 3U);
  EXPECT_EQ(two.arms.size(), 3U) << "24 points and 24 samples";
  EXPECT_EQ(two.arms[2].from, 1);
}

TEST(ArmsOf, AShortOneKeepsWhatIsFarthestFromItsNode) {
  InkGraph graph = star({0}, 10, 11);
  // Of 11 points only one is outside of the ink of the node.
  Arms arms = arms_of(graph, all_ink(), 1.1);
  ASSERT_EQ(arms.arms[0].points.size(), 3U);
  EXPECT_NEAR(arms.arms[0].points.back().x, 261, 1e-9);
  EXPECT_NEAR(arms.arms[0].points.front().x, 259, 1e-9);
  graph = star({0}, 10, 13);
  EXPECT_EQ(arms_of(graph, all_ink(), 1.1).arms[0].points.size(), 3U);
  graph = star({0}, 10, 14);
  EXPECT_EQ(arms_of(graph, all_ink(), 1.1).arms[0].points.size(), 4U);
  graph = star({0}, 10, 2);
  EXPECT_EQ(arms_of(graph, all_ink(), 1.1).arms[0].points.size(), 2U);
  // From the other end.
  graph = star({0}, 10, 11);
  std::ranges::reverse(graph.branches[0].points);
  std::swap(graph.branches[0].from, graph.branches[0].to);
  arms = arms_of(graph, all_ink(), 1.1);
  ASSERT_EQ(arms.arms[0].points.size(), 3U);
  EXPECT_NEAR(arms.arms[0].points.front().x, 261, 1e-9);
}

TEST(ArmsOf, ThinOutWhereTheirEndIsLessThanHalfAsWideAsTheirNode) {
  const auto thins_out = [](double half, bool back) {
    InkGraph graph = star({0}, 20);
    if (back) {
      std::ranges::reverse(graph.branches[0].points);
      std::swap(graph.branches[0].from, graph.branches[0].to);
    }
    const InkMap map = ink_with([&](double, double y) { return 1 + 0.25 * (half - std::abs(y - 250)); });
    return arms_of(graph, map, 1.1).arms[0].thins_out;
  };
  for (const bool back : {false, true}) {
    EXPECT_TRUE(thins_out(8.5, back)) << "paper is 9 away";
    EXPECT_FALSE(thins_out(9.5, back)) << "10 away";
  }
}

TEST(ArmsOf, GoOnToTheTipOfASweepThatTouches) {
  InkGraph graph = star({0}, 10);
  graph.branches[0].back_tip = TouchingTip{{370, 250}, true};
  EXPECT_EQ(arms_of(graph, all_ink(), 1.1).arms[0].points.back(), (GridPoint{370, 250}));
  graph.branches[0].back_tip->thins_out = false;
  EXPECT_NEAR(arms_of(graph, all_ink(), 1.1).arms[0].points.back().x, 350, 1e-9);
  std::ranges::reverse(graph.branches[0].points);
  graph.branches[0].from = -1;
  graph.branches[0].to = 0;
  graph.branches[0].back_tip.reset();
  graph.branches[0].front_tip = TouchingTip{{371, 250}, true};
  EXPECT_EQ(arms_of(graph, all_ink(), 1.1).arms[0].points.front(), (GridPoint{371, 250}));
}

std::vector<Line> lines_of(const std::vector<double>& directions, double radius = 10, int length = 100) {
  return joined(arms_of(star(directions, radius, length), all_ink(), 1.1));
}

/// For each line the directions of its ends from the middle, rounded, the smaller first.
std::vector<std::pair<long, long>> ends_of(const std::vector<Line>& lines) {
  std::vector<std::pair<long, long>> ends;
  for (const Line& line : lines) {
    const long a = std::lround(direction_of(kMiddle, line.front()));
    const long b = std::lround(direction_of(kMiddle, line.back()));
    ends.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::ranges::sort(ends);
  return ends;
}

TEST(Joined, AtACrossingTheStraightestGoOnInEachOther) {
  using V = std::vector<std::pair<long, long>>;
  EXPECT_EQ(ends_of(lines_of({0, 90, 180, 270})), (V{{-90, 90}, {0, 180}}));
  EXPECT_EQ(ends_of(lines_of({10, 60, 190, 240})), (V{{-170, 10}, {-120, 60}}));
  // The one that bends least comes first: by 5 and by 30 degrees.
  const auto ends = ends_of(lines_of({0, 210, 175}));
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_TRUE(std::ranges::find(ends, std::pair(0L, 175L)) != ends.end());
}

TEST(Joined, WhatBendsMoreThanFortyTwoDegreesDoesNotGoOn) {
  // Half of the bend is that of the directions, the other half that of the way between the two ends, which is
  // half as much where both come from one place.
  EXPECT_EQ(lines_of({0, 120, 240}).size(), 3U);
  EXPECT_EQ(lines_of({0, 125, 242}).size(), 2U) << "55 degrees count as 41.25";
  EXPECT_EQ(lines_of({0, 123, 242}).size(), 3U) << "57 as 42.75";
  // Ends that are less than four samples apart have no way between them.
  EXPECT_EQ(lines_of({0, 139, 249}, 1).size(), 2U) << "41 degrees";
  EXPECT_EQ(lines_of({0, 137, 249}, 1).size(), 3U) << "43 degrees";
  // Where there are only two, they always do.
  EXPECT_EQ(lines_of({0, 70}).size(), 1U);
}

TEST(Joined, AnArmEndsWhereItMeetsTheLineThatGoesThrough) {
  for (const double degrees : {90.0, 60.0, 130.0}) {
    const auto lines = lines_of({0, 180, degrees});
    ASSERT_EQ(lines.size(), 2U) << degrees;
    const Line& arm = lines[0].size() < lines[1].size() ? lines[0] : lines[1];
    const GridPoint end = geometry::distance(arm.front(), kMiddle) < 50 ? arm.front() : arm.back();
    EXPECT_NEAR(end.x, 250, 1e-6) << degrees;
    EXPECT_NEAR(end.y, 250, 1e-6) << degrees;
    EXPECT_NEAR(static_cast<double>(arm.size()), 91, 1);
  }
}

TEST(Joined, WithoutALineThroughItEndsNearTheMiddle) {
  for (const Line& line : lines_of({0, 120, 240})) {
    const GridPoint end = geometry::distance(line.front(), kMiddle) < 50 ? line.front() : line.back();
    EXPECT_LT(geometry::distance(end, kMiddle), 1e-6);
  }
}

TEST(Joined, AMeetingFarBehindTheArmOrAheadIsNone) {
  // An arm down that begins this far below the line that goes through.
  static constexpr GridPoint kBeside{256, 251};
  const auto end_with = [](double gap) {
    Arms arms;
    arms.junctions.push_back({kBeside, 10});
    Arm left;
    Arm right;
    Arm down;
    for (int k = 20; k <= 120; ++k) {
      left.points.push_back({250.0 - k, 250});
      right.points.push_back({250.0 + k, 250});
      down.points.push_back({250, 250 + gap + k - 20});
    }
    left.from = right.from = down.from = 0;
    arms.arms = {left, right, down};
    for (const Line& line : joined(arms))
      if (line.size() == 102) return line.front().y < line.back().y ? line.front() : line.back();
    return GridPoint{};
  };
  EXPECT_LT(geometry::distance(end_with(12), kMiddle), 1e-9);
  EXPECT_LT(geometry::distance(end_with(29), kMiddle), 1e-9) << "less than three radii";
  EXPECT_EQ(end_with(31), kBeside) << "more: the middle of the junction";
}

TEST(Joined, ARingIsOneLineAndALoopComesBackToItsJunction) {
  Arms arms;
  Arm ring;
  for (int k = 0; k < 120; ++k) ring.points.push_back(kMiddle + way(3 * k) * 60);
  ring.is_ring = true;
  arms.arms = {ring};
  ASSERT_EQ(joined(arms).size(), 1U);
  EXPECT_EQ(joined(arms)[0].size(), 120U);
  arms.arms[0].is_ring = false;
  arms.arms[0].from = arms.arms[0].to = 0;
  arms.junctions.push_back({kMiddle + way(-1.5) * 60, 2});
  const auto lines = joined(arms);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].size(), 121U);
  EXPECT_EQ(lines[0].front(), lines[0].back());
}

TEST(Joined, ALineGoesThroughSeveralJunctions) {
  InkGraph graph;
  graph.nodes = {{{100, 250}, 8}, {{250, 250}, 8}};
  const auto branch = [&](GridPoint at, double degrees, int last, int from, int to) {
    Branch b = ray(at, degrees, 1, last);
    b.from = from;
    b.to = to;
    graph.branches.push_back(b);
  };
  branch({100, 250}, 180, 60, 0, -1);
  branch({100, 250}, 90, 60, 0, -1);
  branch({100, 250}, 0, 149, 0, 1);
  branch({250, 250}, 90, 60, 1, -1);
  branch({250, 250}, 0, 60, 1, -1);
  const auto lines = joined(arms_of(graph, all_ink(), 1.1));
  ASSERT_EQ(lines.size(), 3U);
  const auto longest = std::ranges::max_element(lines, {}, &Line::size);
  EXPECT_NEAR(std::min(longest->front().x, longest->back().x), 40, 1e-9);
  EXPECT_NEAR(std::max(longest->front().x, longest->back().x), 310, 1e-9);
}

/// A stroke from above whose round end is below the place where its hook leaves it.
std::vector<Line> hooked(int rest, int hook, bool rest_thins_out, bool hook_thins_out) {
  Arms arms;
  arms.junctions.push_back({kMiddle, 10});
  const auto arm = [&](double degrees, int last, bool thins_out) {
    Arm a;
    for (int k = 11; k < 11 + last; ++k) a.points.push_back(kMiddle + way(degrees) * k);
    a.from = 0;
    a.thins_out = thins_out;
    arms.arms.push_back(a);
  };
  arm(-90, 100, false);
  arm(90, rest, rest_thins_out);
  arm(200, hook, hook_thins_out);
  return joined(arms);
}

TEST(Joined, AHookGoesOnFromTheRoundEndOfItsStroke) {
  EXPECT_EQ(hooked(15, 40, false, true).size(), 1U);
  EXPECT_EQ(hooked(20, 40, false, true).size(), 1U);
  EXPECT_EQ(hooked(21, 40, false, true).size(), 2U) << "longer than two radii";
  EXPECT_EQ(hooked(15, 65, false, true).size(), 1U);
  EXPECT_EQ(hooked(15, 66, false, true).size(), 2U) << "longer than 14 units";
  EXPECT_EQ(hooked(15, 40, true, true).size(), 2U);
  EXPECT_EQ(hooked(15, 40, false, false).size(), 2U);
  const Line line = hooked(15, 40, false, true)[0];
  // From the top to the round end and back to the tip of the hook, or the other way.
  const bool down = line.front().y < 200;
  const GridPoint tip = down ? line.back() : line.front();
  EXPECT_LT(geometry::distance(tip, kMiddle + way(200) * 50), 1e-6);
  EXPECT_EQ(line.size(), 100U + 15 + 40);
}

}  // namespace
}  // namespace nazori::author::test
