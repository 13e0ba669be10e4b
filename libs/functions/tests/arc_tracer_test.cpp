// SPDX-License-Identifier: Apache-2.0
// What is found of a curve that is given by a parameter: pieces, breaks, bars, ends.
#include "../src/arc_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/functions/tracing.h"

namespace nazori::functions {
namespace {

constexpr double kPi = std::numbers::pi;

Tracing traced(const std::string& text, const Window& window, const TraceSettings& settings = {}) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  auto tracing = trace(*plot, window, settings);
  EXPECT_TRUE(tracing) << text;
  EXPECT_TRUE(tracing->complete);
  return *tracing;
}

std::vector<Event> events_of(const Tracing& t, EventKind kind) {
  std::vector<Event> some;
  for (const Event& e : t.events) {
    if (e.kind == kind) some.push_back(e);
  }
  std::sort(some.begin(), some.end(),
            [](const Event& a, const Event& b) { return a.parameter < b.parameter; });
  return some;
}

TEST(ArcTracer, TheLineStaysWithinAThirtySecondOfACellOfTheCurve) {
  for (const auto& [resolution, tolerance] : {std::pair{32, 1.0 / 1024}, std::pair{512, 1.0 / 16384}}) {
    TraceSettings settings;
    settings.resolution = resolution;
    const Window w{-3, 3, -2, 2};
    const Tracing t = traced("y = sin(3x)", w, settings);
    ASSERT_EQ(t.branches.size(), 1U);
    const auto& points = t.branches[0].points;
    EXPECT_TRUE(t.branches[0].has_parameter);
    EXPECT_FALSE(t.branches[0].closed);
    // Followed a fiftieth beyond the window, as the margin says.
    EXPECT_NEAR(points.front().u, -0.02, 1e-12);
    EXPECT_NEAR(points.back().u, 1.02, 1e-12);
    double most = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      ASSERT_LT(points[i].parameter, points[i + 1].parameter);
      ASSERT_NEAR(w.u(points[i].parameter), points[i].u, 1e-12);
      ASSERT_NEAR(w.v(std::sin(3 * points[i].parameter)), points[i].v, 1e-12);
      for (const double share : {0.25, 0.5, 0.75}) {
        const double u = points[i].u + (points[i + 1].u - points[i].u) * share;
        const double v = points[i].v + (points[i + 1].v - points[i].v) * share;
        // The distance across is at most the one straight up.
        const double slope = std::abs(3 * std::cos(3 * w.x(u)) * 6 / 4);
        most = std::max(most, std::abs(v - w.v(std::sin(3 * w.x(u)))) / std::hypot(1, slope));
      }
    }
    EXPECT_LT(most, tolerance);
    EXPECT_GT(most, tolerance / 40) << "no more points than it takes";
  }
}

TEST(ArcTracer, WhatLeavesTheWindowIsLeftOut) {
  const Tracing t = traced("y = x^2", {-4, 4, -1, 4});
  ASSERT_EQ(t.branches.size(), 1U);
  for (const CurvePoint& p : t.branches[0].points) EXPECT_LT(p.v, 1.2);
  EXPECT_NEAR(t.window.x(t.branches[0].points.front().u), -2.02, 0.08);
  EXPECT_EQ(traced("y = x^2 - 2", {-4, 4, -1, 1}).branches.size(), 2U);
  EXPECT_TRUE(traced("y = x^2 + 5", {-4, 4, -1, 4}).branches.empty());
  EXPECT_TRUE(traced("x = 5; y = 2; 0 <= t <= 1", {-4, 4, -1, 4}).branches.empty());
  TraceSettings wide;
  wide.margin = 0.5;
  EXPECT_NEAR(traced("y = 0", {-1, 1, -1, 1}, wide).branches[0].points.front().u, -0.5, 1e-12);
  wide.margin = 0;
  EXPECT_NEAR(traced("y = 0", {-1, 1, -1, 1}, wide).branches[0].points.front().u, 0, 1e-12);
}

