// SPDX-License-Identifier: Apache-2.0
// Lines joined from segments, where they cross, and how a crossing is made exact.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "../src/arc_probe.h"
#include "../src/plane_tracer.h"
#include "../src/polyline_crossings.h"
#include "drawn_lines.h"

namespace nazori::functions {
namespace {

using test::line;
using test::tracing_of;

using Segment = PlaneSolution::Segment;

std::vector<std::size_t> lengths_of(const std::vector<std::vector<PlatePoint>>& lines) {
  std::vector<std::size_t> lengths;
  for (const auto& l : lines) lengths.push_back(l.size());
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

TEST(Stitched, SegmentsThatShareAnEndBecomeOneLineInItsOrder) {
  // Out of order and turned round.
  const auto lines = stitched(
      {{{0.2, 0}, {0.3, 0.1}}, {{0.1, 0}, {0.0, 0}}, {{0.2, 0}, {0.1, 0}}, {{0.4, 0}, {0.3, 0.1}}}, 1e-6);
  ASSERT_EQ(lines.size(), 1U);
  std::vector<PlatePoint> wanted{{0.0, 0}, {0.1, 0}, {0.2, 0}, {0.3, 0.1}, {0.4, 0}};
  if (lines[0].front().u > 0.2) std::reverse(wanted.begin(), wanted.end());
  EXPECT_EQ(lines[0], wanted);
}

TEST(Stitched, ARingEndsWhereItBegan) {
  const std::array<PlatePoint, 4> c{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const auto lines = stitched({{c[0], c[1]}, {c[2], c[1]}, {c[2], c[3]}, {c[0], c[3]}}, 1e-6);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].size(), 5U);
  EXPECT_EQ(lines[0].front(), lines[0].back());
}

TEST(Stitched, WhereThreeMeetLinesEnd) {
  const PlatePoint hub{0.5, 0.5};
  const auto lines =
      stitched({{{0.1, 0.5}, {0.3, 0.5}}, {{0.3, 0.5}, hub}, {hub, {0.7, 0.6}}, {{0.7, 0.4}, hub}}, 1e-6);
  EXPECT_EQ(lengths_of(lines), (std::vector<std::size_t>{2, 2, 3}));
  // A ring that hangs on a line begins and ends where they meet.
  const auto lasso =
      stitched({{{0, 0}, hub}, {hub, {0.6, 0.7}}, {{0.6, 0.7}, {0.7, 0.6}}, {{0.7, 0.6}, hub}}, 1e-6);
  EXPECT_EQ(lengths_of(lasso), (std::vector<std::size_t>{2, 4}));
  // Two rings that share a point.
  const auto eight = stitched({{hub, {0.6, 0.7}},
                               {{0.6, 0.7}, {0.7, 0.6}},
                               {{0.7, 0.6}, hub},
                               {hub, {0.4, 0.3}},
                               {{0.4, 0.3}, {0.3, 0.4}},
                               {{0.3, 0.4}, hub}},
                              1e-6);
  EXPECT_EQ(lengths_of(eight), (std::vector<std::size_t>{4, 4}));
}

TEST(Stitched, EndsWithinTheToleranceAreOneAndBeyondItTwo) {
  constexpr double kTolerance = 1e-3;
  // In every direction, also over the border of a cell of the index and below zero.
  for (int i = 0; i < 64; ++i) {
    const double angle = 0.0982 * i;
    for (const double at : {0.0, 0.0005, -0.3}) {
      const PlatePoint p{at, at};
      const auto beside = [&](double off) {
        return PlatePoint{p.u + off * std::cos(angle), p.v + off * std::sin(angle)};
      };
      EXPECT_EQ(stitched({{{0.7, 0.1}, p}, {beside(0.98e-3), {0.1, 0.7}}}, kTolerance).size(), 1U) << i;
      EXPECT_EQ(stitched({{{0.7, 0.1}, p}, {beside(1.02e-3), {0.1, 0.7}}}, kTolerance).size(), 2U) << i;
    }
  }
}

TEST(Stitched, ASegmentWithoutLengthIsALineOfItsOwn) {
  const auto lines = stitched({{{0.5, 0.5}, {0.5, 0.5}}, {{0, 0}, {1, 0}}}, 1e-6);
  EXPECT_EQ(lengths_of(lines), (std::vector<std::size_t>{2, 2}));
  EXPECT_TRUE(stitched({}, 1e-6).empty());
}

TEST(Crossings, OfTwoLinesLieWhereTheyMeetWithTheirParameters) {
  const auto found = crossings_of(
      tracing_of({line({{0, 0.2, 10}, {1, 0.7, 20}}, 0), line({{0.6, 0, 1}, {0.6, 1, 2}}, 1)}), 0, 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].at.u, 0.6, 1e-12);
  EXPECT_NEAR(found[0].at.v, 0.5, 1e-12);
  EXPECT_NEAR(found[0].first, 16, 1e-12);
  EXPECT_NEAR(found[0].second, 1.5, 1e-12);
}

TEST(Crossings, AnEndThatTouchesCountsAndOneThatDoesNotDoesNot) {
  const auto count = [](double end) {
    return crossings_of(
               tracing_of({line({{0.1, 0.5, 0}, {end, 0.5, 1}}, 0), line({{0.6, 0.1, 0}, {0.6, 0.9, 1}}, 1)}),
               0, 1)
        .size();
  };
  EXPECT_EQ(count(0.6), 1U);
  EXPECT_EQ(count(0.601), 1U);
  EXPECT_EQ(count(0.5999), 0U);
  const auto from_below = [](double low, double high) {
    return crossings_of(tracing_of({line({{0.1, 0.5, 0}, {0.9, 0.5, 1}}, 0),
                                    line({{0.6, low, 0}, {0.6, high, 1}}, 1)}),
                        0, 1)
        .size();
  };
  EXPECT_EQ(from_below(0.5, 0.9), 1U);
  EXPECT_EQ(from_below(0.1, 0.5), 1U);
  EXPECT_EQ(from_below(0.5001, 0.9), 0U);
  EXPECT_EQ(from_below(0.1, 0.4999), 0U);
  // Beside each other they never meet, nor do other statements count.
  EXPECT_TRUE(
      crossings_of(tracing_of({line({{0, 0.5, 0}, {1, 0.5, 1}}, 0), line({{0, 0.5, 0}, {1, 0.5, 1}}, 1)}), 0,
                   1)
          .empty());
  EXPECT_TRUE(
      crossings_of(tracing_of({line({{0, 0.5, 0}, {1, 0.5, 1}}, 0), line({{0.5, 0, 0}, {0.5, 1, 1}}, 2)}), 0,
                   1)
          .empty());
}

TEST(Crossings, OfOneLineWithItselfLeaveOutItsNeighbours) {
  // A loop: the last piece crosses the first.
  const Branch loop = line({{0.2, 0.2, 0}, {0.8, 0.8, 1}, {0.8, 0.2, 2}, {0.2, 0.8, 3}}, 0);
  const auto found = crossings_of(tracing_of({loop}), 0, 0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].at.u, 0.5, 1e-12);
  EXPECT_NEAR(found[0].at.v, 0.5, 1e-12);
  EXPECT_NEAR(found[0].first, 0.5, 1e-12);
  EXPECT_NEAR(found[0].second, 2.5, 1e-12);
  // The first and last piece of a closed line are neighbours, those of an open one are not.
  std::vector<CurvePoint> square{{0.2, 0.2, 0}, {0.8, 0.2, 1}, {0.8, 0.8, 2}, {0.2, 0.8, 3}, {0.2, 0.2, 4}};
  EXPECT_TRUE(crossings_of(tracing_of({line(square, 0, true)}), 0, 0).empty());
  EXPECT_EQ(crossings_of(tracing_of({line(square, 0, false)}), 0, 0).size(), 1U);
  // Two branches of one statement cross as well, whatever their numbers.
  EXPECT_EQ(crossings_of(tracing_of({line({{0.1, 0.4, 0}, {0.9, 0.4, 1}}, 0),
                                     line({{0.3, 0.1, 0}, {0.3, 0.9, 1}}, 0)}),
                         0, 0)
                .size(),
            1U);
}

