// SPDX-License-Identifier: Apache-2.0
// Equations solved box by box, and regions, against closed forms.
#include "../src/plane_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "../src/region_tracer.h"
#include "nazori/functions/tracing.h"

namespace nazori::functions {
namespace {

constexpr double kPi = 3.14159265358979323846;
const base::Progress kNone;

Expression read(const std::string& text) {
  const auto plot = parse("x + y = " + text);
  EXPECT_TRUE(plot) << text;
  return plot->statements[0].terms[1];
}

/// Over -2 to 2 both ways.
PlaneSolution solved(const std::string& function, const std::string& whole = "", int cells = 64,
                     double margin = 0) {
  PlaneEquation e;
  e.function = read(function);
  e.whole = read(whole.empty() ? function : whole);
  e.low = {-2, -2};
  e.high = {2, 2};
  PlaneSolution solution;
  WorkProgress progress(kNone);
  EXPECT_TRUE(PlaneTracer(e, cells, margin, progress).run(solution));
  return solution;
}

double x_of(PlatePoint p) { return -2 + 4 * p.u; }
double y_of(PlatePoint p) { return -2 + 4 * p.v; }

double length_of(const PlaneSolution& s) {
  double sum = 0;
  for (const auto& g : s.segments) sum += 4 * std::hypot(g.to.u - g.from.u, g.to.v - g.from.v);
  return sum;
}

void expect_on(const PlaneSolution& s, const std::function<double(double, double)>& f, double hair = 1e-10) {
  for (const auto& g : s.segments) {
    for (const PlatePoint p : {g.from, g.to})
      ASSERT_NEAR(f(x_of(p), y_of(p)), 0, hair) << x_of(p) << ' ' << y_of(p);
  }
}

TEST(PlaneTracer, ACircleIsMadeOfChordsOfItsWholeLength) {
  const PlaneSolution s = solved("x^2 + y^2 - 1");
  expect_on(s, [](double x, double y) { return x * x + y * y - 1; });
  EXPECT_NEAR(length_of(s), 2 * kPi, 2e-3);
  // No chord deviates more than a sixteenth of a cell, of 256 a side at least.
  for (const auto& g : s.segments) {
    const double x = (x_of(g.from) + x_of(g.to)) / 2;
    const double y = (y_of(g.from) + y_of(g.to)) / 2;
    ASSERT_LT(std::abs(std::hypot(x, y) - 1) / 4, 1.0 / (16 * 256));
  }
  EXPECT_TRUE(s.undecided.empty());
  EXPECT_TRUE(s.dots.empty());
  EXPECT_TRUE(s.singular.empty());
  const auto lines = stitched(s.segments, s.leaf * 1e-5);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  // The finest boxes are as fine as requested, and at most twice as fine.
  EXPECT_LE(s.leaf, 1.0 / 64);
  EXPECT_GT(s.leaf, 1.0 / 128);
}

TEST(PlaneTracer, SmoothCurvesTakeBigBoxes) {
  EXPECT_LT(solved("x^2 + y^2 - 1", "", 512).segments.size(), 600U);
  EXPECT_NEAR(length_of(solved("y - x/3 + 0x^2 y")), std::hypot(4, 4.0 / 3), 0.06);
  EXPECT_NEAR(length_of(solved("x - y/3 + 0x y^2")), std::hypot(4, 4.0 / 3), 0.06);
}

TEST(PlaneTracer, FollowsAsFarOutAsItsMargin) {
  const auto reach = [](double margin) {
    double most = 0;
    for (const auto& g : solved("y - 0.1 + 0x y^3", "", 64, margin).segments)
      most = std::max({most, g.from.u, g.to.u});
    return most;
  };
  EXPECT_GT(reach(0), 1);
  EXPECT_LT(reach(0), 1.01);
  EXPECT_GT(reach(0.1), 1.1);
  EXPECT_LT(reach(0.1), 1.11);
}

TEST(PlaneTracer, TwoBranchesThatCrossMeetInASingularPoint) {
  // Along the diagonals, a little off the middle.
  const PlaneSolution s = solved("(x - 0.1)^2 - (y + 0.2)^2");
  ASSERT_EQ(s.singular.size(), 1U);
  EXPECT_NEAR(x_of(s.singular[0]), 0.1, 1e-9);
  EXPECT_NEAR(y_of(s.singular[0]), -0.2, 1e-9);
  expect_on(s, [](double x, double y) { return std::pow(x - 0.1, 2) - std::pow(y + 0.2, 2); });
  // y = x - 0.3 from x = -1.7 on and y = -x - 0.1 up to x = 1.9.
  EXPECT_NEAR(length_of(s), (3.7 + 3.9) * std::sqrt(2), 0.06);
  EXPECT_TRUE(s.undecided.empty());
}

TEST(PlaneTracer, BranchesThatPassCloseByStayApart) {
  // Two hyperbolas a hundredth of a box apart at their nearest.
  const PlaneSolution s = solved("(x - 0.013)^2 - (y + 0.017)^2 - 0.00001");
  for (const auto& g : s.segments) ASSERT_EQ(x_of(g.from) < 0.013, x_of(g.to) < 0.013);
  expect_on(s, [](double x, double y) { return std::pow(x - 0.013, 2) - std::pow(y + 0.017, 2) - 1e-5; });
}

TEST(PlaneTracer, ACuspIsOnePiece) {
  const PlaneSolution s = solved("(y + 0.03)^2 - (x - 0.05)^3");
  expect_on(
      s, [](double x, double y) { return std::pow(y + 0.03, 2) - std::pow(x - 0.05, 3); }, 1e-9);
  EXPECT_TRUE(s.undecided.empty());
  double least = 2;
  for (const auto& g : s.segments) least = std::min({least, x_of(g.from), x_of(g.to)});
  EXPECT_NEAR(least, 0.05, 0.07);
  EXPECT_GE(least, 0.05 - 1e-9);
}

TEST(PlaneTracer, APointIsADotAndNearlyOneIsNothing) {
  const PlaneSolution point = solved("(x - 0.3)^2 + (y - 0.7)^2");
  EXPECT_TRUE(point.segments.empty());
  ASSERT_GE(point.dots.size(), 1U);
  for (const PlatePoint p : point.dots) {
    EXPECT_NEAR(x_of(p), 0.3, 1e-8);
    EXPECT_NEAR(y_of(p), 0.7, 1e-8);
  }
  const PlaneSolution none = solved("(x - 0.3)^2 + (y - 0.7)^2 + 0.000001");
  EXPECT_TRUE(none.segments.empty());
  EXPECT_TRUE(none.dots.empty());
  EXPECT_TRUE(none.undecided.empty());
}

TEST(PlaneTracer, AnOvalThatFitsIntoABoxIsDrawnRoundItsMiddle) {
  int whole = 0;
  for (int k = 0; k < 8; ++k) {
    const double x0 = 0.301 + 0.017 * k;
    const PlaneSolution s = solved("(x - " + std::to_string(x0) + ")^2 + (y - 0.71)^2 - 0.0001");
    EXPECT_TRUE(s.dots.empty());
    EXPECT_LE(length_of(s), 2 * kPi * 0.01 + 1e-9);
    for (const auto& g : s.segments) {
      for (const PlatePoint p : {g.from, g.to})
        ASSERT_NEAR(std::hypot(x_of(p) - x0, y_of(p) - 0.71), 0.01, 1e-9);
    }
    // Round the middle it is longer than twice across, where no border of a box passes through.
    whole += length_of(s) > 4 * 0.01 ? 1 : 0;
  }
  EXPECT_GE(whole, 3);
}

TEST(PlaneTracer, ADoubleCurveIsARowOfDots) {
  const PlaneSolution s = solved("(x^2 + y^2 - 1)^2");
  EXPECT_GT(s.dots.size() + s.segments.size(), 100U);
  for (const PlatePoint p : s.dots) ASSERT_NEAR(std::hypot(x_of(p), y_of(p)), 1, 1e-6);
  EXPECT_LT(static_cast<double>(s.undecided.size()), 20);
}

TEST(PlaneTracer, PolesAndJumpsAreNoZeros) {
  EXPECT_TRUE(solved("1/(x - y)").segments.empty());
  EXPECT_TRUE(solved("1/(x^2 + y^2 - 1)").segments.empty());
  EXPECT_TRUE(solved("floor(x + y) + 0.5").segments.empty());
  EXPECT_TRUE(solved("floor(x + y) + 0.5").undecided.empty());
  EXPECT_TRUE(solved("sign(x^2 + y^2 - 1) + 0x").segments.empty());
}

TEST(PlaneTracer, ZerosCountOnlyWhereTheWholeIsDefined) {
  // The upper half of a circle.
  const PlaneSolution s = solved("x^2 + y^2 - 1", "(x^2 + y^2 - 1)/sqrt(y)");
  for (const auto& g : s.segments) {
    EXPECT_GE(y_of(g.from), -1e-9);
    EXPECT_GE(y_of(g.to), -1e-9);
  }
  EXPECT_NEAR(length_of(s), kPi, 0.15);
  EXPECT_TRUE(solved("(x - 0.3)^2 + (y - 0.7)^2", "((x - 0.3)^2 + (y - 0.7)^2)/sqrt(x - y)").dots.empty());
}

TEST(PlaneTracer, ABorderOfTheDomainEndsACurve) {
  // y = x^2 where y < 1 only.
  const PlaneSolution s = solved("(y - x^2) sqrt(1 - y) + 0x y");
  EXPECT_GT(length_of(s), 2.7);
  for (const auto& g : s.segments) {
    for (const PlatePoint p : {g.from, g.to}) {
      if (y_of(p) < 0.9) {
        ASSERT_NEAR(y_of(p), x_of(p) * x_of(p), 1e-9);
      }
      ASSERT_LE(y_of(p), 1 + 1e-6);
    }
  }
}

double area_of(const std::vector<std::array<PlatePoint, 2>>& fills) {
  double sum = 0;
  for (const auto& f : fills) sum += (f[1].u - f[0].u) * (f[1].v - f[0].v);
  return sum;
}

TEST(PlaneTracer, WhatIsZeroThroughoutIsAnArea) {
  // Where both have one whole part: four squares of the sixteen.
  const PlaneSolution s = solved("floor(x) - floor(y)", "", 128);
  EXPECT_NEAR(area_of(s.fills), 0.25, 0.02);
  for (const auto& f : s.fills) {
    const PlatePoint middle{(f[0].u + f[1].u) / 2, (f[0].v + f[1].v) / 2};
    ASSERT_EQ(std::floor(x_of(middle)), std::floor(y_of(middle)));
  }
  PlaneEquation e;
  e.function = read("|x| + x + 0y");
  e.whole = e.function;
  e.low = {-2, -2};
  e.high = {2, 2};
  e.areas = {{read("-x")}, {read("x - 1"), read("y")}};
  PlaneSolution solution;
  WorkProgress progress(kNone);
  EXPECT_TRUE(PlaneTracer(e, 128, 0, progress).run(solution));
  // To the left of the y axis; the second area has the function nowhere zero.
  EXPECT_NEAR(area_of(solution.fills), 0.5, 0.02);
}

TEST(PlaneTracer, StopsWhenAsked) {
  PlaneEquation e;
  e.function = e.whole = read("sin(3x^2 + 3y^2) - cos(3x y)");
  e.low = {-2, -2};
  e.high = {2, 2};
  std::vector<double> reported;
  const base::Progress all = [&](double done, std::string_view) {
    reported.push_back(done);
    return true;
  };
  PlaneSolution solution;
  WorkProgress progress(all);
  EXPECT_TRUE(PlaneTracer(e, 128, 0, progress).run(solution));
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.size(), 256U);
  EXPECT_NEAR(reported.front(), 1.0 / 256, 1e-12);
  EXPECT_NEAR(reported.back(), 1, 1e-12);
  const base::Progress some = [&](double done, std::string_view) { return done < 0.5; };
  PlaneSolution part;
  WorkProgress stopped(some);
  EXPECT_FALSE(PlaneTracer(e, 128, 0, stopped).run(part));
  EXPECT_LT(part.segments.size(), solution.segments.size());
}

Tracing regions(const std::string& text, int resolution = 128) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  TraceSettings settings;
  settings.resolution = resolution;
  auto t = trace(*plot, {-2, 2, -2, 2}, settings);
  EXPECT_TRUE(t) << text;
  return *t;
}