TEST(ArcTracer, TellsPolesWithTheirPlace) {
  const Tracing t = traced("y = 1/(x - 1) + 1/(x + 0.5)^2", {-3, 3, -5, 5});
  const auto poles = events_of(t, EventKind::pole);
  ASSERT_EQ(poles.size(), 2U);
  EXPECT_NEAR(poles[0].parameter, -0.5, 1e-11);
  EXPECT_NEAR(poles[1].parameter, 1, 1e-11);
  EXPECT_EQ(poles[1].x, poles[1].parameter);
  EXPECT_TRUE(std::isnan(poles[0].y));
  EXPECT_TRUE(std::isnan(poles[0].x_after));
  EXPECT_EQ(t.events.size(), 2U);
  EXPECT_EQ(t.branches.size(), 3U);
  const auto sideways = events_of(traced("x = 1/y", {-3, 3, -5, 5}), EventKind::pole);
  ASSERT_EQ(sideways.size(), 1U);
  EXPECT_NEAR(sideways[0].y, 0, 1e-11);
  EXPECT_EQ(events_of(traced("y = ln(x)", {-3, 3, -5, 5}), EventKind::pole).size(), 1U);
  EXPECT_EQ(events_of(traced("y = 100/x", {-3, 3, -5, 5}), EventKind::pole).size(), 1U)
      << "though it is out of sight";
}

TEST(ArcTracer, TellsJumpsWithBothSides) {
  const Tracing t = traced("y = 2floor(x) + 0.5", {-1.5, 1.5, -4, 4});
  const auto jumps = events_of(t, EventKind::jump);
  ASSERT_EQ(jumps.size(), 3U);
  for (int k = -1; k <= 1; ++k) {
    const Event& e = jumps[static_cast<std::size_t>(k + 1)];
    EXPECT_NEAR(e.parameter, k, 1e-11);
    EXPECT_NEAR(e.x, k, 1e-11);
    EXPECT_NEAR(e.y, 2 * (k - 1) + 0.5, 1e-9);
    EXPECT_NEAR(e.y_after, 2 * k + 0.5, 1e-9);
    EXPECT_NEAR(e.x_after, k, 1e-9);
    EXPECT_EQ(e.statement, 0);
  }
  EXPECT_EQ(t.branches.size(), 4U);
  EXPECT_TRUE(t.dots.empty());
  // Where the value itself lies apart from both sides it is a point of its own.
  const Tracing apart = traced("y = sign(x)", {-2, 2, -2, 2});
  ASSERT_EQ(apart.dots.size(), 1U);
  EXPECT_NEAR(apart.dots[0].at.v, 0.5, 1e-12);
  const auto isolated = events_of(apart, EventKind::isolated);
  ASSERT_EQ(isolated.size(), 1U);
  EXPECT_EQ(isolated[0].x, 0);
  EXPECT_EQ(isolated[0].y, 0);
  EXPECT_EQ(events_of(apart, EventKind::jump).size(), 1U);
}

TEST(ArcTracer, TellsHolesAndJoinsWhatLiesAroundThem) {
  const Tracing t = traced("y = (x^2 - 1)/(x - 1)", {-4, 4, -4, 4});
  const auto holes = events_of(t, EventKind::hole);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_NEAR(holes[0].parameter, 1, 1e-11);
  EXPECT_NEAR(holes[0].x, 1, 1e-11);
  EXPECT_NEAR(holes[0].y, 2, 1e-9);
  EXPECT_EQ(t.branches.size(), 1U);
  EXPECT_EQ(t.events.size(), 1U);
  EXPECT_TRUE(traced("y = (x^2 - 1)/(x - 1)", {-4, 4, 3, 9}).events.empty()) << "out of sight";
  // The value at the gap is a separate point: 1 - |sign(x)|.
  const Tracing apart = traced("y = 1 - |sign(x)|", {-2, 2, -2, 2});
  EXPECT_EQ(apart.branches.size(), 1U);
  ASSERT_EQ(apart.dots.size(), 1U);
  EXPECT_NEAR(apart.dots[0].at.v, 0.75, 1e-12);
  EXPECT_EQ(events_of(apart, EventKind::isolated).size(), 1U);
  EXPECT_EQ(events_of(apart, EventKind::hole).size(), 1U);
}

