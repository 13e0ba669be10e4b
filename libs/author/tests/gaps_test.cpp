// SPDX-License-Identifier: Apache-2.0
// Where a branch along one row is divided, by widths and depths that are given for each of its points.
#include "../src/gaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace nazori::author {
namespace {

using geometry::GridPoint;

constexpr int kRowSide = 160;
constexpr int kRow = 10;
constexpr int kFirst = 20;  // the first point's column
constexpr int kGapAt = 70;  // 50 points come before it
constexpr int kPoints = 101;

using AtColumn = std::function<double(int)>;

double ten(int /*column*/) { return 10; }

InkMap row_map(const AtColumn& radius, const AtColumn& depth = {}) {
  InkMap map;
  const std::size_t count = static_cast<std::size_t>(kRowSide) * kRowSide;
  map.distance = {kRowSide, std::vector<float>(count), std::vector<Pixel>(count)};
  map.depth.assign(count, 1);
  map.is_groove = static_cast<bool>(depth);
  for (int x = 0; x < kRowSide; ++x) {
    map.distance.distance[map.index(x, kRow)] = static_cast<float>(radius(x) + 0.5);
    if (depth) map.depth[map.index(x, kRow)] = static_cast<float>(depth(x));
  }
  return map;
}

Branch row_branch() {
  Branch branch;
  for (int i = 0; i < kPoints; ++i) branch.points.push_back({static_cast<double>(kFirst + i), kRow});
  return branch;
}

std::vector<Branch> divided(const InkMap& map, const Branch& branch, std::vector<Node> nodes = {}) {
  InkGraph graph;
  graph.nodes = std::move(nodes);
  graph.branches = {branch};
  std::vector<Branch> parts = divided_at_gaps(graph, map).branches;
  // From left to right.
  std::ranges::sort(parts, {}, [](const Branch& part) { return part.points.front().x; });
  return parts;
}

void expect_columns(const Branch& part, int first, int last) {
  EXPECT_EQ(part.points.front(), (GridPoint{static_cast<double>(first), kRow}));
  EXPECT_EQ(part.points.back(), (GridPoint{static_cast<double>(last), kRow}));
  EXPECT_EQ(part.points.size(), static_cast<std::size_t>(last - first + 1));
}

/// Ten wide, but this wide in one column.
AtColumn narrow_at(int column, double width) {
  return [=](int x) { return x == column ? width : 10.0; };
}

TEST(Gaps, BothPartsEndBesideTheNarrowestAndKnowWhereItIs) {
  const auto parts = divided(row_map(narrow_at(kGapAt, 5)), row_branch());
  ASSERT_EQ(parts.size(), 2U);
  expect_columns(parts[0], kFirst, kGapAt - 1);
  expect_columns(parts[1], kGapAt + 1, kFirst + kPoints - 1);
  for (const Branch& part : parts) {
    EXPECT_EQ(part.from, -1);
    EXPECT_EQ(part.to, -1);
    EXPECT_FALSE(part.is_ring);
  }
  EXPECT_FALSE(parts[0].front_tip);
  EXPECT_FALSE(parts[1].back_tip);
  ASSERT_TRUE(parts[0].back_tip && parts[1].front_tip);
  for (const auto& tip : {parts[0].back_tip, parts[1].front_tip}) {
    EXPECT_EQ(tip->at, (GridPoint{kGapAt, kRow}));
    EXPECT_FALSE(tip->thins_out);
  }
}

TEST(Gaps, InkIsDividedBelowSeventyTwoHundredthsAGrooveBelowNinetyThree) {
  EXPECT_EQ(divided(row_map(narrow_at(kGapAt, 7.1)), row_branch()).size(), 2U);
  EXPECT_EQ(divided(row_map(narrow_at(kGapAt, 7.3)), row_branch()).size(), 1U);
  const auto depth = [](double least) { return [=](int x) { return x == kGapAt ? least : 0.8; }; };
  EXPECT_EQ(divided(row_map(ten, depth(0.74)), row_branch()).size(), 2U);
  EXPECT_EQ(divided(row_map(ten, depth(0.75)), row_branch()).size(), 1U);
  // At the ends of a branch there is nothing to divide, and a ring has no parts.
  EXPECT_EQ(divided(row_map(narrow_at(kFirst, 5)), row_branch()).size(), 1U);
  EXPECT_EQ(divided(row_map(narrow_at(kFirst + kPoints - 1, 5)), row_branch()).size(), 1U);
  Branch ring = row_branch();
  ring.is_ring = true;
  EXPECT_EQ(divided(row_map(narrow_at(kGapAt, 5)), ring).size(), 1U);
}

TEST(Gaps, ThereMayBeSeveralInALine) {
  const auto parts =
      divided(row_map([](int x) { return x == 50   ? 6.0
                                         : x == 90 ? 5.0
                                                   : 10.0; }), row_branch());
  ASSERT_EQ(parts.size(), 3U);
  expect_columns(parts[0], kFirst, 49);
  expect_columns(parts[1], 51, 89);
  expect_columns(parts[2], 91, kFirst + kPoints - 1);
  ASSERT_TRUE(parts[1].front_tip && parts[1].back_tip);
  EXPECT_EQ(parts[1].front_tip->at.x, 50);
  EXPECT_EQ(parts[1].back_tip->at.x, 90);
}

/// Values that are whole eleven columns from the gap.
AtColumn shoulders(double left, double right, double least, double end, double whole) {
  return [=](int x) {
    if (x == kGapAt) return least;
    const int away = std::abs(x - kGapAt);
    return away > 11 ? whole : away == 11 ? end : x < kGapAt ? left : right;
  };
}

TEST(Gaps, APartThinsOutThatFallsOffMoreSlowlyThanARoundEnd) {
  // A round end of radius 9.6 is 7.9 wide half way over 11 columns, which 0.12 of its width more makes 9.02.
  const auto ink = divided(row_map(shoulders(9.3, 8.9, 5, 9.6, 10)), row_branch());
  ASSERT_EQ(ink.size(), 2U);
  expect_columns(ink[0], kFirst, kGapAt - 11);
  expect_columns(ink[1], kGapAt + 11, kFirst + kPoints - 1);
  EXPECT_TRUE(ink[0].back_tip->thins_out);
  EXPECT_FALSE(ink[1].front_tip->thins_out);
  const auto mirrored = divided(row_map(shoulders(8.9, 9.3, 5, 9.6, 10)), row_branch());
  ASSERT_EQ(mirrored.size(), 2U);
  EXPECT_FALSE(mirrored[0].back_tip->thins_out);
  EXPECT_TRUE(mirrored[1].front_tip->thins_out);
  // The round end of a groove is (1 - 0.55^2)^2 as deep there: 0.61 with the 0.12 more.
  const auto groove = divided(row_map(ten, shoulders(0.50, 0.47, 0.4, 0.8, 0.8)), row_branch());
  ASSERT_EQ(groove.size(), 2U);
  expect_columns(groove[0], kFirst, kGapAt - 11);
  EXPECT_TRUE(groove[0].back_tip->thins_out);
  EXPECT_FALSE(groove[1].front_tip->thins_out);
}

TEST(Gaps, WhereNoEndIsWholeNearTheGapBothPartsReachIt) {
  const auto far = [](int x) { return x == kGapAt ? 5.0 : std::abs(x - kGapAt) < 12 ? 9.3 : 10.0; };
  const auto parts = divided(row_map(far), row_branch());
  ASSERT_EQ(parts.size(), 2U);
  expect_columns(parts[0], kFirst, kGapAt);
  expect_columns(parts[1], kGapAt, kFirst + kPoints - 1);
  EXPECT_FALSE(parts[0].back_tip->thins_out);
}

TEST(Gaps, ABranchThatTouchesANodeWithItsLastPointIsOnlyCutOffFromIt) {
  const int last = kFirst + kPoints - 1;
  Branch branch = row_branch();
  branch.to = 0;
  const auto radius = [=](int x) { return x == last ? 5.0 : x < last && x >= last - 11 ? 9.3 : 10.0; };
  const auto parts = divided(row_map(radius), branch, {{{last + 1.0, kRow}, 10}});
  ASSERT_EQ(parts.size(), 1U);
  expect_columns(parts[0], kFirst, last);
  EXPECT_EQ(parts[0].to, -1);
  ASSERT_TRUE(parts[0].back_tip);
  EXPECT_EQ(parts[0].back_tip->at.x, last);
}

TEST(Gaps, TheyAreSoughtWithinTwoAndAHalfOfTheWidestRadiusAround) {
  // To the right the groove is whole only 30 columns away, farther than 2.5 x 10.
  const auto depth = [](int x) {
    const int away = x - kGapAt;
    if (away == 0) return 0.59;
    return away > 0 && away < 30 ? 0.6 + 0.001 * away : 0.8;
  };
  const auto wide_at = [](int column) { return [=](int x) { return x == column ? 30.0 : 10.0; }; };
  EXPECT_EQ(divided(row_map(ten, depth), row_branch()).size(), 1U);
  for (const int side : {-1, 1}) {
    EXPECT_EQ(divided(row_map(wide_at(kGapAt + side * 12), depth), row_branch()).size(), 2U) << side;
    EXPECT_EQ(divided(row_map(wide_at(kGapAt + side * 13), depth), row_branch()).size(), 1U) << side;
  }
}

TEST(Gaps, WhatRemainsBesideANodeIsItsRimUpToFiveQuartersOfItsRadius) {
  Branch branch = row_branch();
  branch.from = 0;
  // 25 points stand between the node and the gap.
  const auto from_node = [&](double radius) {
    return divided(row_map(narrow_at(kFirst + 25, 5)), branch, {{{kFirst - 1, kRow}, radius}});
  };
  const auto kept = from_node(20);
  ASSERT_EQ(kept.size(), 2U);
  expect_columns(kept[0], kFirst, kFirst + 24);
  EXPECT_EQ(kept[0].from, 0);
  EXPECT_EQ(kept[0].to, -1);
  EXPECT_EQ(kept[1].from, -1);
  const auto rest = from_node(20.1);
  ASSERT_EQ(rest.size(), 1U);
  expect_columns(rest[0], kFirst + 26, kFirst + kPoints - 1);
  ASSERT_TRUE(rest[0].front_tip);
  EXPECT_EQ(rest[0].front_tip->at.x, kFirst + 25);
  // The same at the other end, with another node.
  branch.from = -1;
  branch.to = 1;
  const auto to_node = [&](double radius) {
    const int last = kFirst + kPoints - 1;
    return divided(row_map(narrow_at(last - 25, 5)), branch, {{{1, 1}, 1}, {{last + 1.0, kRow}, radius}});
  };
  ASSERT_EQ(to_node(20).size(), 2U);
  EXPECT_EQ(to_node(20)[1].to, 1);
  EXPECT_EQ(to_node(20)[1].points.size(), 25U);
  ASSERT_EQ(to_node(20.1).size(), 1U);
  expect_columns(to_node(20.1)[0], kFirst, kFirst + kPoints - 27);
}

}  // namespace
}  // namespace nazori::author
