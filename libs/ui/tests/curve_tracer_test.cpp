// SPDX-License-Identifier: Apache-2.0
#include "functions/curve_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace nazori::ui {
namespace {

using Way = CurveTracer::Way;
using Step = CurveTracer::Step;
constexpr double kPi = 3.14159265358979323846;

SharedDrawing draw(const std::string& expression, const functions::Window& window) {
  auto drawing = std::make_shared<Drawing>();
  auto plot = functions::parse(expression);
  EXPECT_TRUE(plot) << expression;
  functions::PlateSettings plate;
  plate.size = 256;
  drawing->asked = {*plot, window, plate, functions::Language::english};
  auto picture = functions::draw(*plot, window, plate);
  EXPECT_TRUE(picture) << expression;
  drawing->picture = std::move(*picture);
  drawing->points = functions::points_of_interest(*plot, drawing->picture.tracing);
  drawing->final = true;
  return drawing;
}

CurveTracer tracer_of(const std::string& expression, const functions::Window& window) {
  CurveTracer tracer;
  tracer.set_drawing(draw(expression, window));
  return tracer;
}

TEST(TracingByKey, TheFirstStepPutsTheHandOnTheCurveNearestToTheMiddle) {
  auto tracer = tracer_of("y = sin x", {-5, 5, -5, 5});
  EXPECT_FALSE(tracer.place());
  EXPECT_EQ(tracer.step(Way::on), Step::done);
  ASSERT_TRUE(tracer.place());
  EXPECT_NEAR(tracer.place()->x, 0, 1e-2);
}

TEST(TracingByKey, AStepIsAHundredthOfTheWindowAlongTheCurve) {
  auto tracer = tracer_of("y = 0.75x", {-4, 4, -4, 4});
  tracer.step(Way::on);
  const double x = tracer.place()->x;
  tracer.step(Way::on);
  // 3-4-5: along the line a hundredth, to the right four fifths of it.
  EXPECT_NEAR(tracer.place()->x - x, 0.8 * 0.08, 1e-6);
  EXPECT_NEAR(tracer.place()->y, 0.75 * tracer.place()->x, 1e-12);
  tracer.step(Way::back);
  EXPECT_NEAR(tracer.place()->x, x, 1e-6);
}

TEST(TracingByKey, TheEndOfACurveIsWhereItLeavesTheWindow) {
  auto tracer = tracer_of("y = x", {-6, 6, -4, 4});
  tracer.step(Way::on);
  tracer.go_to_end(Way::on);
  EXPECT_NEAR(tracer.place()->y, 4, 1e-6);
  EXPECT_EQ(tracer.step(Way::on), Step::end);
  EXPECT_NEAR(tracer.place()->y, 4, 1e-6);
  tracer.go_to_end(Way::back);
  EXPECT_NEAR(tracer.place()->x, -4, 1e-6);
}

TEST(TracingByKey, TheSlopeOfAMinimumIsNothingElseThanZero) {
  auto tracer = tracer_of("y = x^2 - 2", {-6, 6, -4, 4});
  const auto* point = tracer.next_point(Way::on);
  while (point != nullptr && point->kind != functions::PointKind::minimum) point = tracer.next_point(Way::on);
  ASSERT_NE(point, nullptr);
  ASSERT_TRUE(tracer.slope());
  EXPECT_NEAR(*tracer.slope(), 0, 1e-12);
}

TEST(TracingByKey, InAnotherWindowTheHandIsExactlyWhereItWas) {
  auto tracer = tracer_of("y = x^2 - 1", {-6, 6, -4, 4});
  ASSERT_NE(tracer.next_point(Way::on), nullptr);
  const double x = tracer.place()->x;
  const double y = tracer.place()->y;
  tracer.set_drawing(draw("y = x^2 - 1", {-4, 2, -1, 1}));
  ASSERT_TRUE(tracer.place());
  EXPECT_EQ(tracer.place()->x, x);
  EXPECT_EQ(tracer.place()->y, y);
  // Another curve is another matter: the hand comes to lie on it.
  tracer.set_drawing(draw("y = x^2 - 0.999", {-4, 2, -1, 1}));
  ASSERT_TRUE(tracer.place());
  EXPECT_NEAR(tracer.place()->y, tracer.place()->x * tracer.place()->x - 0.999, 1e-9);
}

TEST(TracingByKey, TheCoordinatesAreThoseOfTheExpressionNotOfTheDrawnLine) {
  auto tracer = tracer_of("y = sin x", {-5, 5, -5, 5});
  for (int i = 0; i < 40; ++i) {
    tracer.step(Way::on);
    EXPECT_NEAR(tracer.place()->y, std::sin(tracer.place()->x), 1e-14);
  }
}

TEST(TracingByKey, ControlGoesFromTickToTick) {
  auto tracer = tracer_of("y = x^2/4", {-4.5, 4.5, -4.5, 4.5});
  tracer.step(Way::on);
  for (const double tick : {1.0, 2.0, 3.0, 4.0}) {
    EXPECT_EQ(tracer.step_to_tick(Way::on), Step::done);
    EXPECT_EQ(tracer.place()->x, tick);
    EXPECT_EQ(tracer.place()->y, tick * tick / 4);
  }
  EXPECT_EQ(tracer.step_to_tick(Way::on), Step::end);
  for (const double tick : {4.0, 3.0, 2.0, 1.0, 0.0, -1.0}) {
    EXPECT_EQ(tracer.step_to_tick(Way::back), Step::done);
    EXPECT_NEAR(tracer.place()->x, tick, 1e-3);
  }
}

TEST(TracingByKey, HomeAndEndGoToTheEndsOfTheBranch) {
  auto tracer = tracer_of("y = sqrt(x)", {-4, 4, -1, 3});
  tracer.go_to_end(Way::back);
  EXPECT_NEAR(tracer.place()->x, 0, 1e-6);
  EXPECT_NEAR(tracer.place()->y, 0, 1e-3);
  tracer.go_to_end(Way::on);
  EXPECT_GE(tracer.place()->x, 4);
}

TEST(TracingByKey, PastAPoleTheNextBranchFollowsFromLeftToRight) {
  auto tracer = tracer_of("y = 1/x", {-5, 5, -5, 5});
  tracer.go_to(-1, -1);
  tracer.go_to_end(Way::on);
  EXPECT_LT(tracer.place()->x, 0);
  EXPECT_EQ(tracer.step(Way::on), Step::next_branch);
  EXPECT_GT(tracer.place()->x, 0);
  EXPECT_EQ(tracer.step(Way::back), Step::next_branch);
  EXPECT_LT(tracer.place()->x, 0);
}

TEST(TracingByKey, AnotherCurveIsEnteredStraightAboveOrBelow) {
  auto tracer = tracer_of("y = 1; y = -1", {-5, 5, -5, 5});
  tracer.go_to(2, 1);
  EXPECT_TRUE(tracer.change_branch(Way::on));
  EXPECT_NEAR(tracer.place()->x, 2, 1e-9);
  EXPECT_NEAR(tracer.place()->y, -1, 1e-9);
  EXPECT_EQ(tracer.place()->statement, 1);
  EXPECT_TRUE(tracer.change_branch(Way::on));
  EXPECT_EQ(tracer.place()->statement, 0);
  auto alone = tracer_of("y = 1", {-5, 5, -5, 5});
  EXPECT_FALSE(alone.change_branch(Way::on));
}

TEST(TracingByKey, AnotherBranchIsEnteredInsideTheWindow) {
  auto tracer = tracer_of("y = tan(x); y = sin x", {-6, 6, -4, 4});
  tracer.step(Way::on);
  tracer.go_to_end(Way::on);
  for (int i = 0; i < 12; ++i) {
    ASSERT_TRUE(tracer.change_branch(i < 6 ? Way::on : Way::back));
    EXPECT_LE(std::abs(tracer.place()->y), 4 + 1e-6) << i;
    EXPECT_LE(std::abs(tracer.place()->x), 6 + 1e-6) << i;
  }
}

TEST(TracingByKey, PointsOfInterestComeInTurnAndRoundAgain) {
  auto tracer = tracer_of("y = x^2 - 1", {-3, 3, -3, 3});
  std::vector<functions::PointKind> kinds;
  const auto* first = tracer.next_point(Way::on);
  ASSERT_NE(first, nullptr);
  const auto* point = first;
  do {
    kinds.push_back(point->kind);
    EXPECT_NEAR(tracer.place()->x, point->x, 1e-12);
    point = tracer.next_point(Way::on);
  } while (point != first && kinds.size() < 20);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), functions::PointKind::zero), 2);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), functions::PointKind::minimum), 1);
  const auto* last = tracer.next_point(Way::back);
  EXPECT_NE(last, first);
}

