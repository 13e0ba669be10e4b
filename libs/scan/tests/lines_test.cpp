// SPDX-License-Identifier: Apache-2.0
#include "../src/lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nazori/geometry/polyline.h"

namespace nazori::scan {
namespace {

using testing::SizeIs;
using Line = std::vector<writing::WritingPoint>;

/// Ink that is drawn for a test.
class Drawn {
 public:
  [[nodiscard]] bool is_set(int x, int y) const { return ink_[index(x, y)] != 0; }
  Drawn& dot(int x, int y) {
    ink_[index(x, y)] = 1;
    return *this;
  }
  /// All pixels from a corner to the other, with both.
  Drawn& block(int left, int top, int right, int bottom) {
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) dot(x, y);
    return *this;
  }
  /// Every pixel whose centre is so near to the line between two places.
  Drawn& pen(writing::WritingPoint from, writing::WritingPoint to, double radius) {
    for (int y = 0; y < kCellSide; ++y)
      for (int x = 0; x < kCellSide; ++x) {
        const writing::WritingPoint p{static_cast<double>(x), static_cast<double>(y)};
        const writing::WritingPoint d = to - from;
        const double t =
            std::clamp(geometry::dot(p - from, d) / std::max(geometry::dot(d, d), 1e-9), 0.0, 1.0);
        if (geometry::distance(p, from + d * t) <= radius) dot(x, y);
      }
    return *this;
  }
  Drawn& ring(double x0, double y0, double inner, double outer) {
    for (int y = 0; y < kCellSide; ++y)
      for (int x = 0; x < kCellSide; ++x) {
        const double r = std::hypot(x - x0, y - y0);
        if (r >= inner && r <= outer) dot(x, y);
      }
    return *this;
  }
  [[nodiscard]] std::vector<Line> lines() const {
    std::vector<Line> all;
    for (const auto& stroke : lines_of(ink_).strokes) all.push_back(geometry::line_of(stroke));
    return all;
  }
  [[nodiscard]] const InkCell& ink() const { return ink_; }

 private:
  static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * kCellSide + x); }
  InkCell ink_ = InkCell(static_cast<std::size_t>(kCellSide * kCellSide));
};

double length_of(const Line& line) { return geometry::arc_length<writing::WritingFrame>(line); }

/// The line that has an end there, seen from it. Empty where there is none.
Line from_end(const std::vector<Line>& lines, writing::WritingPoint place, double near) {
  for (Line line : lines) {
    if (geometry::distance(line.front(), place) <= near) return line;
    std::reverse(line.begin(), line.end());
    if (geometry::distance(line.front(), place) <= near) return line;
  }
  return {};
}

/// How far a line goes beside the straight one between its ends.
double bend_of(const Line& line) {
  const writing::WritingPoint d = line.back() - line.front();
  double most = 0;
  for (const writing::WritingPoint p : line) {
    const writing::WritingPoint to = p - line.front();
    most = std::max(most, std::abs(d.x * to.y - d.y * to.x) / std::max(geometry::length(d), 1e-9));
  }
  return most;
}

TEST(Lines, WithoutInkThereAreNoStrokes) {
  const auto written = lines_of(Drawn().ink());
  EXPECT_TRUE(written.strokes.empty());
  ASSERT_TRUE(written.box);
  EXPECT_EQ(written.box->corner, (writing::WritingPoint{0, 0}));
  EXPECT_EQ(written.box->side, kCellSide);
}

TEST(Lines, ALineOfSinglePixelsKeepsEveryThirdOfThemAndBothEnds) {
  const Line level{{10, 64}, {13, 64}, {16, 64}, {19, 64}};
  EXPECT_THAT(Drawn().block(10, 64, 19, 64).lines(), testing::ElementsAre(level));
  const Line upright{{33, 70}, {33, 73}, {33, 76}, {33, 78}};
  EXPECT_THAT(Drawn().block(33, 70, 33, 78).lines(), testing::ElementsAre(upright));
}

TEST(Lines, LinesOnTheEdgesOfTheCellAreFollowed) {
  for (const int at : {0, kCellSide - 1}) {
    const auto level = Drawn().block(0, at, kCellSide - 1, at).lines();
    ASSERT_THAT(level, SizeIs(1));
    EXPECT_EQ(level[0].front(), (writing::WritingPoint{0, static_cast<double>(at)}));
    EXPECT_EQ(level[0].back(), (writing::WritingPoint{kCellSide - 1, static_cast<double>(at)}));
    const auto upright = Drawn().block(at, 0, at, kCellSide - 1).lines();
    ASSERT_THAT(upright, SizeIs(1));
    EXPECT_EQ(upright[0].front(), (writing::WritingPoint{static_cast<double>(at), 0}));
    EXPECT_EQ(upright[0].back(), (writing::WritingPoint{static_cast<double>(at), kCellSide - 1}));
  }
}

