// SPDX-License-Identifier: Apache-2.0
#include "functions/curve_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "drawing_under_test.h"

namespace nazori::ui {
namespace {

using Way = CurveTracer::Way;
using Step = CurveTracer::Step;
constexpr double kPi = 3.14159265358979323846;

using test::draw;

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

TEST(TracingByKey, ACrossingIsToldOnBothCurves) {
  auto tracer = tracer_of("y = x; y = 2 - x", {-3, 3, -3, 3});
  tracer.go_to(1, 1);
  std::set<int> curves;
  for (int i = 0; i < 2; ++i) {
    curves.insert(tracer.place()->statement);
    const auto* here = tracer.point_here();
    ASSERT_NE(here, nullptr) << "on curve " << tracer.place()->statement;
    EXPECT_EQ(here->kind, functions::PointKind::crossing);
    ASSERT_TRUE(tracer.change_branch(Way::on));
  }
  EXPECT_EQ(curves, (std::set{0, 1}));
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

TEST(TracingByKey, AnUprightLineThatOnlyAnEquationDescribesHasAnInfiniteSlopeToo) {
  // Zero at x = 0.3 only: the points of the drawn line are off by rounding.
  for (const std::string equation :
       {"sin(x - 0.3)*y^2 + x - 0.3 = 0", "(e^(x - 0.3) - 1)*(cos(x*y) + 2) + x - 0.3 = 0"}) {
    auto tracer = tracer_of(equation, {-2, 2.1, -2.7, 2});
    tracer.go_to(0.3, 0);
    for (int i = 0; i < 40; ++i) {
      ASSERT_TRUE(tracer.place());
      EXPECT_NEAR(tracer.place()->x, 0.3, 1e-9);
      const auto slope = tracer.slope();
      ASSERT_TRUE(slope);
      EXPECT_TRUE(std::isinf(*slope)) << equation << ": " << *slope << " at " << tracer.place()->y;
      ASSERT_EQ(tracer.step(i < 20 ? Way::on : Way::back), Step::done);
    }
  }
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

TEST(TracingByKey, BranchesComeByStatementThenFromLeftToRightThenFromBelow) {
  auto tracer = tracer_of("y^2 = 4; y = 1/x", {-3, 3, -3, 3});
  tracer.go_to(0, -2);
  std::vector<std::pair<int, bool>> seen;  // statement, and whether it is the upper or the right one
  for (int i = 0; i < 5; ++i) {
    const auto& at = *tracer.place();
    seen.emplace_back(at.statement, at.statement == 0 ? at.y > 0 : at.x > 0);
    ASSERT_TRUE(tracer.change_branch(Way::on));
  }
  using Seen = std::vector<std::pair<int, bool>>;
  EXPECT_EQ(seen, (Seen{{0, false}, {0, true}, {1, false}, {1, true}, {0, false}}));
  tracer.go_to(0, -2);
  ASSERT_TRUE(tracer.change_branch(Way::back));
  EXPECT_EQ(tracer.place()->statement, 1);
  EXPECT_GT(tracer.place()->x, 0) << "round, to the last";
}

TEST(TracingByKey, AnotherBranchThatDoesNotReachTheSameXIsEnteredAtItsNearestEnd) {
  auto tracer = tracer_of("y = sqrt(x); y = 2", {-4, 4, -1, 3});
  tracer.go_to(-3, 2);
  ASSERT_EQ(tracer.place()->statement, 1);
  ASSERT_TRUE(tracer.change_branch(Way::on));
  EXPECT_EQ(tracer.place()->statement, 0);
  EXPECT_NEAR(tracer.place()->x, 0, 1e-3);
}

TEST(TracingByKey, ACurveThatLeavesTheWindowUpwardsIsEnteredAtItsEdge) {
  auto tracer = tracer_of("y = 0; y = x^2 + 2", {-3, 3, -1, 4});
  tracer.go_to(2.5, 0);
  ASSERT_EQ(tracer.place()->statement, 0);
  ASSERT_TRUE(tracer.change_branch(Way::on));
  EXPECT_NEAR(tracer.place()->y, 4, 1e-3);
  EXPECT_NEAR(tracer.place()->x, std::sqrt(2.0), 1e-3);
  EXPECT_LE(tracer.place()->at.v, 1);
}

TEST(TracingByKey, PiecesBesideTheWindowAreNotWalkedTo) {
  // The middle piece of the three passes, the outer ones of 1/(x^2 - 4) lie outside.
  auto tracer = tracer_of("y = 1/(x^2 - 4)", {-1.5, 1.5, -1, 1});
  tracer.step(Way::on);
  EXPECT_FALSE(tracer.change_branch(Way::on));
  tracer.go_to_end(Way::on);
  EXPECT_EQ(tracer.step(Way::on), Step::end);
  tracer.go_to_end(Way::back);
  EXPECT_EQ(tracer.step(Way::back), Step::end);
}

TEST(TracingByKey, BeforeTheFirstStepTheFirstPointIsTheFirstAndBackwardsTheLast) {
  auto tracer = tracer_of("y = x^2 - 1", {-3, 3, -3, 3});
  const auto count = draw("y = x^2 - 1", {-3, 3, -3, 3})->points.size();
  const auto* last = tracer.next_point(Way::back);
  ASSERT_NE(last, nullptr);
  const auto* first = tracer.next_point(Way::on);
  EXPECT_EQ(last - first, static_cast<std::ptrdiff_t>(count) - 1);
  EXPECT_EQ(tracer.next_point(Way::on) - first, 1);
  EXPECT_EQ(tracer.next_point(Way::back), first);
  EXPECT_EQ(tracer.next_point(Way::back), last);
}

TEST(TracingByKey, AnAsymptoteIsGoneToInTheMiddleOfTheWindow) {
  auto tracer = tracer_of("y = 1/(x - 1) + 2", {-4, 4, -2, 8});
  std::set<functions::PointKind> seen;
  const auto* first = tracer.next_point(Way::on);
  const auto* point = first;
  do {
    if (point->kind == functions::PointKind::vertical_asymptote) {
      EXPECT_NEAR(tracer.place()->x, 1, 1e-9);
      EXPECT_NEAR(tracer.place()->y, 3, 1e-9);
      EXPECT_FALSE(tracer.place()->on) << "no curve is there";
    }
    seen.insert(point->kind);
    point = tracer.next_point(Way::on);
  } while (point != first);
  EXPECT_TRUE(seen.count(functions::PointKind::vertical_asymptote));
}

TEST(TracingByKey, APointIsToldWithinHalfAStepAndNotBeyond) {
  auto tracer = tracer_of("y = 0.001x", {-4, 4, -4, 4});
  const auto at = [&](double x) {
    tracer.go_to(x, 0.001 * x);
    return tracer.point_here();
  };
  // A step is 0.08 wide here.
  EXPECT_NE(at(0.039), nullptr);
  EXPECT_NE(at(-0.039), nullptr);
  EXPECT_EQ(at(0.041), nullptr);
  EXPECT_EQ(at(-0.041), nullptr);
}

TEST(TracingByKey, OfTwoPointsBesideEachOtherTheNearerIsTold) {
  // Zeros at 0 and at 0.03, half a step is 0.04.
  auto tracer = tracer_of("y = x^2 - 0.03x", {-4, 4, -4, 4});
  const auto zero_at = [&](double x) {
    tracer.go_to(x, x * x - 0.03 * x);
    const auto* point = tracer.point_here();
    return point != nullptr ? point->x : std::nan("");
  };
  EXPECT_NEAR(zero_at(-0.01), 0, 1e-6);
  EXPECT_NEAR(zero_at(0.04), 0.03, 1e-6);
}

TEST(TracingByKey, BackwardsFromTickToTickToo) {
  auto tracer = tracer_of("y = 0.5x", {-4.5, 4.5, -4.5, 4.5});
  tracer.go_to(1.5, 0.75);
  EXPECT_EQ(tracer.step_to_tick(Way::back), Step::done);
  EXPECT_EQ(tracer.place()->x, 1);
  EXPECT_EQ(tracer.step_to_tick(Way::on), Step::done);
  EXPECT_EQ(tracer.place()->x, 2);
  EXPECT_EQ(tracer.place()->y, 1);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(tracer.step_to_tick(Way::back), Step::done) << i;
  EXPECT_EQ(tracer.place()->x, -4);
  EXPECT_EQ(tracer.step_to_tick(Way::back), Step::end);
  EXPECT_NEAR(tracer.place()->x, -4.5, 1e-6) << "the end of the curve";
  EXPECT_EQ(tracer.step_to_tick(Way::back), Step::end);
  EXPECT_NEAR(tracer.place()->x, -4.5, 1e-6);
}

TEST(TracingByKey, TicksLieWhereTheWindowHasThemNotWhereItBegins) {
  auto tracer = tracer_of("y = 1", {10.3, 14.7, 0, 2});
  tracer.go_to(12.2, 1);
  EXPECT_EQ(tracer.step_to_tick(Way::on), Step::done);
  const double tick = functions::tick_step(10.3, 14.7);
  EXPECT_NEAR(tracer.place()->x, std::ceil(12.2 / tick) * tick, 1e-9);
}

TEST(TracingByKey, AParametricCurveIsWalkedAsItsParameterGrows) {
  // From the right to the left.
  auto tracer = tracer_of("x = -t; y = 0.5; -2 <= t <= 2", {-3, 3, -2, 2});
  tracer.go_to(0.5, 0.5);
  const double x = tracer.place()->x;
  EXPECT_EQ(tracer.step(Way::on), Step::done);
  EXPECT_LT(tracer.place()->x, x);
  tracer.go_to_end(Way::on);
  EXPECT_NEAR(tracer.place()->x, -2, 1e-6);
  tracer.go_to_end(Way::back);
  EXPECT_NEAR(tracer.place()->x, 2, 1e-6);
  EXPECT_EQ(tracer.step(Way::back), Step::end);
}

TEST(TracingByKey, TheSlopeOfEachKindOfCurveIsItsDerivative) {
  auto sideways = tracer_of("x = y^2", {-1, 4, -2, 2});
  sideways.go_to(1, 1);
  ASSERT_TRUE(sideways.slope());
  EXPECT_NEAR(*sideways.slope(), 0.5 / sideways.place()->y, 1e-9);
  auto parametric = tracer_of("x = t^2; y = t^3; 0 <= t <= 1.5", {-1, 3, -1, 4});
  parametric.go_to(1, 1);
  ASSERT_TRUE(parametric.slope());
  EXPECT_NEAR(*parametric.slope(), 1.5 * std::cbrt(parametric.place()->y), 1e-3);
  auto spiral = tracer_of("r = theta; 0 <= theta <= 2pi", {-7, 7, -7, 7});
  spiral.go_to(0, kPi / 2);
  // At a quarter turn dx is -r and dy is 1 for a small angle.
  ASSERT_TRUE(spiral.slope());
  EXPECT_NEAR(*spiral.slope(), -2 / kPi, 0.02);
  auto implicit = tracer_of("x^2 + y^2 = 4", {-3, 3, -3, 3});
  implicit.go_to(std::sqrt(2.0), std::sqrt(2.0));
  ASSERT_TRUE(implicit.slope());
  EXPECT_NEAR(*implicit.slope(), -1, 0.05);
}

TEST(TracingByKey, TheCoordinatesOfEachKindOfCurveSatisfyIt) {
  auto sideways = tracer_of("x = y^2", {-1, 4, -2, 2});
  auto parametric = tracer_of("x = t^2; y = t^3; 0 <= t <= 1.5", {-1, 3, -1, 4});
  auto spiral = tracer_of("r = theta; 0 <= theta <= 2pi", {-7, 7, -7, 7});
  for (int i = 0; i < 20; ++i) {
    for (auto* tracer : {&sideways, &parametric, &spiral}) tracer->step(Way::on);
    EXPECT_NEAR(sideways.place()->x, std::pow(sideways.place()->y, 2), 1e-12);
    EXPECT_NEAR(std::pow(parametric.place()->x, 3), std::pow(parametric.place()->y, 2), 1e-9);
    const auto& at = *spiral.place();
    const double r = std::hypot(at.x, at.y);
    EXPECT_NEAR(std::remainder(std::atan2(at.y, at.x) - r, 2 * kPi), 0, 1e-9);
  }
}

TEST(TracingByKey, AWindowThatLeavesTheHandBehindForgetsIt) {
  auto tracer = tracer_of("y = x", {-4, 4, -4, 4});
  tracer.go_to(1, 1);
  tracer.set_drawing(draw("y = x", {2, 4, 2, 4}));
  EXPECT_FALSE(tracer.place());
  tracer.go_to(3, 3);
  ASSERT_TRUE(tracer.place());
  // The nearest curve is half a window away: none that the hand was on.
  tracer.set_drawing(draw("y = x - 1.5", {2, 4, 0, 4}));
  EXPECT_FALSE(tracer.place());
  tracer.set_drawing({});
  EXPECT_FALSE(tracer.place());
  EXPECT_EQ(tracer.step(Way::on), Step::end);
  EXPECT_EQ(tracer.go_to_next_beacon(), 0);
}

TEST(TracingByKey, AThirdBeaconComesAfterTheSecondAndThenTheFirstAgain) {
  auto tracer = tracer_of("y = x", {-4, 4, -4, 4});
  tracer.drop_beacon();
  EXPECT_EQ(tracer.beacon_count(), 0U) << "the hand is nowhere";
  for (const double x : {1.0, 2.0, 3.0}) {
    tracer.go_to(x, x);
    tracer.drop_beacon();
  }
  EXPECT_EQ(tracer.beacon_count(), 3U);
  for (const int number : {1, 2, 3, 1}) {
    EXPECT_EQ(tracer.go_to_next_beacon(), number);
    EXPECT_NEAR(tracer.place()->x, number, 1e-6);
  }
}

}  // namespace
}  // namespace nazori::ui
