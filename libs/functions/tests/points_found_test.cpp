// SPDX-License-Identifier: Apache-2.0
// Points of interest and roots, each with its exact place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../src/roots.h"
#include "nazori/functions/points.h"

namespace nazori::functions {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<PointOfInterest> found_in(const std::string& text, const Window& window, std::size_t most = 200) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  const auto tracing = trace(*plot, window);
  EXPECT_TRUE(tracing);
  return points_of_interest(*plot, *tracing, most);
}

struct Known {
  PointKind kind;
  double x, y;
};

/// The points are these; each kind from left to right.
void expect_points(const std::string& text, const Window& window, const std::vector<Known>& known) {
  auto found = found_in(text, window);
  for (std::size_t i = 0; i + 1 < found.size(); ++i) {
    if (!std::isnan(found[i].x) && !std::isnan(found[i + 1].x)) {
      EXPECT_LE(found[i].x, found[i + 1].x) << text;
    }
  }
  ASSERT_EQ(found.size(), known.size()) << text;
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.kind < b.kind; });
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_EQ(found[i].kind, known[i].kind) << text << ' ' << i;
    EXPECT_EQ(found[i].statement, 0) << text;
    EXPECT_EQ(found[i].other, -1) << text;
    // Of y = f(x) the parameter is x.
    if (text.starts_with("y =") && found[i].kind != PointKind::horizontal_asymptote) {
      EXPECT_NEAR(found[i].parameter, known[i].x, 1e-6) << text << ' ' << i;
    }
    for (const auto& [got, wanted] : {std::pair{found[i].x, known[i].x}, std::pair{found[i].y, known[i].y}}) {
      EXPECT_EQ(std::isnan(got), std::isnan(wanted)) << text << ' ' << i;
      if (!std::isnan(wanted)) {
        EXPECT_NEAR(got, wanted, 1e-9) << text << ' ' << i;
      }
    }
  }
}

const double kNaN = std::nan("");
using K = PointKind;

TEST(PointsFound, OfAFunctionFromLeftToRight) {
  const double turn = std::sqrt(1.0 / 3);
  expect_points("y = x^3 - x", {-2, 2, -2, 2},
                {{K::zero, -1, 0},
                 {K::zero, 0, 0},
                 {K::zero, 1, 0},
                 {K::y_intercept, 0, 0},
                 {K::maximum, -turn, 2 * turn / 3},
                 {K::minimum, turn, -2 * turn / 3},
                 {K::inflection, 0, 0}});
  expect_points("y = x^2", {-2, 2, -2, 2}, {{K::zero, 0, 0}, {K::y_intercept, 0, 0}, {K::minimum, 0, 0}});
  expect_points("y = 1 - |x|", {-2, 2, -2, 2},
                {{K::zero, -1, 0}, {K::zero, 1, 0}, {K::y_intercept, 0, 1}, {K::maximum, 0, 1}});
  expect_points(
      "y = 1/(x-1)", {-3, 3, -5, 5},
      {{K::y_intercept, 0, -1}, {K::vertical_asymptote, 1, kNaN}, {K::horizontal_asymptote, kNaN, 0}});
  expect_points("y = x + 1", {1, 3, -5, 5}, {});
  expect_points("y = e^x", {-3, 3, -1, 5}, {{K::y_intercept, 0, 1}, {K::horizontal_asymptote, kNaN, 0}});
  expect_points("y = sqrt(x-1)", {-1, 3, -1, 2}, {{K::zero, 1, 0}, {K::end, 1, 0}});
  expect_points("y = 3", {-1, 3, -1, 5}, {{K::y_intercept, 0, 3}});
}

TEST(PointsFound, OnTheBorderOfTheWindowCountAndBeyondItDoNot) {
  expect_points("y = x - 1", {1, 3, 0, 2}, {{K::zero, 1, 0}});
  expect_points("y = x - 1", {1.001, 3, 0, 2}, {});
  expect_points("y = x + 1", {0, 3, -2, 2}, {{K::y_intercept, 0, 1}});
  expect_points("y = x + 1", {-3, 0, -2, 1}, {{K::zero, -1, 0}, {K::y_intercept, 0, 1}});
  expect_points("y = x + 1", {-0.5, 3, -2, 0.9}, {});
}

TEST(PointsFound, OfAFunctionOfY) {
  expect_points("x = y^2 - 1", {-2, 2, -2, 2},
                {{K::zero, -1, 0}, {K::y_intercept, 0, -1}, {K::y_intercept, 0, 1}});
  expect_points("x = 1/(y - 1)", {-3, 3, -5, 5},
                {{K::zero, -1, 0}, {K::vertical_asymptote, 0, kNaN}, {K::horizontal_asymptote, kNaN, 1}});
}