TEST(Crossings, EachPlaceIsToldOnceAndOutsideTheWindowNone) {
  // Through a corner of both lines: four pieces meet there.
  const auto corner = crossings_of(tracing_of({line({{0.1, 0.5, 0}, {0.5, 0.5, 1}, {0.9, 0.6, 2}}, 0),
                                               line({{0.5, 0.1, 0}, {0.5, 0.5, 1}, {0.4, 0.9, 2}}, 1)}),
                                   0, 1);
  EXPECT_EQ(corner.size(), 1U);
  // 2e-4 apart are two, 5e-5 are one.
  for (const auto& [gap, count] : {std::pair{2e-4, 2U}, std::pair{5e-5, 1U}}) {
    EXPECT_EQ(
        crossings_of(tracing_of({line({{0, 0.5, 0}, {1, 0.5, 1}}, 0), line({{0.5, 0, 0}, {0.5, 1, 1}}, 1),
                                 line({{0.5 + gap, 0, 0}, {0.5 + gap, 1, 1}}, 1)}),
                     0, 1)
            .size(),
        count)
        << gap;
  }
  for (const auto& [u, v] :
       {std::pair{1.1, 0.5}, std::pair{-0.1, 0.5}, std::pair{0.5, 1.1}, std::pair{0.5, -0.1}}) {
    EXPECT_TRUE(crossings_of(tracing_of({line({{u - 0.05, v, 0}, {u + 0.05, v, 1}}, 0),
                                         line({{u, v - 0.05, 0}, {u, v + 0.05, 1}}, 1)}),
                             0, 1)
                    .empty());
  }
}

