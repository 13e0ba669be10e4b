// SPDX-License-Identifier: Apache-2.0
#include "../src/stroke_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "test_strokes.h"

namespace nazori::carving {
namespace {

using namespace test;

TEST(StrokeSet, IsTheSameForEveryOrderInWhichStrokesAreGiven) {
  std::vector<StrokeLine> strokes{stroke({{1, 1}, {2, 2}}), stroke({{1, 1}, {2, 3}}), stroke({{1, 1}}),
                                  stroke({{1, 1}, {2, 2}}, StrokeEnding::taper), stroke({{0, 9}, {5, 5}})};
  std::vector<std::size_t> order{0, 1, 2, 3, 4};
  std::vector<StrokeLine> first;
  do {
    std::vector<StrokeLine> given;
    for (const std::size_t i : order) given.push_back(strokes[i]);
    std::vector<StrokeLine> set;
    for (const StrokeLine* line : stroke_set(given)) set.push_back(*line);
    ASSERT_EQ(set.size(), 5U);
    if (first.empty()) first = set;
    EXPECT_EQ(set, first);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(StrokeSet, HoldsStrokesOnceUnlessTheyEndDifferently) {
  const std::vector<StrokeLine> strokes{stroke({{1, 1}, {2, 2}}),
                                        stroke({{1, 1}, {2, 2}}, StrokeEnding::hook),
                                        stroke({{1, 1}, {2, 2}}), stroke({{2, 2}, {1, 1}})};
  EXPECT_EQ(stroke_set(strokes).size(), 3U);
  EXPECT_TRUE(stroke_set({}).empty());
}

TEST(Carve, TakesBrushesAndPointsUpToTheirLimits) {
  const std::vector strokes{stroke({{10, 10}, {90, 90}})};
  for (const double width : {0.5, 40.0}) EXPECT_TRUE(carve(strokes, 16, {.width = width})) << width;
  EXPECT_FALSE(carve(strokes, 16, {.width = 40.5}));
  for (const double depth : {1e-6, 1.0}) EXPECT_TRUE(carve(strokes, 16, {.depth = depth})) << depth;
  for (const double far : {-1090.0, 1199.0}) {
    EXPECT_TRUE(carve(std::vector{stroke({{far, 1}, {1, 1}})}, 16)) << far;
    EXPECT_TRUE(carve(std::vector{stroke({{1, far}, {1, 1}})}, 16)) << far;
  }
  EXPECT_FALSE(carve(std::vector{stroke({{1, 1199.1}})}, 16));
  EXPECT_FALSE(carve(std::vector{stroke({{-1090.1, 1}})}, 16));
}

}  // namespace
}  // namespace nazori::carving