TEST(PointsFound, OfACurveWithAParameter) {
  // The unit circle round (1, 0): its highest and lowest points and where it crosses the axes.
  const auto found = found_in("x = 1 + cos(t); y = sin(t)", {-3, 3, -2, 2});
  int maxima = 0;
  for (const auto& p : found) {
    if (p.kind == K::maximum) {
      EXPECT_NEAR(p.x, 1, 1e-9);
      EXPECT_NEAR(p.y, 1, 1e-9);
      EXPECT_NEAR(p.parameter, kPi / 2, 1e-9);
      ++maxima;
    }
    if (p.kind == K::minimum) {
      EXPECT_NEAR(p.y, -1, 1e-9);
    }
    if (p.kind == K::zero) {
      EXPECT_TRUE(std::abs(p.x) < 1e-9 || std::abs(p.x - 2) < 1e-9);
    }
  }
  EXPECT_EQ(maxima, 1);
  // y falls from its first maximum at t = 0 on, but the curve runs to the left: still a minimum where y is
  // least.
  const auto turned = found_in("x = -t; y = (t - 1)^2; 0 <= t <= 3", {-4, 1, -1, 5});
  bool has_minimum = false;
  for (const auto& p : turned)
    has_minimum = has_minimum || (p.kind == K::minimum && std::abs(p.x + 1) < 1e-9);
  EXPECT_TRUE(has_minimum);
  // (t^2, t^3 - t) crosses itself at (1, 0).
  const auto loop = found_in("x = t^2; y = t^3 - t; -2 <= t <= 2", {-1, 4, -3, 3});
  std::vector<PointOfInterest> crossings;
  for (const auto& p : loop) {
    if (p.kind == K::self_crossing) crossings.push_back(p);
  }
  ASSERT_EQ(crossings.size(), 1U);
  EXPECT_NEAR(crossings[0].x, 1, 1e-12);
  EXPECT_NEAR(crossings[0].y, 0, 1e-12);
}

TEST(PointsFound, OfEquationsAreInterceptsAndLevelPlaces) {
  // Level where 2x + y = 0: at 3x^2 = 4.
  const double top = 2 / std::sqrt(3.0);
  expect_points("x^2 + x y + y^2 = 4", {-3, 3, -3, 3},
                {{K::zero, -2, 0},
                 {K::zero, 2, 0},
                 {K::y_intercept, 0, -2},
                 {K::y_intercept, 0, 2},
                 {K::maximum, -top, 2 * top},
                 {K::minimum, top, -2 * top}});
  expect_points("x^2 + x y + y^2 = 4", {1, 3, -3, 3}, {{K::zero, 2, 0}, {K::minimum, top, -2 * top}});
  expect_points("x^2 + x y + y^2 = 4", {-3, 3, 1, 3}, {{K::y_intercept, 0, 2}, {K::maximum, -top, 2 * top}});
  // All of the x axis: no points on it.
  expect_points("x y (x^2 + y^2 - 1) = 0", {2, 3, -3, 3}, {});
  // A zero where the equation is undefined does not count.
  expect_points("(x^2 + y^2 - 4)/(x - 2) = 0", {1, 3, -1, 1}, {});
}

TEST(PointsFound, OfTwoCurvesBelongToTheFirst) {
  const auto found = found_in("y = x; x^2 + y^2 = 2", {-2, 2, -2, 2});
  int crossings = 0;
  for (const auto& p : found) {
    if (p.kind != K::crossing) continue;
    EXPECT_EQ(p.statement, 0);
    EXPECT_EQ(p.other, 1);
    EXPECT_NEAR(std::abs(p.x), 1, 1e-12);
    EXPECT_EQ(p.x_name, p.x < 0 ? "-1" : "1");
    ++crossings;
  }
  EXPECT_EQ(crossings, 2);
  for (std::size_t i = 0; i + 1 < found.size(); ++i) EXPECT_LE(found[i].statement, found[i + 1].statement);
  // The arc may be the second: the circle touches y = 1 at (0, 1).
  const auto touch = found_in("x^2 + y^2 = 1; y = 1", {-2, 2, -2, 2});
  int touches = 0;
  for (const auto& p : touch) {
    if (p.kind == K::touching) {
      ++touches;
      EXPECT_NEAR(p.x, 0, 1e-9);
      EXPECT_EQ(p.y, 1);
    }
  }
  EXPECT_EQ(touches, 1);
  // Two equations: made exact from where their lines cross.
  const auto both = found_in("x^2 + y^2 = 5; x y = 2 + 0x^3 y", {0.5, 3, 0.5, 3});
  std::vector<double> places;
  for (const auto& p : both) {
    if (p.kind == K::crossing) places.push_back(p.x);
  }
  ASSERT_EQ(places.size(), 2U);
  EXPECT_NEAR(places[0], 1, 1e-12);
  EXPECT_NEAR(places[1], 2, 1e-12);
  // A curve over itself crosses nowhere.
  for (const auto& p : found_in("y = x^2; y = x x", {-2, 2, -2, 2})) EXPECT_NE(p.kind, K::crossing);
}