double area_of(const Tracing& t) {
  double sum = 0;
  for (const Fill& f : t.fills) sum += 16 * (f.high.u - f.low.u) * (f.high.v - f.low.v);
  return sum;
}

TEST(RegionTracer, CoversWhatHoldsToHalfACell) {
  EXPECT_NEAR(area_of(regions("x^2 + y^2 < 1")), kPi, 0.02);
  EXPECT_NEAR(area_of(regions("x^2 + y^2 > 1")), 16 - kPi, 0.02);
  EXPECT_NEAR(area_of(regions("1 < x^2 + y^2 <= 2")), kPi, 0.03);
  EXPECT_NEAR(area_of(regions("y >= x")), 8, 0.05);
  EXPECT_NEAR(area_of(regions("0 < y < sqrt(x)")), std::pow(2, 1.5) * 2 / 3, 0.03);
  EXPECT_NEAR(area_of(regions("r < 1; 0 <= theta <= pi/2")), kPi / 4, 0.02);
  EXPECT_NEAR(area_of(regions("r < 1; 0 <= theta <= 3pi/2")), 3 * kPi / 4, 0.02);
  EXPECT_NEAR(area_of(regions("r < 1; -pi/2 <= theta <= pi/2")), kPi / 2, 0.02);
  EXPECT_NEAR(area_of(regions("r < 1 + cos(theta)")), 1.5 * kPi, 0.03);
  EXPECT_NEAR(area_of(regions("r < theta/4")), std::pow(2 * kPi, 3) / 6 / 16, 0.03);
  EXPECT_NEAR(area_of(regions("r <= 1 + sin(theta)")), 1.5 * kPi, 0.03);
  EXPECT_TRUE(regions("x^2 + y^2 < -1").fills.empty());
  EXPECT_EQ(area_of(regions("x^2 + y^2 > -1")), 16);
  EXPECT_EQ(regions("x^2 + y^2 > -1").fills.size(), 1U) << "whole boxes where that is certain";
  EXPECT_EQ(area_of(regions("x > x")), 0);
  EXPECT_EQ(area_of(regions("x >= x")), 16);
}

