// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "../src/stroke_geometry.h"

namespace nazori::view {
namespace {

using geometry::GlyphPoint;
using Points = std::vector<GlyphPoint>;
using Ends = std::vector<std::size_t>;

constexpr double kRadian = std::numbers::pi / 180;

GlyphPoint on_the_way(GlyphPoint from, double length, double degrees) {
  return {from.x + length * std::cos(degrees * kRadian), from.y + length * std::sin(degrees * kRadian)};
}

/// Two legs with a turn between them.
Points bend(double first, double second, double degrees) {
  const GlyphPoint corner{20 + first, 50};
  return {{20, 50}, corner, on_the_way(corner, second, degrees)};
}

const Ends kNoCorner{2}, kACorner{1, 2};

TEST(RunEnds, ATurnOfThirtyFiveDegreesIsACornerToEitherSide) {
  for (const double side : {1.0, -1.0}) {
    // Legs too short to be straight pieces.
    EXPECT_EQ(run_ends(bend(5.5, 5.5, side * 34)), kNoCorner);
    EXPECT_EQ(run_ends(bend(5.5, 5.5, side * 36)), kACorner);
    EXPECT_EQ(run_ends(bend(5.5, 5.5, side * 170)), kACorner);
  }
}

TEST(RunEnds, BetweenStraightPiecesOfSixUnitsEightDegreesAreEnough) {
  EXPECT_EQ(run_ends(bend(30, 30, 7.9)), kNoCorner);
  EXPECT_EQ(run_ends(bend(30, 30, 8.1)), kACorner);
  EXPECT_EQ(run_ends(bend(6.01, 6.01, -20)), kACorner);
  EXPECT_EQ(run_ends(bend(5.99, 6.01, -20)), kNoCorner);
  EXPECT_EQ(run_ends(bend(6.01, 5.99, -20)), kNoCorner);
}

TEST(RunEnds, ThePressAtTheStartAndTheRoundingAtTheEndAreNoRuns) {
  EXPECT_EQ(run_ends(bend(4.9, 30, 90)), kNoCorner);
  EXPECT_EQ(run_ends(bend(5.1, 30, 90)), kACorner);
  EXPECT_EQ(run_ends(bend(30, 2.4, 90)), kNoCorner);
  EXPECT_EQ(run_ends(bend(30, 2.6, 90)), kACorner);
}

TEST(RunEnds, ATurnCountsOverTwoAndAHalfUnitsBeforeAndAfterThePoint) {
  // Three turns of fifteen degrees: together a corner if they lie near enough, and the middle one stands for
  // it.
  const auto turns = [](double apart) {
    Points points{{20, 50}, {40, 50}};
    for (const double degrees : {15.0, 30.0}) points.push_back(on_the_way(points.back(), apart, degrees));
    points.push_back(on_the_way(points.back(), 20, 45));
    return run_ends(points);
  };
  EXPECT_EQ(turns(0.3), (Ends{2, 4}));
  EXPECT_EQ(turns(2.4), (Ends{4}));
}

TEST(RunEnds, CornersThatAreCloserThanTwoAndAHalfUnitsAreOneAtTheSharpest) {
  const auto step = [](double apart, double first, double second) {
    Points points{{20, 50}, {40, 50}};
    points.push_back(on_the_way(points.back(), apart, first));
    points.push_back(on_the_way(points.back(), 20, first + second));
    return run_ends(points);
  };
  EXPECT_EQ(step(2.6, 80, 80), (Ends{1, 2, 3}));
  EXPECT_EQ(step(2.4, 80, 100), (Ends{2, 3}));
  EXPECT_EQ(step(2.4, 100, 80), (Ends{1, 3}));
  // A cluster ends where the next corner is far; what comes after it counts for itself.
  Points zigzag{{20, 50}};
  for (const double length : {20.0, 1.0, 1.0, 10.0, 10.0})
    zigzag.push_back(on_the_way(zigzag.back(), length, zigzag.size() % 2 == 0 ? 60 : 0));
  EXPECT_EQ(run_ends(zigzag).size(), 3U);
}

TEST(RunEnds, AFlattenedCurveHasNoCorners) {
  Points curve;
  for (int degrees = 0; degrees <= 180; degrees += 3) curve.push_back(on_the_way({50, 50}, 20, degrees));
  EXPECT_EQ(run_ends(curve), Ends{curve.size() - 1});
}

TEST(RunEnds, WhatHasNoLengthHasNone) {
  EXPECT_TRUE(run_ends(Points{}).empty());
  EXPECT_TRUE(run_ends(Points{{1, 1}}).empty());
  EXPECT_TRUE(run_ends(Points{{1, 1}, {1, 1}}).empty());
  // A repeated point is no corner, and hides none.
  EXPECT_EQ(run_ends(Points{{20, 50}, {40, 50}, {40, 50}, {60, 50}}), Ends{3});
}

kanji::StrokeLine stroke(Points points) {
  kanji::StrokeLine line;
  line.points = std::move(points);
  return line;
}

const geometry::TabletShape kHand{};
constexpr double kUnit_m = 0.1 / 109;  // of the glyph box on a tablet of 10 cm

glm::dvec2 metres(GlyphPoint p) { return {(p.x - 54.5) * kUnit_m, (54.5 - p.y) * kUnit_m}; }

void expect_at(glm::vec2 found_m, GlyphPoint wanted) {
  EXPECT_NEAR(found_m.x, metres(wanted).x, 1e-7);
  EXPECT_NEAR(found_m.y, metres(wanted).y, 1e-7);
}

TEST(StrokeGeometry, HasALineForEachPieceWithTheNumberOfItsStroke) {
  const auto made = make_stroke_geometry(
      std::vector{stroke({{10, 20}, {30, 20}, {30, 20}, {30, 50}}), stroke({{70, 80}}), stroke({})}, {},
      kHand);
  ASSERT_EQ(made.lines.size(), 4U) << "a repeated point makes none";
  const std::vector<std::pair<GlyphPoint, GlyphPoint>> wanted{
      {{10, 20}, {30, 20}}, {{30, 20}, {30, 50}}, {{70, 80}, {70, 80}}, {{0, 0}, {0, 0}}};
  const std::vector<float> strokes{1, 1, 2, 3};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    expect_at(made.lines[i].from_m, wanted[i].first);
    expect_at(made.lines[i].to_m, wanted[i].second);
    EXPECT_EQ(made.lines[i].stroke, strokes[i]);
  }
  EXPECT_EQ(made.shown_lines, 4U);
  ASSERT_EQ(made.heads.size(), 2U) << "one at the corner, one at the end, none of a dot";
  EXPECT_EQ(made.shown_heads, 2U);
  ASSERT_EQ(made.anchors.size(), 3U);
  EXPECT_NEAR(made.anchors[1].start.x, metres({70, 80}).x, 1e-12);
  EXPECT_NEAR(made.anchors[1].start.y, metres({70, 80}).y, 1e-12);
}

TEST(StrokeGeometry, AHeadOf2005IsTwoLinesOfFiveGridUnitsThirtyDegreesApartFromTheStroke) {
  const auto made = make_stroke_geometry(std::vector{stroke({{10, 20}, {60, 20}})}, {}, kHand);
  ASSERT_EQ(made.classic_heads.size(), 2U);
  EXPECT_EQ(made.shown_classic_heads, 2U);
  const double size_m = 5 * 0.1 / 127;
  std::vector<double> sides;
  for (const LinePiece& piece : made.classic_heads) {
    expect_at(piece.from_m, {60, 20});
    EXPECT_EQ(piece.stroke, 1);
    const glm::vec2 back = piece.to_m - piece.from_m;
    EXPECT_NEAR(back.x, -size_m * std::cos(30 * kRadian), 1e-8);
    sides.push_back(back.y);
  }
  std::sort(sides.begin(), sides.end());
  EXPECT_NEAR(sides[0], -size_m / 2, 1e-8);
  EXPECT_NEAR(sides[1], size_m / 2, 1e-8);
}

/// A relief on which `height` tells the height at a point of the glyph box.
template <class Height>
Relief relief_of(int size, Height height) {
  Relief relief;
  relief.size = size;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      relief.heights.push_back(
          static_cast<float>(height(109.0 * column / (size - 1), 109.0 * row / (size - 1))));
  return relief;
}

/// A groove around a line across, as high as `plateau` from `half_width` on.
auto groove(double half_width, double plateau = 1) {
  return [=](double, double y) { return std::abs(y - 54.5) >= half_width ? plateau : 0.3; };
}

TEST(StrokeGeometry, InkFillsTheGrooveInStepsOfOneUnit) {
  constexpr double kHalf = 6;
  const auto made =
      make_stroke_geometry(std::vector{stroke({{20, 54.5}, {60.4, 54.5}}), stroke({{80, 54.5}})},
                           relief_of(512, groove(kHalf)), kHand);
  ASSERT_EQ(made.ink_ranges.size(), 2U);
  const InkRange& range = made.ink_ranges[0];
  EXPECT_EQ(range.first, 0U);
  EXPECT_EQ(range.count, 41U) << "none is longer than a unit";
  EXPECT_NEAR(range.length_m, 40.4 * kUnit_m, 1e-12);
  const double step = 40.4 / 41;
  for (std::size_t i = 0; i < range.count; ++i) {
    const InkPiece& piece = made.ink[i];
    const auto k = static_cast<double>(i);
    expect_at(piece.from_m, {20 + k * step, 54.5});
    expect_at(piece.to_m, {20 + (k + 1) * step, 54.5});
    EXPECT_NEAR(piece.along_m.x, k * step * kUnit_m, 1e-7);
    EXPECT_NEAR(piece.along_m.y, (k + 1) * step * kUnit_m, 1e-7);
    // The groove is felt for in steps of a fifth of a unit, on samples a fifth of a unit apart.
    EXPECT_NEAR(piece.radius_m.x, kHalf * kUnit_m, 0.35 * kUnit_m);
    EXPECT_NEAR(piece.radius_m.y, kHalf * kUnit_m, 0.35 * kUnit_m);
  }
  EXPECT_EQ(made.ink_ranges[1].first, 41U);
  EXPECT_EQ(made.ink_ranges[1].count, 1U) << "a dot has a piece, too";
  EXPECT_EQ(made.ink_ranges[1].length_m, 0);
  expect_at(made.ink[41].from_m, {80, 54.5});
  expect_at(made.ink[41].to_m, {80, 54.5});
}

TEST(StrokeGeometry, InkReachesToTheNearerEdge) {
  // The groove is 3 units wide to the one side and 9 to the other, and so is its mirror image.
  for (const bool mirrored : {false, true}) {
    const auto made = make_stroke_geometry(std::vector{stroke({{20, 54.5}, {80, 54.5}})},
                                           relief_of(512,
                                                     [&](double, double y) {
                                                       const double below = mirrored ? 54.5 - y : y - 54.5;
                                                       return below < 9 && below > -3 ? 0.3 : 1.0;
                                                     }),
                                           kHand);
    EXPECT_NEAR(made.ink[30].radius_m.x, 3 * kUnit_m, 0.35 * kUnit_m);
  }
}

TEST(StrokeGeometry, WhereGroovesCrossInkIsNoWider) {
  for (const bool at_the_start : {false, true}) {
    const double crossing = at_the_start ? 20 : 50;
    const auto made = make_stroke_geometry(
        std::vector{stroke({{20, 54.5}, {80, 54.5}})},
        relief_of(512,
                  [&](double x, double y) {
                    return std::abs(y - 54.5) < 4 || std::abs(x - crossing) < 5 ? 0.3 : 1.0;
                  }),
        kHand);
    for (const InkPiece& piece : made.ink) {
      EXPECT_NEAR(piece.radius_m.x, 4 * kUnit_m, 0.35 * kUnit_m) << piece.from_m.x;
      EXPECT_NEAR(piece.radius_m.y, 4 * kUnit_m, 0.35 * kUnit_m) << piece.to_m.x;
    }
  }
}

TEST(StrokeGeometry, AcrossACrossingTheWidthOfATaperGoesOnEvenly) {
  // From 6 to 4 units over 60 units along; a groove crosses the middle.
  const auto half = [](double x) { return 6 - 2 * (x - 20) / 60; };
  const auto made = make_stroke_geometry(
      std::vector{stroke({{20, 54.5}, {80, 54.5}})},
      relief_of(1024,
                [&](double x, double y) {
                  return std::abs(y - 54.5) < half(x) || std::abs(x - 65) < 5 ? 0.3 : 1.0;
                }),
      kHand);
  for (const InkPiece& piece : made.ink) {
    const double x = piece.from_m.x / kUnit_m + 54.5;
    // The widest are held to 6 % above the middle width.
    if (x > 40) {
      EXPECT_NEAR(piece.radius_m.x, half(x) * kUnit_m, 0.5 * kUnit_m) << x;
    }
  }
}

TEST(StrokeGeometry, WithoutAReliefInkIsTwoAndAHalfUnitsToEachSideAndNeverMoreThanTwenty) {
  const std::vector strokes{stroke({{20, 54.5}, {80, 54.5}})};
  EXPECT_NEAR(make_stroke_geometry(strokes, {}, kHand).ink[10].radius_m.x, 2.5 * kUnit_m, 1e-7);
  const auto wide = make_stroke_geometry(strokes, relief_of(128, groove(40)), kHand);
  EXPECT_NEAR(wide.ink[10].radius_m.x, 20 * kUnit_m, 1e-7);
}

TEST(StrokeGeometry, ThePlateauIsTheMostFrequentHeightOfTheUpperHalf) {
  const auto plateau = [](double half_width, double height) {
    return make_stroke_geometry(std::vector{stroke({{20, 54.5}, {80, 54.5}})},
                                relief_of(128, groove(half_width, height)), kHand)
        .plateau;
  };
  EXPECT_NEAR(plateau(5, 1), 1, 1e-6);
  // The upper edge of its step of a 2048th.
  EXPECT_GE(plateau(5, 0.8), 0.8F);
  EXPECT_LE(plateau(5, 0.8), 0.8 + 1.01 / 2048);
  EXPECT_GE(plateau(5, 0.5), 0.5F);
  EXPECT_LE(plateau(5, 0.5), 0.5 + 1.01 / 2048);
  EXPECT_EQ(plateau(5, 0.45), 1) << "that is all groove";
  // A lower plateau has its ink as wide.
  const auto low = make_stroke_geometry(std::vector{stroke({{20, 54.5}, {80, 54.5}})},
                                        relief_of(512, groove(6, 0.7)), kHand);
  EXPECT_NEAR(low.ink[20].radius_m.x, 6 * kUnit_m, 0.35 * kUnit_m);
}

glm::dvec2 side_of_the_first(std::vector<kanji::StrokeLine> strokes) {
  return make_stroke_geometry(strokes, {}, kHand).anchors.front().side;
}

TEST(StrokeGeometry, ANumberStandsBehindTheStartOfAStrokeAlone) {
  for (int degrees = 0; degrees < 360; degrees += 30) {
    const glm::dvec2 side = side_of_the_first({stroke({{54, 54}, on_the_way({54, 54}, 30, degrees)})});
    EXPECT_NEAR(glm::length(side), 1, 1e-12);
    // Up is up on the tablet, but down in the glyph box.
    const glm::dvec2 behind(-std::cos(degrees * kRadian), std::sin(degrees * kRadian));
    EXPECT_GT(glm::dot(side, behind), 0.75) << degrees;
  }
}

TEST(StrokeGeometry, WhereTwoSidesAreAlikeANumberStandsToTheUpperLeft) {
  const glm::dvec2 across = side_of_the_first({stroke({{54, 54}, {84, 54}})});
  EXPECT_GT(across.y, -0.01);
  const glm::dvec2 down = side_of_the_first({stroke({{54, 54}, {54, 84}})});
  EXPECT_LT(down.x, -0.1);
  EXPECT_GT(down.y, 0.5);
}

TEST(StrokeGeometry, ANumberKeepsClearOfOtherStrokesAndTheirStarts) {
  const auto first = stroke({{54, 54}, {84, 54}});
  const glm::dvec2 alone = side_of_the_first({first});
  ASSERT_LT(alone.x, -0.9);
  // A stroke runs through that place.
  EXPECT_GT(side_of_the_first({first, stroke({{49, 30}, {49, 80}})}).x, -0.6);
  // Another one starts a little behind it.
  EXPECT_GT(side_of_the_first({first, stroke({{42, 54}, {30, 54}})}).x, alone.x);
}

TEST(StrokeGeometry, ANumberStaysOnTheTablet) {
  const auto inside = [](GlyphPoint start, GlyphPoint to) {
    const glm::dvec2 side = side_of_the_first({stroke({start, to})});
    return GlyphPoint{start.x + 7 * side.x, start.y - 7 * side.y};
  };
  EXPECT_GT(inside({1, 54}, {40, 54}).x, 0);
  EXPECT_LT(inside({108, 54}, {60, 54}).x, 109);
  EXPECT_GT(inside({54, 1}, {54, 40}).y, 0);
  EXPECT_LT(inside({54, 108}, {54, 60}).y, 109);
}

}  // namespace
}  // namespace nazori::view