TEST(PointsFound, AreNoMoreThanAskedForOfEachStatement) {
  const auto found = found_in("y = sin(20x); y = cos(20x) + 3", {-3, 3, -2, 5}, 7);
  int first = 0;
  for (const auto& p : found) first += p.statement == 0 ? 1 : 0;
  EXPECT_EQ(first, 7);
  EXPECT_EQ(found.size(), 14U);
  EXPECT_TRUE(found_in("z = x y", {-3, 3, -2, 5}).empty());
}

TEST(PointsFound, InflectionsAreWhereTheBendTurns) {
  for (const auto& [text, count] :
       {std::pair{"y = sin(x)", 3}, std::pair{"y = x^4", 0}, std::pair{"y = atan(x)", 1},
        std::pair{"y = 2x + 1", 0}, std::pair{"y = x^3 - 3x^2", 1}}) {
    int inflections = 0;
    for (const auto& p : found_in(text, {-4, 4, -5, 5})) {
      if (p.kind != K::inflection) continue;
      ++inflections;
      if (std::string(text) == "y = x^3 - 3x^2") {
        EXPECT_EQ(p.x, 1) << "snapped to what is meant";
        EXPECT_NEAR(p.y, -2, 1e-12);
      }
    }
    EXPECT_EQ(inflections, count) << text;
  }
}

Roots roots_of(const std::string& text, double low = -4, double high = 4) {
  const auto plot = parse("x + y = " + text);
  EXPECT_TRUE(plot) << text;
  return find_roots(plot->statements[0].terms[1], Variable::x, low, high);
}

TEST(RootsFound, AreSortedAndToldToCrossOrTouch) {
  struct Zero {
    double at;
    bool crosses;
  };
  const std::pair<const char*, std::vector<Zero>> cases[] = {
      {"x^2 - 2", {{-std::sqrt(2), true}, {std::sqrt(2), true}}},
      {"(x-1)^2", {{1, false}}},
      {"(x-1)^2(x+2)", {{-2, true}, {1, false}}},
      {"(x-1)^3", {{1, true}}},
      {"(x-0.7)^4", {{0.7, false}}},
      {"sin(x)", {{-kPi, true}, {0, true}, {kPi, true}}},
      {"1 - cos(x)", {{0, false}}},
      {"x", {{0, true}}},
      {"x + 4", {{-4, true}}},
      {"x - 4", {{4, true}}},
      {"x^2 + 1", {}},
      {"1/x", {}},
      {"floor(x) + 0.5", {}},
      {"5", {}},
      {"x - 5", {}},
      {"(x-1)(x-1.001)", {{1, true}, {1.001, true}}},
      {"ln(x)", {{1, true}}},
      {"tan(x)", {{-kPi, true}, {0, true}, {kPi, true}}}};
  for (const auto& [text, zeros] : cases) {
    const Roots found = roots_of(text);
    ASSERT_EQ(found.roots.size(), zeros.size()) << text;
    if (std::string(text) != "1/x") {
      EXPECT_EQ(found.undecided, 0) << text;
    }
    for (std::size_t i = 0; i < zeros.size(); ++i) {
      EXPECT_NEAR(found.roots[i].at, zeros[i].at, 1e-9) << text;
      EXPECT_EQ(found.roots[i].crosses, zeros[i].crosses) << text << ' ' << zeros[i].at;
    }
    EXPECT_FALSE(found.has_ranges) << text;
  }
  EXPECT_TRUE(roots_of("floor(x)").has_ranges);
  // Zero at the jumps themselves.
  const Roots jumps = roots_of("x - floor(x)", -3.5, 3.6);
  ASSERT_EQ(jumps.roots.size(), 7U);
  for (int k = -3; k <= 3; ++k) EXPECT_EQ(jumps.roots[static_cast<std::size_t>(k + 3)].at, k);
}

}  // namespace
}  // namespace nazori::functions