TEST(RegionTracer, BordersAreMarkedAndKeptWhereTheOthersHold) {
  const Tracing disc = regions("x^2 + y^2 <= 1");
  ASSERT_EQ(disc.branches.size(), 1U);
  EXPECT_TRUE(disc.branches[0].boundary);
  EXPECT_FALSE(disc.branches[0].strict);
  EXPECT_TRUE(disc.events.empty());
  EXPECT_TRUE(regions("x^2 + y^2 < 1").branches[0].strict);
  // A ring: one border is strict, the other not.
  const Tracing ring = regions("0.5 < x^2 + y^2 <= 2");
  int strict = 0;
  for (const Branch& b : ring.branches) {
    const double r = std::hypot(4 * b.points[0].u - 2, 4 * b.points[0].v - 2);
    EXPECT_NEAR(r * r, b.strict ? 0.5 : 2, 1e-6);
    strict += b.strict ? 1 : 0;
  }
  EXPECT_GE(strict, 1);
  // The line y = 0 belongs to the border only where 0 < x < 1 holds.
  for (const Branch& b : regions("0 <= y < x").branches) {
    for (const CurvePoint& p : b.points) {
      const double x = 4 * p.u - 2;
      EXPECT_GE(x, -0.02);
    }
  }
  EXPECT_TRUE(regions("0 < x^2 + y^2").dots.empty()) << "a point that does not belong";
  EXPECT_EQ(regions("0 >= x^2 + y^2").dots.size(), 1U);
  EXPECT_TRUE(regions("0 >= x^2 + y^2 > 1").dots.empty());
}