TEST(TracingByKey, AStepBesideAPointOfInterestTellsIt) {
  auto tracer = tracer_of("y = x^2 - 1", {-3, 3, -3, 3});
  tracer.go_to(1, 0);
  const auto* here = tracer.point_here();
  ASSERT_NE(here, nullptr);
  EXPECT_EQ(here->kind, functions::PointKind::zero);
  tracer.step(Way::on);
  EXPECT_EQ(tracer.point_here(), nullptr);
}

TEST(TracingByKey, TheSlopeIsTheDerivative) {
  auto tracer = tracer_of("y = x^3", {-2, 2, -2, 2});
  tracer.go_to(1, 1);
  const double x = tracer.place()->x;
  ASSERT_TRUE(tracer.slope());
  EXPECT_NEAR(*tracer.slope(), 3 * x * x, 1e-9);
  auto polar = tracer_of("r = 1; 0 <= theta <= 2pi", {-2, 2, -2, 2});
  polar.go_to(std::sqrt(0.5), std::sqrt(0.5));
  ASSERT_TRUE(polar.slope());
  // Across the radius.
  EXPECT_NEAR(*polar.slope(), -polar.place()->x / polar.place()->y, 1e-6);
}

TEST(TracingByKey, AnUprightLineHasAnInfiniteSlope) {
  auto tracer = tracer_of("x = 1", {-2, 2, -2, 2});
  tracer.go_to(1, 0.5);
  ASSERT_TRUE(tracer.slope());
  EXPECT_TRUE(std::isinf(*tracer.slope()));
}

