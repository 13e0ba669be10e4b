// SPDX-License-Identifier: Apache-2.0
#include "laid_over.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "nazori/geometry/polyline.h"

namespace nazori::author::test {
namespace {

using geometry::GlyphPoint;

GlyphLine straight(GlyphPoint from, GlyphPoint to) {
  const auto count = static_cast<std::size_t>(std::lround(geometry::distance(from, to))) + 1;
  const GlyphLine ends{from, to};
  return geometry::resample<geometry::GlyphFrame>(ends, count);
}

/// 木 and a box, so that each direction and each corner has lines.
std::vector<GlyphLine> character() {
  return {straight({20, 40}, {90, 40}), straight({55, 15}, {55, 95}), straight({53, 42}, {25, 80}),
          straight({57, 42}, {85, 80})};
}

template <class Move>
std::vector<GlyphLine> moved(std::vector<GlyphLine> lines, Move move) {
  for (GlyphLine& line : lines)
    for (GlyphPoint& p : line) p = move(p);
  return lines;
}

Ridge ridge_along(const std::vector<GlyphLine>& lines) {
  Ridge ridge;
  for (const GlyphLine& line : lines) {
    const auto count = static_cast<std::size_t>(geometry::arc_length<geometry::GlyphFrame>(line) / 0.6) + 2;
    const auto even = geometry::resample<geometry::GlyphFrame>(line, count);
    for (std::size_t i = 0; i < count; ++i) {
      const GlyphPoint way = even[std::min(i + 1, count - 1)] - even[i - std::min<std::size_t>(i, 1)];
      ridge.points.push_back({even[i], way * (1 / geometry::length(way)), true});
    }
  }
  return ridge;
}

double farthest(const std::vector<GlyphLine>& a, const std::vector<GlyphLine>& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    for (std::size_t i = 0; i < a[k].size(); ++i) most = std::max(most, geometry::distance(a[k][i], b[k][i]));
  return most;
}

TEST(LaidOver, LinesThatLieOnTheInkStay) {
  const auto lines = character();
  for (const bool is_in_place : {false, true}) {
    const LaidOver over = laid_over(lines, ridge_along(lines), is_in_place);
    EXPECT_LT(farthest(over.as_a_whole, lines), 1.7);
    EXPECT_LT(farthest(over.bent, lines), 1.5);
  }
}

TEST(LaidOver, AsAWholeTheyAreMovedStretchedAndTurned) {
  const auto lines = character();
  const auto there = moved(lines, [](GlyphPoint p) {
    return GlyphPoint{4 + 1.06 * p.x - 0.04 * p.y, -3 + 0.05 * p.x + 0.95 * p.y};
  });
  const LaidOver over = laid_over(lines, ridge_along(there), true);
  EXPECT_GT(farthest(lines, there), 4);
  EXPECT_LT(farthest(over.as_a_whole, there), 1.8);
  EXPECT_LT(farthest(over.bent, there), 1.6);
}

TEST(LaidOver, BoxesAreBroughtTogetherWhereTheyMayLieElsewhere) {
  const auto lines = character();
  // Twice as small, not as high, and somewhere else.
  const auto there = moved(lines, [](GlyphPoint p) { return GlyphPoint{60 + 0.5 * p.x, 10 + 0.4 * p.y}; });
  const LaidOver over = laid_over(lines, ridge_along(there), false);
  EXPECT_LT(farthest(over.as_a_whole, there), 0.8);
}

TEST(LaidOver, OneSideIsStretchedOnlySoMuchMoreThanTheOther) {
  // The ink is as wide as the lines but only a tenth as high; 0.6 of the larger scale is the least.
  std::vector<GlyphLine> lines{straight({20, 20}, {80, 20}), straight({20, 90}, {80, 90})};
  std::vector<GlyphLine> there{straight({20, 50}, {80, 50}), straight({20, 60}, {80, 60})};
  const LaidOver over = laid_over(lines, ridge_along(there), false);
  EXPECT_LT(over.as_a_whole[0].front().y, 50.5);
  EXPECT_LT(over.as_a_whole[0].front().y, over.as_a_whole[1].front().y);
}

TEST(LaidOver, AreBentWhereTheirPartsHaveMovedApart) {
  const auto lines = character();
  // The upper left goes to the left and the lower right goes down.
  const auto there = moved(lines, [](GlyphPoint p) {
    const auto bell = [&p](double x, double y) {
      return std::exp(-(std::pow(p.x - x, 2) + std::pow(p.y - y, 2)) / 800);
    };
    return p + GlyphPoint{-4 * bell(25, 40), 4 * bell(85, 80)};
  });
  const LaidOver over = laid_over(lines, ridge_along(there), true);
  EXPECT_GT(farthest(over.as_a_whole, there), 2.6);
  EXPECT_LT(farthest(over.bent, there), 2.4);
}

TEST(LaidOver, ParallelLinesAreNotDrawnToInkOfAnotherDirection) {
  // A flat line beside ink that falls: only the flat ink counts.
  const std::vector<GlyphLine> lines{straight({20, 50}, {90, 50})};
  auto there = std::vector<GlyphLine>{straight({20, 53}, {90, 53})};
  Ridge ridge = ridge_along(there);
  const Ridge falling = ridge_along({straight({50, 20}, {50, 48})});
  ridge.points.insert(ridge.points.end(), falling.points.begin(), falling.points.end());
  const LaidOver over = laid_over(lines, ridge, true);
  EXPECT_LT(farthest(over.bent, there), 1.7);
}

TEST(LaidOver, WithoutInkNearByTheyStay) {
  const auto lines = character();
  const LaidOver over = laid_over(lines, ridge_along({straight({500, 500}, {520, 500})}), true);
  EXPECT_LT(farthest(over.as_a_whole, lines), 1e-9);
  EXPECT_LT(farthest(over.bent, lines), 1e-6);
}

}  // namespace
}  // namespace nazori::author::test
