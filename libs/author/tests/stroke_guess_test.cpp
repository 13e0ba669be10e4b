// SPDX-License-Identifier: Apache-2.0
#include "stroke_guess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "drawn_ink.h"

namespace nazori::author::test {
namespace {

using geometry::GlyphPoint;
using geometry::GridPoint;
using kanji::StrokeEnding;

/// A stroke to the right with a half width of its own at each distance from its end.
template <class Half>
OwnStroke ending_with(double length, Half half, double step = 0.5) {
  OwnStroke stroke;
  for (double s = 0; s <= length; s += step) stroke.points.push_back({{10 + s, 50}, half(length - s), 1});
  return stroke;
}

StrokeEnding narrowed_over(double part, double length = 60) {
  return ending_of_ink(
      ending_with(length, [&](double left) { return left < part ? 0.2 + 2.8 * left / part : 3; }));
}

TEST(EndingOfInk, IsASweepWhereItNarrowsOverALongPart) {
  EXPECT_EQ(narrowed_over(30), StrokeEnding::taper);
  EXPECT_EQ(narrowed_over(10), StrokeEnding::taper);
  // Narrower than 0.85 from 0.84 of the part on: 5.04 and 5.9 units of 5.6.
  EXPECT_EQ(narrowed_over(6), StrokeEnding::hook);
  EXPECT_EQ(narrowed_over(8), StrokeEnding::taper);
  // Short strokes have no hook of this kind.
  EXPECT_EQ(narrowed_over(3, 20), StrokeEnding::taper);
  EXPECT_EQ(narrowed_over(3, 22), StrokeEnding::hook);
}

TEST(EndingOfInk, IsAStopWhereItsEndIsAsBroadAsItsBody) {
  const auto with_last = [](double last) {
    return ending_of_ink(
        ending_with(60, [&](double left) { return left < 10 ? last + (3 - last) * left / 10 : 3; }));
  };
  EXPECT_EQ(with_last(3), StrokeEnding::stop);
  EXPECT_EQ(with_last(1.9), StrokeEnding::stop);
  EXPECT_EQ(with_last(1.8), StrokeEnding::taper);
  // The body is what is farther from the end than three tenths.
  EXPECT_EQ(ending_of_ink(ending_with(60, [](double left) { return left < 17 ? 1.0 : 3.0; })),
            StrokeEnding::taper);
  EXPECT_EQ(ending_of_ink(ending_with(60, [](double) { return 0.1; })), StrokeEnding::stop);
  EXPECT_EQ(ending_of_ink({{{{1, 1}, 3, 1}, {{2, 1}, 3, 1}, {{3, 1}, 0, 1}}, StrokeEnding::hook, {}}),
            StrokeEnding::stop)
      << "three points say nothing";
  EXPECT_EQ(ending_of_ink(
                {{{{1, 1}, 3, 1}, {{1, 1}, 3, 1}, {{1, 1}, 3, 1}, {{1, 1}, 0, 1}}, StrokeEnding::stop, {}}),
            StrokeEnding::stop);
}

/// A stroke down that thins out evenly over its last 30 units and turns, this far from its end.
StrokeEnding turned_at(double left, double degrees, double length = 60) {
  const double a = (90 + degrees) * std::numbers::pi / 180;
  OwnStroke stroke;
  for (double s = 0; s <= length + 1e-9; s += 0.25) {
    const double beyond = std::max(0.0, s - (length - left));
    const GlyphPoint at{60 + beyond * std::cos(a), 10 + std::min(s, length - left) + beyond * std::sin(a)};
    stroke.points.push_back({at, 3 * std::min(1.0, (length - s) / 30), 1});
  }
  return ending_of_ink(stroke);
}

TEST(EndingOfInk, IsAHookWhereItTurnsSharplyNearItsEnd) {
  EXPECT_EQ(turned_at(8, 90), StrokeEnding::hook);
  EXPECT_EQ(turned_at(8, 44), StrokeEnding::hook);
  EXPECT_EQ(turned_at(8, 40), StrokeEnding::taper);
  EXPECT_EQ(turned_at(15.5, 90), StrokeEnding::hook);
  EXPECT_EQ(turned_at(17, 90), StrokeEnding::taper);
  // In a short stroke up to 0.55 of its length.
  EXPECT_EQ(turned_at(8, 90, 18), StrokeEnding::hook);
  EXPECT_EQ(turned_at(13, 90, 18), StrokeEnding::taper);
  // A turn in the last 1.5 units is the tip of the ink.
  EXPECT_EQ(turned_at(2, 90), StrokeEnding::hook);
  EXPECT_EQ(turned_at(1, 90), StrokeEnding::hook);
  EXPECT_EQ(turned_at(0.5, 90), StrokeEnding::taper);
}

GlyphPoint start_of(OwnStroke stroke) {
  direct(stroke);
  return stroke.points.front().at;
}

OwnStroke line_to(GlyphPoint way, double first = 3, double last = 3) {
  OwnStroke stroke;
  for (int k = 0; k <= 4; ++k)
    stroke.points.push_back({GlyphPoint{50, 50} + way * (k / 4.0), first + (last - first) * k / 4, 1});
  return stroke;
}

TEST(Direct, AFallingLineIsWrittenDownAndAFlatOneToTheRight) {
  const GlyphPoint here{50, 50};
  // To the lower left it falls from 35 degrees on.
  const auto at = [](double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    return GlyphPoint{40 * std::cos(a), 40 * std::sin(a)};
  };
  EXPECT_EQ(start_of(line_to(at(0))), here);
  EXPECT_EQ(start_of(line_to(at(90))), here);
  EXPECT_EQ(start_of(line_to(at(144))), here);
  EXPECT_EQ(start_of(line_to(at(146))), here + at(146));
  EXPECT_EQ(start_of(line_to(at(-34))), here);
  EXPECT_EQ(start_of(line_to(at(-36))), here + at(-36));
}

TEST(Direct, TheThinEndIsTheLastOne) {
  const GlyphPoint here{50, 50};
  const GlyphPoint right{40, 0};
  EXPECT_EQ(start_of(line_to(right, 1.3, 3)), here + right);
  EXPECT_EQ(start_of(line_to(right, 1.4, 3)), here);
  EXPECT_EQ(start_of(line_to(right * -1, 3, 1.3)), here);
  EXPECT_EQ(start_of(line_to(right * -1, 3, 1.4)), here - right);
}

TEST(Direct, ARingKeepsItsStart) {
  OwnStroke ring;
  for (int k = 0; k <= 12; ++k) {
    const double a = -k * std::numbers::pi / 6;
    ring.points.push_back({{50 + 20 * std::cos(a), 50 + 20 * std::sin(a)}, 3, 1});
  }
  ring.points.back().at = ring.points.front().at;
  const OwnStroke before = ring;
  direct(ring);
  EXPECT_EQ(ring, before);
}

TEST(PutInOrder, ToTheRightCountsLessThanDown) {
  const auto first = [](GlyphPoint a, GlyphPoint b) {
    std::vector<OwnStroke> strokes{{{{a, 3, 1}}, StrokeEnding::stop, {}},
                                   {{{b, 3, 1}}, StrokeEnding::stop, {}}};
    put_in_order(strokes);
    return strokes[0].points[0].at;
  };
  // 10 to the right are as much as 4.5 down.
  EXPECT_EQ(first({30, 20}, {20, 24.4}), (GlyphPoint{20, 24.4}));
  EXPECT_EQ(first({30, 20}, {20, 24.6}), (GlyphPoint{30, 20}));
  EXPECT_EQ(first({30, 20}, {20, 24.5}), (GlyphPoint{30, 20})) << "equal ones keep their order";
}

/// A line of unit steps from (250 + 120 a) over (250, 250) to (250 + 120 b), in degrees.
GridLine angled(double a, double b) {
  const auto way = [](double degrees) {
    return GridPoint{std::cos(degrees * std::numbers::pi / 180), std::sin(degrees * std::numbers::pi / 180)};
  };
  GridLine line;
  for (int k = 120; k > 0; --k) line.push_back(GridPoint{250, 250} + way(a) * k);
  for (int k = 0; k <= 120; ++k) line.push_back(GridPoint{250, 250} + way(b) * k);
  return line;
}

/// Ink around lines, 12 samples wide on each side.
InkMap ink_around(const std::vector<GridLine>& lines) {
  std::vector<GridPoint> points;
  for (const GridLine& line : lines)
    for (std::size_t i = 0; i < line.size(); i += 4) points.push_back(line[i]);
  return ink_with([&](double x, double y) {
    double least = 1e4;
    for (const GridPoint p : points) least = std::min(least, (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y));
    return 1 + 0.25 * (12 - std::sqrt(least));
  });
}

TEST(Divided, AtCornersWhereABrushIsLifted) {
  struct Case {
    double a, b;  ///< directions of the arms, clockwise from the right
    std::size_t strokes;
  };
  const Case cases[] = {
      {180, 90, 1},   // ┐
      {-90, 0, 1},    // └
      {-90, 180, 2},  // ┘
      {90, 0, 2},     // ┌
      {-65, 45, 1},   // く
      {-50, -5, 1},   // ム
      {-120, 60, 1},  // straight
      {180, 30, 1},   // less than 50 degrees
  };
  for (const Case& c : cases) {
    for (const bool back : {false, true}) {
      GridLine line = angled(c.a, c.b);
      if (back) std::ranges::reverse(line);
      EXPECT_EQ(divided({line}, ink_around({line})).size(), c.strokes) << c.a << ", " << c.b << ", " << back;
    }
  }
}

TEST(Divided, BothPartsHaveTheCorner) {
  const GridLine line = angled(90, 0);
  const auto parts = divided({line}, ink_around({line}));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].back(), parts[1].front());
  EXPECT_LT(geometry::distance(parts[0].back(), {250, 250}), 5);
  EXPECT_EQ(parts[0].front(), line.front());
  EXPECT_EQ(parts[1].back(), line.back());
}