TEST(ArcTracer, TellsWhereADomainEnds) {
  const auto ends = events_of(traced("y = sqrt(1 - x^2)", {-2, 2, -2, 2}), EventKind::end);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_NEAR(ends[0].x, -1, 1e-11);
  EXPECT_NEAR(ends[1].x, 1, 1e-11);
  EXPECT_NEAR(ends[0].y, 0, 1e-5);
  const auto sideways = events_of(traced("x = asin(y)", {-2, 2, -2, 2}), EventKind::end);
  ASSERT_EQ(sideways.size(), 2U);
  EXPECT_NEAR(sideways[1].y, 1, 1e-11);
  EXPECT_NEAR(sideways[1].x, kPi / 2, 1e-5);
  EXPECT_TRUE(traced("y = sqrt(x)", {-2, 2, 1, 2}).events.empty()) << "the end is out of sight";
  const auto points = events_of(traced("y = sqrt(-x^2)", {-2, 2, -2, 2}), EventKind::isolated);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].x, 0);
}

TEST(ArcTracer, TheEndsOfAParameterAreEndsUnlessTheyMeet) {
  const Tracing arc = traced("x = cos(t); y = sin(t); 0 <= t <= pi", {-2, 2, -2, 2});
  const auto ends = events_of(arc, EventKind::end);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[0].parameter, 0);
  EXPECT_NEAR(ends[1].parameter, kPi, 1e-15);
  EXPECT_NEAR(ends[1].x, -1, 1e-12);
  ASSERT_EQ(arc.branches.size(), 1U);
  EXPECT_FALSE(arc.branches[0].closed);
  const Tracing ring = traced("x = cos(t); y = sin(t)", {-2, 2, -2, 2});
  EXPECT_TRUE(ring.events.empty());
  ASSERT_EQ(ring.branches.size(), 1U);
  EXPECT_TRUE(ring.branches[0].closed);
  EXPECT_TRUE(traced("x = 9cos(t); y = sin(t); 0 <= t <= 3", {-2, 2, -2, 2}).events.empty())
      << "out of sight";
  // An excluded end: the drawn curve comes as near as numbers allow, and the end itself is reported.
  const Tracing open = traced("x = t; y = t; 0 <= t < 1", {-2, 2, -2, 2});
  EXPECT_EQ(events_of(open, EventKind::end)[1].x, 1);
  EXPECT_LT(open.branches[0].points.back().parameter, 1);
  EXPECT_GT(open.branches[0].points.back().parameter, 1 - 1e-12);
  EXPECT_EQ(traced("x = t; y = t; 0 <= t <= 1", {-2, 2, -2, 2}).branches[0].points.back().parameter, 1);
  // The last value after a jump is a point, unless it is excluded.
  EXPECT_EQ(traced("x = floor(t); y = 1; 0 <= t <= 1", {-2, 2, -2, 2}).dots.size(), 2U);
  EXPECT_EQ(traced("x = floor(t); y = 1; 0 <= t < 1", {-2, 2, -2, 2}).dots.size(), 1U);
}

TEST(ArcTracer, ACurveThatStandsStillIsAPoint) {
  const Tracing still = traced("x = 1; y = 0.5; 0 <= t <= 3", {-2, 2, -2, 2});
  EXPECT_TRUE(still.branches.empty());
  ASSERT_EQ(still.dots.size(), 1U);
  EXPECT_NEAR(still.dots[0].at.u, 0.75, 1e-15);
  EXPECT_EQ(events_of(still, EventKind::isolated).size(), 1U);
  const Tracing moment = traced("x = t; y = t^2; 1 <= t <= 1", {-2, 2, -2, 2});
  EXPECT_TRUE(moment.branches.empty());
  EXPECT_EQ(moment.dots.size(), 1U);
  EXPECT_TRUE(traced("x = t; y = t^2; 3 <= t <= 3", {-2, 2, -2, 2}).dots.empty());
}