TEST(Crossings, AreFourHundredAtMost) {
  std::vector<Branch> lines;
  for (int i = 0; i < 25; ++i) {
    const double c = (i + 0.5) / 25;
    lines.push_back(line({{c, 0, 0}, {c, 1, 1}}, 0));
    lines.push_back(line({{0, c, 0}, {1, c, 1}}, 1));
  }
  EXPECT_EQ(crossings_of(tracing_of(lines), 0, 1).size(), 400U);
  lines.resize(38);
  EXPECT_EQ(crossings_of(tracing_of(lines), 0, 1).size(), 361U);
}

TEST(ArcProbe, TellsValuesSlopesAndMinima) {
  const Expression t = variable(Variable::t);
  const Arc arc{binary(NodeKind::power, t, number(3)), binary(NodeKind::power, t, number(2)), Variable::t, -2,
                2};
  ArcProbe probe(arc);
  const auto at = probe.at(1.5);
  EXPECT_DOUBLE_EQ(at.x, 3.375);
  EXPECT_DOUBLE_EQ(at.y, 2.25);
  EXPECT_DOUBLE_EQ(at.slope_x, 6.75);
  EXPECT_DOUBLE_EQ(at.slope_y, 3);
  EXPECT_TRUE(probe.slope_y(1.5).contains(3));
  EXPECT_LT(probe.slope_y(1.5).width(), 1e-12);
}

TEST(ArcProbe, SignChangesAreFoundOnceAndFlatPiecesAreNone) {
  const auto points = [](std::vector<double> parameters) {
    std::vector<CurvePoint> all;
    for (const double p : parameters) all.push_back({p, 0, p});
    return all;
  };
  struct Change {
    double at;
    bool rising;
  };
  const auto changes = [&](std::vector<double> parameters, auto f) {
    std::vector<Change> found;
    sign_changes(points(std::move(parameters)), f, [&](double t, bool rising) {
      found.push_back({t, rising});
    });
    return found;
  };
  const auto cubic = [](double t) { return (t - 0.3) * (t - 1.7) * (t - 2.2); };
  const auto found = changes({0, 1, 2, 3}, cubic);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(found[0].at, 0.3, 1e-15);
  EXPECT_TRUE(found[0].rising);
  EXPECT_NEAR(found[1].at, 1.7, 1e-15);
  EXPECT_FALSE(found[1].rising);
  EXPECT_TRUE(found[2].rising);
  // A point exactly on the zero is passed through, two of them are a flat piece.
  EXPECT_EQ(changes({-1, 0, 1}, [](double t) { return t; }).size(), 1U);
  EXPECT_EQ(changes({-1, 0, 1}, [](double t) { return t; })[0].at, 0);
  EXPECT_TRUE(changes({-2, -0.5, 0.5, 2}, [](double t) { return std::abs(t) < 1 ? 0 : t; }).empty());
  EXPECT_TRUE(changes({-1, 0, 1}, [](double t) { return t * t; }).empty());
  // Across a place without a value nothing changes its sign.
  EXPECT_TRUE(changes({-1, 0, 1}, [](double t) { return t == 0 ? std::nan("") : t; }).empty());
  // Nor where the parameter runs back.
  EXPECT_TRUE(changes({1, -1}, [](double t) { return t; }).empty());
  EXPECT_TRUE(changes({}, [](double t) { return t; }).empty());
}

TEST(ArcProbe, AValueThatMayBeRoundingAloneIsZero) {
  EXPECT_EQ(beyond_rounding(1e-17, {-1e-16, 1e-16}), 0);
  EXPECT_EQ(beyond_rounding(2, {1, 3}), 2);
  EXPECT_EQ(beyond_rounding(2, Interval::empty()), 2);
  EXPECT_EQ(beyond_rounding(2, Interval::entire(Decoration::partial, Cause::pole)), 2);
  EXPECT_EQ(bisect(-1, 1, [](double t) { return t; }), 0);
  EXPECT_EQ(bisect(-1, 1, [](double t) { return -t; }), 0);
  EXPECT_NEAR(bisect(0, 2, [](double t) { return 2 - t * t; }), std::sqrt(2.0), 4e-16);
}

}  // namespace
}  // namespace nazori::functions