TEST(TracingByKey, BeaconsAreGoneToInTurn) {
  auto tracer = tracer_of("y = x", {-4, 4, -4, 4});
  EXPECT_EQ(tracer.go_to_next_beacon(), 0);
  tracer.go_to(1, 1);
  tracer.drop_beacon();
  tracer.go_to(-2, -2);
  tracer.drop_beacon();
  EXPECT_EQ(tracer.go_to_next_beacon(), 1);
  EXPECT_NEAR(tracer.place()->x, 1, 1e-6);
  EXPECT_EQ(tracer.go_to_next_beacon(), 2);
  EXPECT_NEAR(tracer.place()->x, -2, 1e-6);
}

TEST(TracingByKey, AZoomedWindowLeavesTheHandWhereItWasInThePlane) {
  CurveTracer tracer;
  tracer.set_drawing(draw("y = sin x", {-5, 5, -5, 5}));
  tracer.go_to(kPi / 2, 1);
  const functions::Window near{0.5, 2.5, 0, 2};
  tracer.set_drawing(draw("y = sin x", near));
  ASSERT_TRUE(tracer.place());
  EXPECT_NEAR(tracer.place()->x, kPi / 2, 1e-3);
  EXPECT_NEAR(tracer.place()->at.u, near.u(tracer.place()->x), 1e-3);
}

TEST(TracingByKey, WhereNothingIsDrawnThereIsNowhereToGo) {
  auto tracer = tracer_of("y = sqrt(-1 - x^2)", {-3, 3, -3, 3});
  EXPECT_EQ(tracer.step(Way::on), Step::end);
  EXPECT_FALSE(tracer.place());
  EXPECT_EQ(tracer.next_point(Way::on), nullptr);
  EXPECT_FALSE(tracer.slope());
  EXPECT_FALSE(tracer.change_branch(Way::on));
}

TEST(TracingByKey, AClosedCurveIsWalkedRound) {
  auto tracer = tracer_of("x^2 + y^2 = 1", {-2, 2, -2, 2});
  tracer.go_to(1, 0);
  double turned = 0;
  double before = std::atan2(tracer.place()->y, tracer.place()->x);
  for (int i = 0; i < 300; ++i) {
    ASSERT_NE(tracer.step(Way::on), Step::next_branch);
    const double now = std::atan2(tracer.place()->y, tracer.place()->x);
    turned += std::remainder(now - before, 2 * kPi);
    before = now;
    EXPECT_NEAR(std::hypot(tracer.place()->x, tracer.place()->y), 1, 0.01);
  }
  EXPECT_GT(std::abs(turned), 2 * kPi);
}

}  // namespace
}  // namespace nazori::ui