/// What the bars cover of every quarter of a cell across them: from and to.
std::vector<std::pair<double, double>> covered(const Tracing& t, bool upright) {
  std::vector<std::pair<double, double>> all(256, {1, 0});
  for (const Bar& b : t.bars) {
    EXPECT_EQ(upright ? b.from.u : b.from.v, upright ? b.to.u : b.to.v);
    const double across = upright ? b.from.u : b.from.v;
    if (across < 0 || across >= 1) continue;
    auto& [low, high] = all[static_cast<std::size_t>(across * 256)];
    low = std::min(low, upright ? b.from.v : b.from.u);
    high = std::max(high, upright ? b.to.v : b.to.u);
  }
  return all;
}

TEST(ArcTracer, ABandFinerThanACellIsDrawnAsBarsOverItsWholeHeight) {
  TraceSettings settings;
  settings.resolution = 64;
  for (const bool upright : {true, false}) {
    const Tracing t = upright ? traced("y = sin(100000x)", {-1, 1, -2, 2}, settings)
                              : traced("x = sin(100000y)", {-2, 2, -1, 1}, settings);
    EXPECT_TRUE(t.dense);
    for (const auto& [low, high] : covered(t, upright)) {
      EXPECT_NEAR(low, 0.25, 0.03);
      EXPECT_NEAR(high, 0.75, 0.03);
    }
    // Those that overlap in a quarter of a cell are one.
    EXPECT_LT(t.bars.size(), 270U);
    EXPECT_LT(t.undecided_share(), 1e-3);
  }
  EXPECT_FALSE(traced("y = sin(30x)", {-1, 1, -2, 2}, settings).dense);
  EXPECT_TRUE(traced("y = sin(30x)", {-1, 1, -2, 2}, settings).bars.empty());
}

TEST(ArcTracer, WhatCannotBeDecidedIsCountedAndPlaced) {
  TraceSettings settings;
  settings.resolution = 64;
  const Tracing t = traced("y = tan(1/x)", {-1, 1, -2, 2}, settings);
  EXPECT_GT(t.undecided_cells, 0);
  EXPECT_LT(t.undecided_share(), 0.05);
  EXPECT_EQ(t.cells, 64 * 64);
  ASSERT_FALSE(t.undecided_places.empty());
  EXPECT_LE(t.undecided_places.size(), 1000U);
  const auto in_the_middle = [](const PlatePoint& p) { return std::abs(p.u - 0.5) < 0.01; };
  EXPECT_GT(std::count_if(t.undecided_places.begin(), t.undecided_places.end(), in_the_middle), 30);
  EXPECT_EQ(traced("y = x^3 - x", {-1, 1, -2, 2}, settings).undecided_cells, 0);
}

TEST(ArcTracer, WhatOverflowsIsFollowedInLongDoubles) {
  const Tracing t = traced("y = e^x/(1 + e^x)^1", {-2000, 2000, -0.5, 1.5});
  ASSERT_EQ(t.branches.size(), 1U);
  EXPECT_NEAR(t.branches[0].points.back().v, 0.75, 1e-9);
  const Tracing quotient = traced("y = (3e^x + x)/(e^x + 1)", {700, 900, 0, 6});
  ASSERT_EQ(quotient.branches.size(), 1U);
  EXPECT_NEAR(quotient.branches[0].points.back().v, 0.5, 1e-9);
  EXPECT_EQ(quotient.undecided_cells, 0);
}

