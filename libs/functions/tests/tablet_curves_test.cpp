// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/tablet_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "drawn_lines.h"

namespace nazori::functions {
namespace {

using test::line;
using test::tracing_of;

/// A square from (0.2, 0.2) round to (0.2, 0.6), whose fourth side closes it.
Branch square(int statement = 0) {
  return line({{0.2, 0.2, 0}, {0.6, 0.2, 0}, {0.6, 0.6, 0}, {0.2, 0.6, 0}}, statement, true);
}

constexpr geometry::TabletShape kShape{0.101, 0.01};

TEST(TabletPlace, TheMiddlesOfTheOutermostCellsAreTheBorderOfTheTablet) {
  // 101 samples a side: a cell is a millimetre on the tablet.
  const auto first = tablet_place({0.5 / 101, 0.5 / 101}, 101, {0.1, 0.01});
  EXPECT_NEAR(first.x, -0.05, 1e-15);
  EXPECT_NEAR(first.y, -0.05, 1e-15);
  const auto last = tablet_place({1 - 0.5 / 101, 1 - 0.5 / 101}, 101, {0.1, 0.01});
  EXPECT_NEAR(last.x, 0.05, 1e-15);
  EXPECT_NEAR(last.y, 0.05, 1e-15);
  const auto some = tablet_place({10.5 / 101, 30.5 / 101}, 101, {0.1, 0.01});
  EXPECT_NEAR(some.x, -0.04, 1e-15);
  EXPECT_NEAR(some.y, -0.02, 1e-15);
  const PlatePoint back = plate_place(some, 101, {0.1, 0.01});
  EXPECT_NEAR(back.u, 10.5 / 101, 1e-15);
  EXPECT_NEAR(back.v, 30.5 / 101, 1e-15);
}

std::vector<TabletCurve> curves_of(std::vector<Branch> branches, double tolerance_m = 20e-6) {
  return tablet_curves(tracing_of(std::move(branches)), 101, kShape, tolerance_m);
}

TEST(TabletCurves, AreCutAtTheFrame) {
  const auto cut = curves_of({line({{-0.5, 0.5, 0}, {1.5, 0.5, 0}}, 2)});
  ASSERT_EQ(cut.size(), 1U);
  EXPECT_EQ(cut[0].statement, 2);
  EXPECT_FALSE(cut[0].closed);
  ASSERT_EQ(cut[0].points.size(), 2U);
  const auto left = tablet_place({0, 0.5}, 101, kShape);
  EXPECT_NEAR(cut[0].points[0].x, left.x, 1e-15);
  EXPECT_NEAR(cut[0].points[1].x, tablet_place({1, 0.5}, 101, kShape).x, 1e-15);
  EXPECT_NEAR(cut[0].points[0].y, left.y, 1e-15);
  // Out at the top and in again: two pieces.
  EXPECT_EQ(curves_of({line({{0.1, 0.5, 0}, {0.3, 1.5, 0}, {0.6, 1.5, 0}, {0.9, 0.5, 0}})}).size(), 2U);
  EXPECT_EQ(curves_of({line({{0.1, 0.5, 0}, {0.3, 1.5, 0}, {0.6, 0.5, 0}})}).size(), 2U);
  EXPECT_TRUE(curves_of({line({{1.1, 0, 0}, {1.1, 1, 0}})}).empty());
  EXPECT_TRUE(curves_of({line({{0, -0.1, 0}, {1, -0.1, 0}})}).empty());
  EXPECT_TRUE(curves_of({line({{-0.1, 0.9, 0}, {0.1, 1.1, 0}, {0.3, 1.3, 0}})}).size() < 2);
  // Along the frame itself it is inside.
  EXPECT_EQ(curves_of({line({{0, 0, 0}, {0, 1, 0}})}).size(), 1U);
  EXPECT_EQ(curves_of({line({{0, 1, 0}, {1, 1, 0}})}).size(), 1U);
}

TEST(TabletCurves, ARingStaysClosedUnlessTheFrameCutsIt) {
  const auto ring = curves_of({square(1)});
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_TRUE(ring[0].closed);
  ASSERT_EQ(ring[0].points.size(), 5U);
  EXPECT_NEAR(ring[0].points.front().x, ring[0].points.back().x, 1e-15);
  EXPECT_NEAR(ring[0].points.front().y, ring[0].points.back().y, 1e-15);
  const auto cut = curves_of({line({{0.2, 0.2, 0}, {1.6, 0.2, 0}, {1.6, 0.6, 0}, {0.2, 0.6, 0}}, 0, true)});
  ASSERT_EQ(cut.size(), 2U);
  for (const TabletCurve& c : cut) EXPECT_FALSE(c.closed);
}

TEST(TabletCurves, LeaveOutPointsWithinTheToleranceAndNoOthers) {
  // A point off the chord by 1/1000 of the side: 101 um on a tablet of 102 mm cells and all.
  const Branch bent = line({{0.2, 0.5, 0}, {0.5, 0.501, 0}, {0.8, 0.5, 0}});
  const double off = 0.001 * 0.101 * 101 / 100;
  EXPECT_EQ(curves_of({bent}, off * 1.02)[0].points.size(), 2U);
  EXPECT_EQ(curves_of({bent}, off * 0.98)[0].points.size(), 3U);
  // Back over itself the turn is kept.
  EXPECT_EQ(curves_of({line({{0.2, 0.5, 0}, {0.8, 0.5, 0}, {0.4, 0.5, 0}})})[0].points.size(), 3U);
  // Every point of a circle stays near the simplified one.
  std::vector<CurvePoint> circle;
  for (int i = 0; i < 1000; ++i) {
    const double a = 2 * std::numbers::pi * i / 1000;
    circle.push_back({0.5 + 0.3 * std::cos(a), 0.5 + 0.3 * std::sin(a), 0});
  }
  const auto round = curves_of({line(circle, 0, true)});
  ASSERT_EQ(round.size(), 1U);
  const double radius = 0.3 * 0.101 * 101 / 100;
  // The sagitta of a chord is at most the tolerance: at least 2 pi / (2 acos(1 - tolerance/radius)) chords.
  const double fewest = std::numbers::pi / std::acos(1 - 20e-6 / radius);
  EXPECT_GE(static_cast<double>(round[0].points.size()), fewest);
  EXPECT_LE(static_cast<double>(round[0].points.size()), 2.2 * fewest);
  for (std::size_t i = 0; i + 1 < round[0].points.size(); ++i) {
    const auto& a = round[0].points[i];
    const auto& b = round[0].points[i + 1];
    EXPECT_GE(std::hypot((a.x + b.x) / 2, (a.y + b.y) / 2), radius - 21e-6);
  }
}

TEST(TabletCurves, SinglePointsAreTwoAMicrometreApart) {
  Tracing tracing = tracing_of({});
  for (const PlatePoint at : {PlatePoint{0.25, 0.75}, PlatePoint{0, 1}, PlatePoint{-0.001, 0.5},
                              PlatePoint{1.001, 0.5}, PlatePoint{0.5, -0.001}, PlatePoint{0.5, 1.001}})
    tracing.dots.push_back({3, at});
  const auto curves = tablet_curves(tracing, 101, kShape);
  ASSERT_EQ(curves.size(), 2U) << "those of the window";
  const auto at = tablet_place({0.25, 0.75}, 101, kShape);
  ASSERT_EQ(curves[0].points.size(), 2U);
  EXPECT_EQ(curves[0].statement, 3);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_EQ(curves[0].points[0].x, at.x);
  EXPECT_EQ(curves[0].points[0].y, at.y);
  EXPECT_NEAR(curves[0].points[1].x - at.x, 1e-6, 1e-15);
  EXPECT_EQ(curves[0].points[1].y, at.y);
}

TEST(NearestPlace, IsOnTheNearestPieceOfTheCurveAskedFor) {
  const Tracing t = tracing_of(
      {line({{0.1, 0.1, 0}, {0.9, 0.1, 0}}, 0), square(1), line({{0.5, 0.9, 0}, {0.5, 0.9, 0}}, 2)});
  const auto below = nearest_place(t, {0.7, 0.12});
  ASSERT_TRUE(below);
  EXPECT_EQ(below->branch, 0U);
  EXPECT_NEAR(below->at.u, 0.7, 1e-15);
  EXPECT_NEAR(below->at.v, 0.1, 1e-15);
  EXPECT_NEAR(below->distance, 0.02, 1e-15);
  const auto ring = nearest_place(t, {0.7, 0.12}, 1);
  ASSERT_TRUE(ring);
  EXPECT_EQ(ring->branch, 1U);
  EXPECT_NEAR(ring->at.u, 0.6, 1e-15);
  EXPECT_NEAR(ring->at.v, 0.2, 1e-15);
  EXPECT_NEAR(ring->distance, std::hypot(0.1, 0.08), 1e-15);
  // The side that closes the ring counts.
  const auto closing = nearest_place(t, {0.21, 0.4});
  ASSERT_TRUE(closing);
  EXPECT_EQ(closing->branch, 1U);
  EXPECT_EQ(closing->piece, 3U);
  EXPECT_NEAR(closing->at.u, 0.2, 1e-15);
  EXPECT_NEAR(closing->at.v, 0.4, 1e-15);
  const auto beyond = nearest_place(t, {1.2, 0.1}, 0);
  EXPECT_NEAR(beyond->at.u, 0.9, 1e-15);
  const auto before = nearest_place(t, {0, 0.1}, 0);
  EXPECT_NEAR(before->at.u, 0.1, 1e-15);
  EXPECT_NEAR(nearest_place(t, {0.5, 1}, 2)->distance, 0.1, 1e-15);
  EXPECT_FALSE(nearest_place(t, {0.5, 0.5}, 3));
  EXPECT_EQ(nearest_place(t, {0.5, 0.1}, 0)->branch, 0U) << "the first statement alone";
  // Of two that are equally near the first.
  const Tracing equal = tracing_of({line({{0, 0.4, 0}, {1, 0.4, 0}}), line({{0, 0.6, 0}, {1, 0.6, 0}}, 1)});
  EXPECT_EQ(nearest_place(equal, {0.5, 0.5})->branch, 0U);
}

TEST(StepAlong, GoesRoundCornersAndStopsAtTheEnds) {
  const Tracing t = tracing_of({line({{0.1, 0.1, 0}, {0.5, 0.1, 0}, {0.5, 0.9, 0}})});
  const CurvePlace start{0, 0, {0.3, 0.1}, 0.01};
  const auto expect = [&](double step, double u, double v, std::size_t piece) {
    const CurvePlace p = step_along(t, start, step);
    EXPECT_NEAR(p.at.u, u, 1e-12) << step;
    EXPECT_NEAR(p.at.v, v, 1e-12) << step;
    EXPECT_EQ(p.piece, piece) << step;
    EXPECT_EQ(p.branch, 0U);
    EXPECT_EQ(p.distance, 0);
  };
  expect(0.1, 0.4, 0.1, 0);
  expect(-0.1, 0.2, 0.1, 0);
  expect(0.5, 0.5, 0.4, 1);
  expect(1.0, 0.5, 0.9, 1);
  expect(5, 0.5, 0.9, 1);
  expect(-5, 0.1, 0.1, 0);
  expect(0, 0.3, 0.1, 0);
  const CurvePlace late = step_along(t, {0, 1, {0.5, 0.2}, 0}, -0.3);
  EXPECT_NEAR(late.at.u, 0.3, 1e-12);
  EXPECT_EQ(late.piece, 0U);
}

TEST(StepAlong, GoesOnRoundARingInBothDirections) {
  const Tracing t = tracing_of({square()});
  // Circumference 1.6; from the middle of the first side.
  const CurvePlace start{0, 0, {0.4, 0.2}, 0};
  const auto expect = [&](double step, double u, double v, std::size_t piece) {
    const CurvePlace p = step_along(t, start, step);
    EXPECT_NEAR(p.at.u, u, 1e-12) << step;
    EXPECT_NEAR(p.at.v, v, 1e-12) << step;
    EXPECT_EQ(p.piece, piece) << step;
  };
  expect(0.4, 0.6, 0.4, 1);
  expect(1.2, 0.2, 0.4, 3);
  expect(1.6, 0.4, 0.2, 0);
  expect(2.0, 0.6, 0.4, 1);
  expect(-0.4, 0.2, 0.4, 3);
  expect(-1.2, 0.6, 0.4, 1);
  expect(-1.6, 0.4, 0.2, 0);
  expect(3.1, 0.3, 0.2, 0);
}

TEST(StepAlong, PassesPiecesWithoutLength) {
  const Tracing t = tracing_of({line({{0.1, 0.1, 0}, {0.3, 0.1, 0}, {0.3, 0.1, 0}, {0.5, 0.1, 0}})});
  EXPECT_NEAR(step_along(t, {0, 0, {0.2, 0.1}, 0}, 0.2).at.u, 0.4, 1e-12);
  EXPECT_NEAR(step_along(t, {0, 2, {0.4, 0.1}, 0}, -0.2).at.u, 0.2, 1e-12);
}

TEST(CurveFeel, TheFourStatementsDifferAndRepeat) {
  // As docs/functions.md has them.
  const double friction[] = {0.05, 0.45, 0.25, 0.65};
  for (int k = 0; k < 8; ++k) EXPECT_EQ(feel_of(k).friction, friction[k % 4]) << k;
  EXPECT_EQ(feel_of(-1).friction, 0.05);
  EXPECT_EQ(feel_of(0).texture_period, 0);
  for (int k = 1; k < 4; ++k) {
    EXPECT_GT(feel_of(k).texture_period, 0);
    EXPECT_EQ(feel_of(k + 4).texture_period, feel_of(k).texture_period);
  }
}

}  // namespace
}  // namespace nazori::functions