TEST(Lines, ASinglePixelIsAShortSlantedStrokeAroundIt) {
  const Line dot{{39.5, 49.5}, {40.5, 50.5}};
  EXPECT_THAT(Drawn().dot(40, 50).lines(), testing::ElementsAre(dot));
}

TEST(Lines, ABlotIsAStrokeAsLongAsItIsWide) {
  const auto lines = Drawn().block(40, 50, 47, 57).lines();
  ASSERT_THAT(lines, SizeIs(1));
  const writing::WritingPoint middle = (lines[0].front() + lines[0].back()) * 0.5;
  EXPECT_NEAR(middle.x, 43.5, 1);
  EXPECT_NEAR(middle.y, 53.5, 1);
  EXPECT_GE(length_of(lines[0]), 1);
  EXPECT_LE(length_of(lines[0]), 64 * std::numbers::sqrt2);
}

TEST(Lines, TheMiddleOfAThickBarIsItsLine) {
  for (const bool upright : {false, true}) {
    const auto lines = (upright ? Drawn().block(60, 20, 66, 99) : Drawn().block(20, 60, 99, 66)).lines();
    ASSERT_THAT(lines, SizeIs(1));
    double least = 1e9;
    double most = -1e9;
    for (const auto p : lines[0]) {
      EXPECT_NEAR(upright ? p.x : p.y, 63, 1);
      least = std::min(least, upright ? p.y : p.x);
      most = std::max(most, upright ? p.y : p.x);
    }
    EXPECT_NEAR(least, 22, 2.5);
    EXPECT_NEAR(most, 97, 2.5);
  }
}

TEST(Lines, SeparateInkIsSeparateStrokes) {
  const auto lines = Drawn().block(20, 30, 90, 34).block(20, 60, 90, 64).block(20, 90, 90, 94).lines();
  ASSERT_THAT(lines, SizeIs(3));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(lines[i].front().y, 32 + 30.0 * static_cast<double>(i), 1);
    EXPECT_NEAR(length_of(lines[i]), 67, 4);
  }
}

TEST(Lines, LinesOfSinglePixelsThatCrossGoStraightOn) {
  const auto lines = Drawn().block(10, 20, 30, 20).block(20, 10, 20, 30).lines();
  ASSERT_THAT(lines, SizeIs(2));
  const Line down = from_end(lines, {20, 10}, 0);
  ASSERT_FALSE(down.empty());
  EXPECT_EQ(down.back(), (writing::WritingPoint{20, 30}));
  for (const auto p : down) EXPECT_EQ(p.x, 20);
  const Line across = from_end(lines, {10, 20}, 0);
  ASSERT_FALSE(across.empty());
  EXPECT_EQ(across.back(), (writing::WritingPoint{30, 20}));
  for (const auto p : across) EXPECT_EQ(p.y, 20);
  for (const Line& line : lines) EXPECT_NEAR(length_of(line), 20, 1e-9);
}

TEST(Lines, ThickLevelAndUprightLinesThatCrossGoStraightOn) {
  const writing::WritingPoint a{50, 0};
  const writing::WritingPoint b{0, 50};
  const writing::WritingPoint middle{64, 64};
  for (const double radius : {2.0, 4.0}) {
    const auto lines =
        Drawn().pen(middle - a, middle + a, radius).pen(middle - b, middle + b, radius).lines();
    ASSERT_THAT(lines, SizeIs(2)) << radius;
    for (const auto& end : {a, b}) {
      const Line line = from_end(lines, middle - end, 2 * radius + 1);
      ASSERT_FALSE(line.empty()) << radius;
      EXPECT_LE(geometry::distance(line.back(), middle + end), 2 * radius + 1);
      EXPECT_LE(bend_of(line), radius + 0.5) << radius;
    }
  }
}

TEST(Lines, AGridOfThickLinesIsItsBars) {
  // 井 with a frame: two lines across two, far from their ends.
  const auto lines = Drawn()
                         .block(10, 40, 117, 44)
                         .block(10, 80, 117, 84)
                         .block(40, 10, 44, 117)
                         .block(80, 10, 84, 117)
                         .lines();
  ASSERT_THAT(lines, SizeIs(4));
  for (const Line& line : lines) {
    EXPECT_NEAR(length_of(line), 104, 6);
    EXPECT_LE(bend_of(line), 2.5);
  }
}

