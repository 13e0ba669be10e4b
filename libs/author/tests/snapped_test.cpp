// SPDX-License-Identifier: Apache-2.0
#include "snapped.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace nazori::author::test {
namespace {

using geometry::GlyphPoint;

constexpr double kGate = 2.5;
constexpr double kStay = 0.002;
constexpr double kAlike = 6;
constexpr double kEnd = 8;

GlyphLine flat(double from, double to, double y) {
  GlyphLine line;
  for (double x = from; x <= to; x += 1) line.push_back({x, y});
  return line;
}

/// The middle of a flat stroke of ink.
void add_flat(Ridge& ridge, double from, double to, double y, double step = 0.5) {
  for (double x = from; x <= to; x += step) ridge.points.push_back({{x, y}, {1, 0}, true});
}

/// One coordinate of a line's points: each is pulled to its goals, to where it is, and to moving as its
/// neighbours do. Solved by elimination, as the sum of squares by its definition.
struct Pull {
  double goal = 0;
  double weight = 0;
};
std::vector<double> moved(const std::vector<Pull>& pulls) {
  const std::size_t count = pulls.size();
  std::vector<double> diagonal(count);
  std::vector<double> right(count);
  for (std::size_t i = 0; i < count; ++i) {
    diagonal[i] = kStay + pulls[i].weight + (i > 0 ? kAlike : 0) + (i + 1 < count ? kAlike : 0);
    right[i] = pulls[i].weight * pulls[i].goal;
  }
  for (std::size_t i = 1; i < count; ++i) {
    const double share = -kAlike / diagonal[i - 1];
    diagonal[i] += share * kAlike;
    right[i] -= share * right[i - 1];
  }
  std::vector<double> out(count);
  for (std::size_t i = count; i-- > 0;)
    out[i] = (right[i] + (i + 1 < count ? kAlike * out[i + 1] : 0)) / diagonal[i];
  return out;
}

Snapped snapped_alone(const GlyphLine& line, const Ridge& ridge, bool thins_out = false) {
  return snapped({line}, {thins_out}, ridge, kGate).front();
}

std::size_t on_ink(const Snapped& found) {
  return static_cast<std::size_t>(std::ranges::count(found.is_on_ink, true));
}

TEST(Snapped, ALineGoesToTheMiddleOfTheInkBesideIt) {
  Ridge ridge;
  add_flat(ridge, 15, 85, 51.3);
  const Snapped found = snapped_alone(flat(20, 80, 50), ridge);
  EXPECT_EQ(on_ink(found), 61U);
  for (std::size_t i = 0; i < found.line.size(); ++i) {
    EXPECT_NEAR(found.line[i].x, 20 + static_cast<double>(i), 1e-9);
    EXPECT_NEAR(found.line[i].y, 50 + 1.3 / (1 + kStay), 1e-9);
  }
}

TEST(Snapped, TheOffsetIsThatStraightBesideThePoint) {
  Ridge ridge;
  const double l = std::hypot(1.0, 0.03);
  for (double x = 15.2; x <= 85; x += 0.6)
    ridge.points.push_back({{x, 50.2 + 0.03 * (x - 20)}, {1 / l, 0.03 / l}, true});
  const Snapped found = snapped_alone(flat(20, 80, 50), ridge);
  std::vector<Pull> pulls;
  for (int i = 0; i <= 60; ++i) pulls.push_back({0.2 + 0.03 * i, 1});
  const auto truth = moved(pulls);
  ASSERT_EQ(on_ink(found), 61U);
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NEAR(found.line[i].y, 50 + truth[i], 1e-9) << i;
}

TEST(Snapped, WithoutInkNearItALineStays) {
  Ridge far;
  add_flat(far, 15, 85, 50 + kGate + 0.7);
  Ridge near;
  add_flat(near, 15, 85, 50 + kGate + 0.5);
  const GlyphLine line = flat(20, 80, 50);
  EXPECT_EQ(on_ink(snapped_alone(line, far)), 0U);
  EXPECT_EQ(snapped_alone(line, far).line, line);
  EXPECT_EQ(on_ink(snapped_alone(line, near)), 61U);
  EXPECT_EQ(snapped_alone(line, {}).line, line);
}

TEST(Snapped, InkIsBesideAPointUpToOneUnitAlongTheLine) {
  const auto last = [](double to) {
    Ridge ridge;
    for (double x = to; x > 15; x -= 0.5) ridge.points.push_back({{x, 50.5}, {1, 0}, true});
    const Snapped found = snapped_alone(flat(20, 80, 50), ridge);
    return 19 + on_ink(found);
  };
  EXPECT_EQ(last(49.7), 50U);
  EXPECT_EQ(last(50.1), 51U);
  EXPECT_EQ(last(50), 51U);
}

TEST(Snapped, OnlyInkOfAboutTheSameDirectionCounts) {
  const auto found = [](double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    Ridge ridge;
    for (double x = 15; x <= 85; x += 1)
      ridge.points.push_back({{x, 50.5}, {std::cos(a), std::sin(a)}, true});
    return on_ink(snapped_alone(flat(20, 80, 50), ridge));
  };
  EXPECT_EQ(found(0), 61U);
  EXPECT_EQ(found(180), 61U);
  EXPECT_EQ(found(41), 61U);
  EXPECT_EQ(found(42), 0U) << "its cosine is less than 0.75";
}

TEST(Snapped, InkBesideAJunctionSaysWhichLineButNotWhere) {
  Ridge ridge;
  add_flat(ridge, 15, 85, 51);
  for (RidgePoint& p : ridge.points)
    if (p.at.x > 40 && p.at.x < 60) p.is_sure = false;
  const Snapped found = snapped_alone(flat(20, 80, 50), ridge);
  // The last sure ones are at 40 and 60, one unit from 41 and 59.
  for (int x = 20; x <= 80; ++x)
    EXPECT_EQ(found.is_on_ink[static_cast<std::size_t>(x - 20)], x <= 41 || x >= 59);
  std::vector<Pull> pulls;
  for (int x = 20; x <= 80; ++x) pulls.push_back({1, x <= 41 || x >= 59 ? 1.0 : 0.0});
  const auto truth = moved(pulls);
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NEAR(found.line[i].y, 50 + truth[i], 1e-9);
}

TEST(Snapped, ALineStaysOnTheInkThatGoesOnWithIt) {
  // A short piece that is nearer does not draw it away; one that goes on where the first ends does.
  for (const bool is_long : {false, true}) {
    Ridge ridge;
    add_flat(ridge, 15, is_long ? 55 : 85, 51.5);
    add_flat(ridge, 48, is_long ? 85 : 51, 49.5);
    const Snapped found = snapped_alone(flat(20, 80, 50), ridge);
    EXPECT_GT(found.line[5].y, 51);
    EXPECT_GT(found.line[15].y, 51);
    if (!is_long) {
      for (const GlyphPoint p : found.line) EXPECT_NEAR(p.y, 50 + 1.5 / (1 + kStay), 1e-9);
    } else {
      EXPECT_LT(found.line[50].y, 49.7);
    }
  }
}

TEST(Snapped, OfTwoInksAsLongTheNearerOneIsTaken) {
  for (const double side : {1.0, -1.0}) {
    Ridge ridge;
    add_flat(ridge, 15, 85, 50 + 2.2 * side);
    add_flat(ridge, 15, 85, 50 - 0.8 * side);
    const Snapped found = snapped_alone(flat(20, 80, 50), ridge);
    for (const GlyphPoint p : found.line) EXPECT_NEAR(p.y, 50 - 0.8 * side / (1 + kStay), 1e-9);
  }
}

TEST(Snapped, AroundACornerBothPartsHaveOffsetsOfTheirOwn) {
  GlyphLine line = flat(20, 60, 50);
  for (double y = 51; y <= 90; y += 1) line.push_back({60, y});
  Ridge ridge;
  add_flat(ridge, 15, 62, 48.2);
  for (double y = 48; y <= 95; y += 0.5) ridge.points.push_back({{58.2, y}, {0, 1}, true});
  const Snapped found = snapped_alone(line, ridge);
  EXPECT_NEAR(found.line[10].y, 48.2, 0.05);
  EXPECT_NEAR(found.line[70].x, 58.2, 0.05);
}

/// The end of a line from (20, 50) to (80, 50) where the only free end of ink is this one.
GlyphPoint end_with(const RidgeEnd& end, bool thins_out = false) {
  Ridge ridge;
  ridge.ends = {end};
  return snapped_alone(flat(20, 80, 50), ridge, thins_out).line.back();
}

TEST(Snapped, AnEndGoesToTheFreeEndOfTheInkNearIt) {
  std::vector<Pull> x(61);
  std::vector<Pull> y(61);
  x[60] = {2, kEnd};
  y[60] = {-1, kEnd};
  Ridge ridge;
  ridge.ends = {{{82, 49}, {1, 0}, false}};
  const Snapped found = snapped_alone(flat(20, 80, 50), ridge);
  const auto truth_x = moved(x);
  const auto truth_y = moved(y);
  for (std::size_t i = 0; i < found.line.size(); ++i) {
    EXPECT_NEAR(found.line[i].x, 20 + static_cast<double>(i) + truth_x[i], 1e-9) << i;
    EXPECT_NEAR(found.line[i].y, 50 + truth_y[i], 1e-9) << i;
  }
  EXPECT_EQ(on_ink(found), 0U);
  // The start as well.
  ridge.ends = {{{18, 49}, {-1, 0}, false}};
  const Snapped other = snapped_alone(flat(20, 80, 50), ridge);
  EXPECT_NEAR(other.line.front().x, 20 - truth_x[60], 1e-9);
  EXPECT_NEAR(other.line.front().y, 50 + truth_y[60], 1e-9);
}

TEST(Snapped, AFreeEndIsNearByDistanceAndDirection) {
  // Within 1.6 gates; along the line 0.6 of the distance counts, beside it 1.4.
  const GlyphPoint stays{80, 50};
  EXPECT_NE(end_with({{86.6, 50}, {1, 0}}), stays);
  EXPECT_EQ(end_with({{86.7, 50}, {1, 0}}), stays);
  EXPECT_NE(end_with({{73.4, 50}, {1, 0}}), stays);
  EXPECT_EQ(end_with({{73.3, 50}, {1, 0}}), stays);
  EXPECT_NE(end_with({{80, 52.85}, {1, 0}}), stays);
  EXPECT_EQ(end_with({{80, 52.87}, {1, 0}}), stays);
  EXPECT_NE(end_with({{84, 52}, {1, 0}}), stays) << "hypot(2.4, 2.8) = 3.69";
  EXPECT_EQ(end_with({{85, 52}, {1, 0}}), stays) << "hypot(3, 2.8) = 4.1";
  EXPECT_NE(end_with({{81, 50}, {0.61, std::sqrt(1 - 0.61 * 0.61)}}), stays);
  EXPECT_EQ(end_with({{81, 50}, {0.59, std::sqrt(1 - 0.59 * 0.59)}}), stays);
  // Three units for the opposite direction of half a right angle and so on: 0.6 * 4.5 + 3 * 0.4 = 3.9.
  EXPECT_NE(end_with({{84.5, 50}, {0.61, std::sqrt(1 - 0.61 * 0.61)}}), stays);
  EXPECT_EQ(end_with({{84.9, 50}, {0.61, std::sqrt(1 - 0.61 * 0.61)}}), stays);
}

TEST(Snapped, AnEndOfInkBelongsToTheNearestLineAlone) {
  Ridge ridge;
  // Five units apart, so that neither touches the other.
  ridge.ends = {{{82, 52.6}, {1, 0}, false}};
  const std::vector<GlyphLine> lines{flat(20, 80, 50), flat(20, 80, 55)};
  const auto found = snapped(lines, {false, false}, ridge, kGate);
  EXPECT_EQ(found[0].line, lines[0]);
  EXPECT_GT(found[1].line.back().x, 81.5);
  // With one more end both have one.
  ridge.ends.push_back({{82, 50}, {1, 0}, false});
  const auto both = snapped(lines, {false, false}, ridge, kGate);
  EXPECT_GT(both[0].line.back().x, 81.5);
  EXPECT_NEAR(both[0].line.back().y, 50, 1e-9);
  EXPECT_LT(both[1].line.back().y, 53);
}

TEST(Snapped, AnEndThatTouchesIsNotThatOfALineThatEndsInOtherInk) {
  // The first line ends beside a falling one.
  const auto moves = [](double beside, bool touches, bool thins_out) {
    GlyphLine falling;
    for (double y = 20; y <= 90; y += 1) falling.push_back({80 + beside, y});
    Ridge ridge;
    ridge.ends = {{{81, 50}, {1, 0}, touches}};
    const auto found = snapped({flat(20, 80, 50), falling}, {thins_out, false}, ridge, kGate);
    // It is free to stay where the other line does not move.
    return found[0].line.back().x > 80.2;
  };
  EXPECT_TRUE(moves(1.5, false, false));
  EXPECT_FALSE(moves(1.5, true, false));
  EXPECT_TRUE(moves(1.7, true, false));
  EXPECT_FALSE(moves(1.7, true, true));
  EXPECT_FALSE(moves(3.9, true, true));
  EXPECT_TRUE(moves(4.1, true, true));
}

TEST(Snapped, AnEndOnAnotherLineMovesWithIt) {
  // The falling line is two units farther to the right than its ink, where the flat one ends on it.
  const auto end_beside = [](double gap) {
    GlyphLine falling;
    for (double y = 20; y <= 90; y += 1) falling.push_back({60, y});
    Ridge ridge;
    for (double y = 15; y <= 95; y += 0.5) ridge.points.push_back({{62, y}, {0, 1}, true});
    return snapped({flat(20, 60 - gap, 50), falling}, {false, false}, ridge, kGate)[0].line.back();
  };
  std::vector<Pull> pulls(38);
  pulls.back() = {2 / (1 + kStay), kEnd};
  EXPECT_NEAR(end_beside(3).x, 57 + moved(pulls).back(), 1e-9);
  EXPECT_NEAR(end_beside(3).y, 50, 1e-9);
  EXPECT_GT(end_beside(4).x, 57);
  EXPECT_EQ(end_beside(5), (GlyphPoint{55, 50}));
}

}  // namespace
}  // namespace nazori::author::test