TEST(Divided, AShortThinArmIsAHook) {
  // The ink is 12 wide, but for the second arm, which thins out to nothing.
  const auto parts = [](double length, bool thins_out) {
    GridLine line = angled(-90, -180);
    line.resize(static_cast<std::size_t>(121 + length));
    const InkMap map = ink_with([&](double x, double y) {
      double best = -100;
      for (std::size_t i = 0; i < line.size(); i += 2) {
        const double beyond = std::max(0.0, static_cast<double>(i) - 120);
        const double half = thins_out ? 12 * std::max(0.1, 1 - beyond / length) : 12;
        best = std::max(best, half - std::hypot(line[i].x - x, line[i].y - y));
      }
      return 1 + 0.25 * best;
    });
    return divided({line}, map).size();
  };
  EXPECT_EQ(parts(50, true), 1U);
  EXPECT_EQ(parts(50, false), 2U);
  EXPECT_EQ(parts(80, true), 2U) << "14 units are 66 samples";
}

TEST(Divided, TheLowerLeftCornerOfAClosedShapeIsTwoStrokes) {
  // └ with ┐: the paper inside is enclosed.
  const GridLine corner = angled(-90, 0);
  GridLine other;
  for (double x = 250; x <= 370; ++x) other.push_back({x, 130});
  for (double y = 131; y <= 250; ++y) other.push_back({370, y});
  EXPECT_EQ(divided({corner}, ink_around({corner})).size(), 1U);
  EXPECT_EQ(divided({corner}, ink_around({corner, other})).size(), 2U);
  // With a gap it is not.
  other.resize(other.size() - 60);
  EXPECT_EQ(divided({corner}, ink_around({corner, other})).size(), 1U);
}