TEST(ArcTracer, OpenEndsAreKnownByTheirHair) {
  Arc arc{variable(Variable::t), variable(Variable::t), Variable::t, 0, 2, true, true, false};
  // Twice as far as breaks are enclosed: 2^-44 of the range.
  EXPECT_DOUBLE_EQ(arc.hair(), 4 * std::exp2(-44));
  EXPECT_TRUE(arc.is_open_end(0));
  EXPECT_TRUE(arc.is_open_end(2 * arc.hair()));
  EXPECT_FALSE(arc.is_open_end(3 * arc.hair()));
  EXPECT_FALSE(arc.is_open_end(2));
  arc.from_is_open = false;
  arc.to_is_open = true;
  EXPECT_FALSE(arc.is_open_end(0));
  EXPECT_TRUE(arc.is_open_end(2 - 2 * arc.hair()));
  EXPECT_FALSE(arc.is_open_end(2 - 3 * arc.hair()));
  // Of large numbers their own last places.
  arc.from = 1e6;
  arc.to = 1e6 + 1e-3;
  EXPECT_DOUBLE_EQ(arc.hair(), 16 * std::numeric_limits<double>::epsilon() * arc.to);
  arc.from = -3e6;
  EXPECT_GT(arc.hair(), 2 * 4e6 * std::exp2(-44) - 1e-12);
}

TEST(Trace, TellsHowFarItIsAndStopsWhenAsked) {
  const auto plot = parse("y = sin(9x); x^2 + y^2 = 1; y > x^2; y = 2x");
  ASSERT_TRUE(plot);
  std::vector<double> reports;
  const auto all = trace(*plot, {-2, 2, -2, 2}, {}, [&](double done, std::string_view step) {
    EXPECT_EQ(step, "tracing");
    reports.push_back(done);
    return true;
  });
  ASSERT_TRUE(all);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_EQ(reports.front(), 0);
  EXPECT_GT(reports.back(), 0.9);
  EXPECT_LE(reports.back(), 1);
  // The second of four statements begins at a quarter.
  EXPECT_TRUE(std::find(reports.begin(), reports.end(), 0.25) != reports.end());
  EXPECT_TRUE(std::find(reports.begin(), reports.end(), 0.75) != reports.end());
  for (const std::size_t stop :
       {std::size_t{0}, reports.size() / 3, reports.size() / 2, reports.size() - 1}) {
    std::size_t calls = 0;
    const auto stopped =
        trace(*plot, {-2, 2, -2, 2}, {}, [&](double, std::string_view) { return calls++ < stop; });
    ASSERT_FALSE(stopped) << stop;
    EXPECT_EQ(stopped.error().code, base::Errc::cancelled);
    EXPECT_EQ(calls, stop + 1) << "not asked again";
  }
}

TEST(Trace, RefusesSettingsAndWindowsOutOfRange) {
  const auto plot = parse("y = x");
  ASSERT_TRUE(plot);
  const auto good = [&](const Window& w, int resolution = 64, double margin = 0.02) {
    TraceSettings settings;
    settings.resolution = resolution;
    settings.margin = margin;
    return trace(*plot, w, settings).has_value();
  };
  const Window w{-1, 1, -1, 1};
  EXPECT_TRUE(good(w, 32));
  EXPECT_FALSE(good(w, 31));
  EXPECT_TRUE(good(w, 8192));
  EXPECT_FALSE(good(w, 8193));
  EXPECT_TRUE(good(w, 64, 0));
  EXPECT_FALSE(good(w, 64, -0.001));
  EXPECT_TRUE(good(w, 64, 1));
  EXPECT_FALSE(good(w, 64, 1.001));
  EXPECT_FALSE(good(w, 64, std::nan("")));
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(good({-inf, 1, -1, 1}));
  EXPECT_FALSE(good({-1, inf, -1, 1}));
  EXPECT_FALSE(good({-1, 1, 1, 1}));
  EXPECT_FALSE(good({-1, 1, 1, -1}));
  EXPECT_FALSE(good({-1e308, 1e308, -1, 1})) << "wider than a double";
  EXPECT_TRUE(good({1, 1 + 1.1e-10, -1, 1}));
  EXPECT_FALSE(good({1, 1 + 0.9e-10, -1, 1}));
  EXPECT_FALSE(good({-1 - 0.9e-10, -1, -1, 1}));
  EXPECT_TRUE(good({-1, 1, 0, 2e-290}));
  EXPECT_FALSE(good({-1, 1, 0, 0.5e-290}));
}

}  // namespace
}  // namespace nazori::functions