TEST(Lines, WhereALineEndsOnAnotherTheOtherGoesOn) {
  const auto lines = Drawn().block(20, 30, 100, 34).block(58, 30, 62, 110).lines();
  ASSERT_THAT(lines, SizeIs(2));
  const Line bar = from_end(lines, {22, 32}, 3);
  ASSERT_FALSE(bar.empty());
  EXPECT_LE(geometry::distance(bar.back(), {98, 32}), 3);
  const Line stem = from_end(lines, {60, 108}, 3);
  ASSERT_FALSE(stem.empty());
  EXPECT_LE(geometry::distance(stem.back(), {60, 32}), 3);
}

TEST(Lines, TheStraightestOfTwoWaysGoesOn) {
  for (const bool mirrored : {false, true}) {
    const auto at = [&](double x, double y) { return writing::WritingPoint{mirrored ? 127 - x : x, y}; };
    const auto lines = Drawn().pen(at(10, 64), at(118, 64), 1.2).pen(at(60, 64), at(110, 32), 1.2).lines();
    ASSERT_THAT(lines, SizeIs(2));
    const Line straight = from_end(lines, at(10, 64), 3);
    ASSERT_FALSE(straight.empty());
    EXPECT_LE(geometry::distance(straight.back(), at(118, 64)), 3);
    EXPECT_FALSE(from_end(lines, at(110, 32), 3).empty());
  }
}

TEST(Lines, ACornerIsOneStroke) {
  const auto lines = Drawn().block(20, 30, 100, 34).block(96, 30, 100, 110).lines();
  ASSERT_THAT(lines, SizeIs(1));
  const Line line = from_end(lines, {22, 32}, 3);
  ASSERT_FALSE(line.empty());
  EXPECT_LE(geometry::distance(line.back(), {98, 108}), 3);
  EXPECT_NEAR(length_of(line), 152, 8);
}

TEST(Lines, ARingIsOneStrokeThatEndsWhereItBegins) {
  const auto lines = Drawn().ring(64, 60, 28, 32).lines();
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_LE(geometry::distance(lines[0].front(), lines[0].back()), 1e-9);
  EXPECT_NEAR(length_of(lines[0]), 60 * std::numbers::pi, 8);
  for (const auto p : lines[0]) EXPECT_NEAR(std::hypot(p.x - 64, p.y - 60), 30, 1.5);
}

TEST(Lines, ARingWithATailKeepsBoth) {
  const auto lines = Drawn().ring(64, 80, 18, 22).block(42, 10, 46, 80).lines();
  double all = 0;
  for (const Line& line : lines) all += length_of(line);
  EXPECT_NEAR(all, 40 * std::numbers::pi + 66, 14);
  EXPECT_FALSE(from_end(lines, {44, 12}, 3).empty());
}

TEST(Lines, AShortSpurOfAThickLineIsNoStrokeButALongOneIs) {
  EXPECT_THAT(Drawn().block(20, 60, 99, 66).block(60, 58, 60, 59).lines(), SizeIs(1));
  EXPECT_THAT(Drawn().block(20, 60, 99, 66).block(60, 50, 62, 59).lines(), SizeIs(2));
}

TEST(Lines, ASpurOfTwoPixelsOnALineOfSinglePixelsIsAStroke) {
  const auto lines = Drawn().block(20, 60, 99, 60).block(60, 58, 60, 59).lines();
  ASSERT_THAT(lines, SizeIs(2));
  EXPECT_FALSE(from_end(lines, {60, 58}, 0).empty());
}

TEST(Lines, AShortStrokeThatStandsAloneIsKept) {
  const auto lines = Drawn().block(20, 60, 99, 66).block(50, 90, 53, 90).lines();
  ASSERT_THAT(lines, SizeIs(2));
  EXPECT_FALSE(from_end(lines, {50, 90}, 1).empty());
}

TEST(Lines, AShortStrokeBetweenTwoLongOnesIsKept) {
  // 工 with a short stem: no end of it is free.
  const auto lines = Drawn().block(20, 60, 99, 60).block(20, 65, 99, 65).block(60, 61, 60, 64).lines();
  double all = 0;
  for (const Line& line : lines) all += length_of(line);
  EXPECT_NEAR(all, 79 + 79 + 5, 3);
}

}  // namespace
}  // namespace nazori::scan