TEST(Trace, CurvesInRAndThetaAreFollowedInThePlane) {
  const auto check = [](const std::string& text, const std::function<double(double, double)>& f,
                        std::size_t least) {
    const Tracing t = regions(text);
    std::size_t points = 0;
    for (const Branch& b : t.branches) {
      for (const CurvePoint& p : b.points) {
        ASSERT_NEAR(f(4 * p.u - 2, 4 * p.v - 2), 0, 1e-6) << text;
        ++points;
      }
    }
    EXPECT_GE(points, least) << text;
  };
  check(
      "r^2 = 2cos(2theta)",
      [](double x, double y) { return std::pow(x * x + y * y, 2) - 2 * (x * x - y * y); }, 100);
  check(
      "r^3 = 1", [](double x, double y) { return std::hypot(x, y) - 1; }, 20);
  check(
      "r^2 = 1; 0 <= theta <= pi/2",
      [](double x, double y) { return x * y >= -1e-9 ? std::hypot(x, y) - 1 : 1; }, 20);
  // Not one power of r: found box by box.
  check(
      "r + r^3 = 2", [](double x, double y) { return std::hypot(x, y) - 1; }, 8);
  check(
      "r^2 + r = 2; 0 <= theta <= pi",
      [](double x, double y) {
        const double r = std::hypot(x, y);
        return std::min(std::abs(r - 1), std::abs(r - 2));
      },
      8);
}

TEST(Trace, ALineOfDotsBecomesALineAndTwoPointsStayApart) {
  const Tracing line = regions("(x^2+y^2-1)^2 + 0 = 0");
  EXPECT_TRUE(line.dots.empty());
  const Tracing two = regions("(x^2+y^2-1)^2 + (x-y)^2 = 0");
  ASSERT_EQ(two.dots.size(), 2U);
  for (const Dot& d : two.dots) EXPECT_NEAR(std::abs(4 * d.at.u - 2), std::sqrt(0.5), 1e-7);
  EXPECT_EQ(two.events.size(), 2U);
  for (const Event& e : two.events) {
    EXPECT_EQ(e.kind, EventKind::isolated);
    EXPECT_NEAR(e.x, e.y, 1e-7);
    EXPECT_TRUE(std::isnan(e.x_after) && std::isnan(e.y_after));
  }
  const Tracing cross = regions("x^3 + y^3 = 3x y");
  ASSERT_EQ(cross.events.size(), 1U);
  EXPECT_EQ(cross.events[0].kind, EventKind::singular);
  EXPECT_NEAR(cross.events[0].x, 0, 1e-9);
}

}  // namespace
}  // namespace nazori::functions
