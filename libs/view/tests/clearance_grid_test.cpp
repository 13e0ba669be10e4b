// SPDX-License-Identifier: Apache-2.0
#include "../src/clearance_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

#include "nazori/geometry/polyline.h"

namespace nazori::view {
namespace {

using geometry::GlyphPoint;
using GlyphLine = geometry::Polyline<geometry::GlyphFrame>;

/// The definition: the least distance to any line.
double slowly(const std::vector<GlyphLine>& lines, GlyphPoint place, double most) {
  for (const GlyphLine& line : lines)
    most = std::min(most, geometry::nearest_point(std::span<const GlyphPoint>(line), place).distance);
  return most;
}

TEST(ClearanceGrid, KnowsTheDistanceToTheNearestLineAsTheDefinitionSays) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> anywhere(-15, 124);
  std::uniform_real_distribution<double> step(-6, 6);
  for (int round = 0; round < 30; ++round) {
    std::vector<GlyphLine> lines;
    for (int k = 0; k < 6; ++k) {
      GlyphLine line{{anywhere(random), anywhere(random)}};
      // Long lines, short ones and single points.
      for (int i = 0; i < 4 * k; ++i) {
        const GlyphPoint next = k % 2 == 0 ? GlyphPoint{anywhere(random), anywhere(random)}
                                           : line.back() + GlyphPoint{step(random), step(random)};
        line.push_back({std::clamp(next.x, -15.0, 124.0), std::clamp(next.y, -15.0, 124.0)});
      }
      lines.push_back(std::move(line));
    }
    const ClearanceGrid grid(lines);
    for (int i = 0; i < 100; ++i) {
      const GlyphPoint place{anywhere(random), anywhere(random)};
      EXPECT_NEAR(grid.at(place, 9), slowly(lines, place, 9), 1e-9);
      EXPECT_NEAR(grid.at(place, 2), slowly(lines, place, 2), 1e-9);
    }
  }
}

TEST(ClearanceGrid, LinesAlongTheBordersOfItsCellsAreFoundFromBothSides) {
  const std::vector<GlyphLine> lines{{{10, 10}, {20, 10}, {20, 30}}, {{-20, -20}, {-20, 129}}};
  const ClearanceGrid grid(lines);
  for (const GlyphPoint place : {GlyphPoint{15, 9}, GlyphPoint{15, 11}, GlyphPoint{19, 20},
                                 GlyphPoint{21, 20}, GlyphPoint{-19.5, 50}, GlyphPoint{15, 10}})
    EXPECT_NEAR(grid.at(place, 9), slowly(lines, place, 9), 1e-12) << place.x << " " << place.y;
  EXPECT_EQ(grid.at({60, 60}, 9), 9);
}

TEST(ClearanceGrid, NoPlaceIsClearWherePiecesCrowd) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> within(40, 41);
  std::vector<GlyphLine> lines(1);
  for (int i = 0; i < 5'000; ++i) lines[0].push_back({within(random), within(random)});
  const ClearanceGrid grid(lines);
  EXPECT_EQ(grid.at({40.5, 40.5}, 9), 0);
  EXPECT_NEAR(grid.at({44, 40.5}, 9), slowly(lines, {44, 40.5}, 9), 0.05);
  EXPECT_NEAR(grid.at({43, 44}, 9), slowly(lines, {43, 44}, 9), 0.1);
}

TEST(ClearanceGrid, NothingIsNear) {
  const ClearanceGrid grid({});
  EXPECT_EQ(grid.at({50, 50}, 9), 9);
}

}  // namespace
}  // namespace nazori::view
