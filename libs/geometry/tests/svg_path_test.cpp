// SPDX-License-Identifier: Apache-2.0
#include "nazori/geometry/svg_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <string>

#include "nazori/geometry/polyline.h"

namespace nazori::geometry {
namespace {

using Pieces = std::vector<std::array<GlyphPoint, 3>>;

/// The curve itself by Bernstein's formula, independent of the code under test.
GlyphPoint on_curve(GlyphPoint a, const std::array<GlyphPoint, 3>& piece, double t) {
  const double s = 1 - t;
  return a * (s * s * s) + piece[0] * (3 * s * s * t) + piece[1] * (3 * s * t * t) + piece[2] * (t * t * t);
}

BezierPath read(std::string_view data) {
  auto path = parse_svg_path(data);
  EXPECT_TRUE(path) << data << ": " << (path ? "" : base::to_line(path.error()));
  return path.value_or(BezierPath{});
}

void expect_same(std::string_view a, std::string_view b) {
  const BezierPath first = read(a);
  const BezierPath second = read(b);
  EXPECT_NEAR(distance(first.start, second.start), 0, 1e-12) << a;
  ASSERT_EQ(first.pieces.size(), second.pieces.size()) << a;
  for (std::size_t i = 0; i < first.pieces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(distance(first.pieces[i][k], second.pieces[i][k]), 0, 1e-12) << a;
    }
  }
}

TEST(SvgPath, ReadsAStrokeOfKanjiVG) {
  // The second stroke of 休 in KanjiVG (CC BY-SA 3.0, Ulrich Apel).
  const BezierPath path = read(
      "M26.28,42.5c0.72,1.25,1.26,3.48,1.26,4.75c0,12.75-0.07,29.88-0.26,42.25c-0.02,1.54-0.04,2.97-0.04,4."
      "25");
  EXPECT_EQ(path.start, (GlyphPoint{26.28, 42.5}));
  ASSERT_EQ(path.pieces.size(), 3U);
  EXPECT_NEAR(path.pieces[0][0].x, 27.0, 1e-12);
  EXPECT_NEAR(path.pieces[1][1].x, 27.47, 1e-12);
  EXPECT_NEAR(path.pieces[2][2].x, 27.24, 1e-12);
  EXPECT_NEAR(path.pieces[2][2].y, 93.75, 1e-12);
}

TEST(SvgPath, CommandsOfBothCasesMeanTheSameCurve) {
  expect_same("M10 20 L30 50", "m10 20 l20 30");
  expect_same("M10 20 H30 V50", "M10 20 h20 v30");
  expect_same("M10 20 C 11 21 12 22 13 23", "M10 20 c 1 1 2 2 3 3");
  expect_same("M10 20 Q 15 30 20 20 T 30 20", "M10 20 q 5 10 10 0 t 10 0");
  expect_same("M10 20 C 10 10 20 10 20 20 S 30 30 30 20", "M10 20 c 0 -10 10 -10 10 0 s 10 10 10 0");
}

TEST(SvgPath, ShorthandsMirrorTheLastControlPointOfTheirOwnKindOnly) {
  expect_same("M0 0 C 0 10 10 10 10 0 S 20 -10 20 0", "M0 0 C 0 10 10 10 10 0 C 10 -10 20 -10 20 0");
  expect_same("M0 0 Q 5 10 10 0 T 20 0", "M0 0 Q 5 10 10 0 Q 15 -10 20 0");
  expect_same("M0 0 L 10 0 S 20 -10 20 0", "M0 0 L 10 0 C 10 0 20 -10 20 0");
  expect_same("M0 0 Q 5 10 10 0 S 20 -10 20 0", "M0 0 Q 5 10 10 0 C 10 0 20 -10 20 0");
  expect_same("M0 0 C 0 10 10 10 10 0 T 20 0", "M0 0 C 0 10 10 10 10 0 Q 10 0 20 0");
  // The control points before the last curve are forgotten, whatever its kind.
  expect_same("M0 0 Q 5 10 10 0 C 10 10 20 10 20 0 T 30 0",
              "M0 0 Q 5 10 10 0 C 10 10 20 10 20 0 Q 20 0 30 0");
  expect_same("M0 0 C 0 10 10 10 10 0 Q 15 10 20 0 S 30 -10 30 0",
              "M0 0 C 0 10 10 10 10 0 Q 15 10 20 0 C 20 0 30 -10 30 0");
  expect_same("M0 0 Q 5 10 10 0 L 20 0 T 30 0", "M0 0 Q 5 10 10 0 L 20 0 Q 20 0 30 0");
}

TEST(SvgPath, NumbersNeedNoSpacesWhereTheirEndIsClear) {
  expect_same("M1-.5.5.25", "M 1 -0.5 L 0.5 0.25");
  expect_same("M+1e1,2E+0l-1e-1-2.e0", "M10 2 l -0.1 -2");
  expect_same("m1,2,3,4,5,6", "M1 2 L4 6 L9 12");
  expect_same("\tM 1\n2\r\nL3 , 4 ", "M1 2L3 4");
  expect_same("M0,0c1,1,2,2,3,3,1,1,2,2,3,3", "M0,0c1,1,2,2,3,3c1,1,2,2,3,3");
  expect_same("M0,0q1,1,2,2,3,3,4,4s1,1,2,2t5,5", "M0 0q1 1 2 2q3 3 4 4s1 1 2 2t5 5");
  expect_same("M\f1\t2\rL\n3\f4 \t", "M1 2L3 4");
}

TEST(SvgPath, NothingIsReadPastTheEndOfTheText) {
  // Each text is followed in memory by text that would change the result.
  const auto begin = [](std::string_view whole, std::size_t length) { return whole.substr(0, length); };
  expect_same(begin("M1 2 7 8", 4), "M1 2");
  expect_same(begin("M1 2 7 8", 5), "M1 2");
  expect_same(begin("M1 23", 4), "M1 2");
  expect_same(begin("M1 2.5", 4), "M1 2");
  expect_same(begin("M1 2e3", 4), "M1 2");
  expect_same(begin("M1 2,L3 4", 4), "M1 2");
  expect_same(begin("M1 2L3 4", 4), "M1 2");
  EXPECT_EQ(parse_svg_path(begin("M1 2L+5 6", 5)).error().where, "column 6");
  EXPECT_EQ(parse_svg_path(begin(" M1 2", 1)).error().what, "path data are empty");
}

TEST(SvgPath, AStraightPieceIsWalkedEvenly) {
  for (const std::string_view data : {"M0 0L9 18", "M0 0 Q4.5 9 9 18"}) {
    const BezierPath path = read(data);
    ASSERT_EQ(path.pieces.size(), 1U);
    for (const double t : {0.25, 0.5, 0.75}) {
      EXPECT_NEAR(distance(on_curve(path.start, path.pieces[0], t), GlyphPoint{9 * t, 18 * t}), 0, 1e-12);
    }
  }
}

TEST(SvgPath, AMoveAloneIsAPoint) {
  const BezierPath path = read("M3,4");
  EXPECT_TRUE(path.pieces.empty());
  EXPECT_EQ(flatten(path, 0.1), (Polyline<GlyphFrame>{{3, 4}}));
}

TEST(SvgPath, AQuadraticCurveIsRaisedWithoutChange) {
  const BezierPath path = read("M0 0 Q 10 20 30 0");
  for (int i = 0; i <= 10; ++i) {
    const double t = i / 10.0;
    const GlyphPoint p = on_curve(path.start, path.pieces[0], t);
    EXPECT_NEAR(p.x, 2 * (1 - t) * t * 10 + t * t * 30, 1e-12);
    EXPECT_NEAR(p.y, 2 * (1 - t) * t * 20, 1e-12);
  }
}

TEST(SvgPath, RefusesWhatIsNoSingleStrokeAndNamesTheColumn) {
  const auto column = [](std::string_view data) {
    const auto path = parse_svg_path(data);
    EXPECT_FALSE(path) << data;
    EXPECT_TRUE(path || path.error().code == base::Errc::parse);
    return path ? std::string() : path.error().where;
  };
  EXPECT_EQ(column(""), "column 1");
  EXPECT_EQ(column("   "), "column 4");
  EXPECT_EQ(column("L1 2"), "column 1");
  EXPECT_EQ(column("M1 2M3 4"), "column 5");
  EXPECT_EQ(column("M1 2L3 4Z"), "column 9");
  EXPECT_EQ(column("M1 2A1 1 0 0 0 3 4"), "column 5");
  EXPECT_EQ(column("M1 2B3"), "column 5");
  EXPECT_EQ(column("M1"), "column 3");
  EXPECT_EQ(column("M1 2L3"), "column 7");
  EXPECT_EQ(column("M1 2L3,"), "column 8");
  EXPECT_EQ(column("M1 2C1 2 3 4 5"), "column 15");
  EXPECT_EQ(column("M1,,2"), "column 4");
  EXPECT_EQ(column("M1 2,L3 4"), "column 6");
  EXPECT_EQ(column("M1 2L3 4,"), "column 10");
  EXPECT_EQ(column("M1 2Lnan 4"), "column 6");
  EXPECT_EQ(column("M1 2L-"), "column 6");
  EXPECT_EQ(column("M1 2Linf 1"), "column 6");
}

TEST(SvgPath, SaysWhatIsWrong) {
  const auto what = [](std::string_view data) {
    const auto path = parse_svg_path(data);
    return path ? std::string("read") : path.error().what;
  };
  EXPECT_EQ(what(""), "path data are empty");
  EXPECT_EQ(what("   "), "path data are empty");
  EXPECT_EQ(what("L1 2"), "path data must begin with M");
  EXPECT_EQ(what("M1 2M3 4"), "a stroke is one line: a second M");
  EXPECT_EQ(what("M1 2L3 4z"), "a stroke is one line: Z closes it");
  EXPECT_EQ(what("M1 2A1 1 0 0 0 3 4"), "arcs (A) do not occur in strokes");
  EXPECT_EQ(what("M1 2B3"), "unknown command");
  EXPECT_EQ(what("M1 2e"), "unknown command") << "an exponent has digits";
  for (const std::string_view data : {"M1 2{3", "M1 2[3", "M1 2`3", "M1 2@3", "M1 2#", "M1 2/3", "M1 2:3"})
    EXPECT_EQ(what(data), "a command is missing") << data;
  for (const std::string_view data : {"M", "M1", "M1 2L3", "M1 2L-", "M1 2L.", "M1 2L+-3 4", "M1 2Lnan 4"})
    EXPECT_EQ(what(data), "a number is missing") << data;
  EXPECT_EQ(what("M1 2L3 4,"), "a number is missing after the comma");
  EXPECT_EQ(what("M1 2L3 4,h5"), "a number is missing after the comma");
  EXPECT_EQ(what("M1000001 0"), "a number is over 1e6 or finer than a double holds");
  EXPECT_EQ(what("M1e6 0l1 0"), "a point lies beyond 1e6");
}

TEST(SvgPath, ControlPointsThatMirroringThrowsOutLieWithinTwoMillion) {
  // S mirrors the last control point about the end: 1e6 about -1e6 gives -3e6.
  EXPECT_FALSE(parse_svg_path("M0 0C0 0 1e6 0 -1e6 0S0 0 0 0"));
  EXPECT_FALSE(parse_svg_path("M0 0C0 0 0 1e6 0 -1e6S0 0 0 0"));
  EXPECT_TRUE(parse_svg_path("M0 0C0 0 0 0 -1e6 0S0 0 0 0"));
  EXPECT_TRUE(parse_svg_path("M0 0C0 0 0 0 0 1e6S0 0 0 0"));
  EXPECT_FALSE(parse_svg_path("M0 0C0 0 1 0 -1e6 0S0 0 0 0"));
  EXPECT_FALSE(parse_svg_path("M0 0C0 0 0 -1 0 1e6S0 0 0 0"));
  // T mirrors it each time: 1e6 at 0, then -1e6, then 3e6. A quadratic control point counts two thirds.
  EXPECT_FALSE(parse_svg_path("M-1e6 0Q1e6 0 0 0T1e6 0T-1e6 0T0 0"));
  EXPECT_FALSE(parse_svg_path("M0 -1e6Q0 1e6 0 0T0 1e6T0 -1e6T0 0"));
}

TEST(SvgPath, RefusesNumbersPointsAndCountsBeyondTheLimits) {
  EXPECT_TRUE(parse_svg_path("M1e6 -1e6"));
  EXPECT_FALSE(parse_svg_path("M1000001 0"));
  EXPECT_FALSE(parse_svg_path("M1e999 0"));
  EXPECT_FALSE(parse_svg_path("M1e6 0l1 0"));
  EXPECT_FALSE(parse_svg_path("M1e6 0l-1500000 0")) << "the number itself is too large";
  EXPECT_TRUE(parse_svg_path("M1e6 0l-1e6 1e6"));
  EXPECT_FALSE(parse_svg_path("M1e-999 0"));
  EXPECT_TRUE(parse_svg_path("M1e-9 0"));
  std::string many = "M0 0";
  for (int i = 0; i < 10'000; ++i) many += "h1";
  EXPECT_EQ(read(many).pieces.size(), 10'000U);
  EXPECT_FALSE(parse_svg_path(many + "h1"));
}

TEST(Flatten, StaysWithinTheToleranceOfTheCurveAndTheCurveOfIt) {
  std::mt19937 random(1998);
  std::uniform_real_distribution<double> coordinate(0, 109);
  const auto any = [&] { return GlyphPoint{coordinate(random), coordinate(random)}; };
  for (const double tolerance : {1.0, 0.05, 0.001}) {
    for (int round = 0; round < 12; ++round) {
      BezierPath path{any(), {}};
      for (int i = 0; i < 3; ++i) path.pieces.push_back({any(), any(), any()});
      const auto line = flatten(path, tolerance);
      Polyline<GlyphFrame> dense{path.start};
      GlyphPoint from = path.start;
      for (const auto& piece : path.pieces) {
        for (int i = 1; i <= 200; ++i) {
          const GlyphPoint p = on_curve(from, piece, i / 200.0);
          EXPECT_LE(nearest_point(std::span<const GlyphPoint>(line), p).distance, tolerance * (1 + 1e-9));
          dense.push_back(p);
        }
        from = piece[2];
      }
      // The dense sampling itself cuts corners by up to (200 steps) 2e-2.
      for (const GlyphPoint p : line) {
        EXPECT_LE(nearest_point(std::span<const GlyphPoint>(dense), p).distance, 0.04);
      }
    }
  }
}

TEST(Flatten, KeepsCornersAndEndsExactlyAndRepeatsNoPoint) {
  const BezierPath path = read("M10 10L90 10L90 10L20 80C20 80 20 80 20 80c5,0,5,10,0,10");
  const auto line = flatten(path, 0.05);
  EXPECT_EQ(line.front(), (GlyphPoint{10, 10}));
  EXPECT_EQ(line.back(), (GlyphPoint{20, 90}));
  EXPECT_NE(std::find(line.begin(), line.end(), GlyphPoint{90, 10}), line.end());
  EXPECT_NE(std::find(line.begin(), line.end(), GlyphPoint{20, 80}), line.end());
  for (std::size_t i = 1; i < line.size(); ++i) EXPECT_NE(line[i], line[i - 1]);
}

TEST(Flatten, AStraightLineIsOneSegmentAndAFinerToleranceNeedsMore) {
  EXPECT_EQ(flatten(read("M0 0L100 50"), 1e-6).size(), 2U);
  const BezierPath arc = read("M0 0C0 60 100 60 100 0");
  EXPECT_LT(flatten(arc, 1).size(), flatten(arc, 0.01).size());
  EXPECT_LE(flatten(arc, 0.05).size(), 65U);
}

TEST(Flatten, AnArchIsOneSegmentFromTheToleranceOfItsHeightOn) {
  // Its top is 3/4 as high as its control points.
  const BezierPath arch = read("M0 0C0 4 30 4 30 0");
  EXPECT_EQ(flatten(arch, 3).size(), 2U);
  EXPECT_GT(flatten(arch, 2.999).size(), 2U);
}

TEST(Flatten, ALineThatTurnsBackOnItselfKeepsItsTurn) {
  // Control points on the chord's line but beyond its end: the curve runs past the end and comes back.
  const auto line =
      flatten(BezierPath{{0, 0}, {{GlyphPoint{30, 0}, GlyphPoint{30, 0}, GlyphPoint{10, 0}}}}, 0.01);
  double farthest = 0;
  for (const GlyphPoint p : line) farthest = std::max(farthest, p.x);
  // x(t) = 90 t (1-t)^2 + 90 t^2 (1-t) + 10 t^3 = 90 t - 90 t^2 + 10 t^3 has its largest value at t = 3 -
  // sqrt(6).
  const double t = 3 - std::sqrt(6.0);
  EXPECT_NEAR(farthest, 90 * t - 90 * t * t + 10 * t * t * t, 0.011);
}

TEST(Flatten, EndsEvenForATolerancePastTheReachOfNumbers) {
  const auto line = flatten(read("M0 0C0 60 100 60 100 0"), 1e-300);
  EXPECT_LE(line.size(), 65'537U);
  EXPECT_EQ(line.back(), (GlyphPoint{100, 0}));
}

}  // namespace
}  // namespace nazori::geometry