TEST(Divided, PaperAtAnEdgeOfThePictureIsNotEnclosed) {
  // The corner └ closes a bay that is open to one edge of the picture alone.
  const GridLine corner = angled(-90, 0);
  const auto strokes = [&](const std::vector<GridLine>& walls) {
    std::vector<GridLine> all = walls;
    all.push_back(corner);
    return divided({corner}, ink_around(all)).size();
  };
  const auto flat = [](double from, double to, double y) {
    GridLine line;
    for (double x = from; x <= to; ++x) line.push_back({x, y});
    return line;
  };
  const auto falling = [](double x, double from, double to) {
    GridLine line;
    for (double y = from; y <= to; ++y) line.push_back({x, y});
    return line;
  };
  EXPECT_EQ(strokes({flat(370, 511, 250), flat(250, 511, 130)}), 1U) << "to the right";
  EXPECT_EQ(strokes({falling(250, 0, 130), falling(370, 0, 250)}), 1U) << "to the top";
  EXPECT_EQ(
      strokes({flat(370, 440, 250), falling(440, 250, 511), flat(250, 500, 130), falling(500, 130, 511)}), 1U)
      << "to the bottom";
  EXPECT_EQ(strokes({falling(250, 100, 130), flat(0, 250, 100), falling(370, 40, 250), flat(0, 370, 40)}), 1U)
      << "to the left";
}

}  // namespace
}  // namespace nazori::author::test
