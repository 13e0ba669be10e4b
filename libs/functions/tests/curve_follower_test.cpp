// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/curve_follower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "drawing_under_test.h"

namespace nazori::functions {
namespace {

using Way = CurveFollower::Way;
using Step = CurveFollower::Step;
constexpr double kPi = 3.14159265358979323846;

using test::draw;

CurveFollower follower_of(const std::string& expression, const Window& window) {
  CurveFollower follower;
  follower.set_drawing(draw(expression, window));
  return follower;
}

TEST(FollowingByKey, TheFirstStepPutsTheHandOnTheCurveNearestToTheMiddle) {
  auto follower = follower_of("y = sin x", {-5, 5, -5, 5});
  EXPECT_FALSE(follower.location());
  EXPECT_EQ(follower.step(Way::on), Step::done);
  ASSERT_TRUE(follower.location());
  EXPECT_NEAR(follower.location()->x, 0, 1e-2);
}

TEST(FollowingByKey, AStepIsAHundredthOfTheWindowAlongTheCurve) {
  auto follower = follower_of("y = 0.75x", {-4, 4, -4, 4});
  follower.step(Way::on);
  const double x = follower.location()->x;
  follower.step(Way::on);
  // 3-4-5: along the line a hundredth, to the right four fifths of it.
  EXPECT_NEAR(follower.location()->x - x, 0.8 * 0.08, 1e-6);
  EXPECT_NEAR(follower.location()->y, 0.75 * follower.location()->x, 1e-12);
  follower.step(Way::back);
  EXPECT_NEAR(follower.location()->x, x, 1e-6);
}

TEST(FollowingByKey, TheEndOfACurveIsWhereItLeavesTheWindow) {
  auto follower = follower_of("y = x", {-6, 6, -4, 4});
  follower.step(Way::on);
  follower.go_to_end(Way::on);
  EXPECT_NEAR(follower.location()->y, 4, 1e-6);
  EXPECT_EQ(follower.step(Way::on), Step::end);
  EXPECT_NEAR(follower.location()->y, 4, 1e-6);
  follower.go_to_end(Way::back);
  EXPECT_NEAR(follower.location()->x, -4, 1e-6);
}

TEST(FollowingByKey, TheSlopeOfAMinimumIsNothingElseThanZero) {
  auto follower = follower_of("y = x^2 - 2", {-6, 6, -4, 4});
  const auto* point = follower.next_point(Way::on);
  while (point != nullptr && point->kind != PointKind::minimum) point = follower.next_point(Way::on);
  ASSERT_NE(point, nullptr);
  ASSERT_TRUE(follower.slope());
  EXPECT_NEAR(*follower.slope(), 0, 1e-12);
}

TEST(FollowingByKey, InAnotherWindowTheHandIsExactlyWhereItWas) {
  auto follower = follower_of("y = x^2 - 1", {-6, 6, -4, 4});
  ASSERT_NE(follower.next_point(Way::on), nullptr);
  const double x = follower.location()->x;
  const double y = follower.location()->y;
  follower.set_drawing(draw("y = x^2 - 1", {-4, 2, -1, 1}));
  ASSERT_TRUE(follower.location());
  EXPECT_EQ(follower.location()->x, x);
  EXPECT_EQ(follower.location()->y, y);
  // On another curve the hand does not continue from there: it is placed on that curve.
  follower.set_drawing(draw("y = x^2 - 0.999", {-4, 2, -1, 1}));
  ASSERT_TRUE(follower.location());
  EXPECT_NEAR(follower.location()->y, follower.location()->x * follower.location()->x - 0.999, 1e-9);
}

TEST(FollowingByKey, TheCoordinatesAreThoseOfTheExpressionNotOfTheDrawnLine) {
  auto follower = follower_of("y = sin x", {-5, 5, -5, 5});
  for (int i = 0; i < 40; ++i) {
    follower.step(Way::on);
    EXPECT_NEAR(follower.location()->y, std::sin(follower.location()->x), 1e-14);
  }
}

TEST(FollowingByKey, ControlGoesFromTickToTick) {
  auto follower = follower_of("y = x^2/4", {-4.5, 4.5, -4.5, 4.5});
  follower.step(Way::on);
  for (const double tick : {1.0, 2.0, 3.0, 4.0}) {
    EXPECT_EQ(follower.step_to_tick(Way::on), Step::done);
    EXPECT_EQ(follower.location()->x, tick);
    EXPECT_EQ(follower.location()->y, tick * tick / 4);
  }
  EXPECT_EQ(follower.step_to_tick(Way::on), Step::end);
  for (const double tick : {4.0, 3.0, 2.0, 1.0, 0.0, -1.0}) {
    EXPECT_EQ(follower.step_to_tick(Way::back), Step::done);
    EXPECT_NEAR(follower.location()->x, tick, 1e-3);
  }
}

TEST(FollowingByKey, HomeAndEndGoToTheEndsOfTheBranch) {
  auto follower = follower_of("y = sqrt(x)", {-4, 4, -1, 3});
  follower.go_to_end(Way::back);
  EXPECT_NEAR(follower.location()->x, 0, 1e-6);
  EXPECT_NEAR(follower.location()->y, 0, 1e-3);
  follower.go_to_end(Way::on);
  EXPECT_GE(follower.location()->x, 4);
}

TEST(FollowingByKey, PastAPoleTheNextBranchFollowsFromLeftToRight) {
  auto follower = follower_of("y = 1/x", {-5, 5, -5, 5});
  follower.go_to(-1, -1);
  follower.go_to_end(Way::on);
  EXPECT_LT(follower.location()->x, 0);
  EXPECT_EQ(follower.step(Way::on), Step::next_branch);
  EXPECT_GT(follower.location()->x, 0);
  EXPECT_EQ(follower.step(Way::back), Step::next_branch);
  EXPECT_LT(follower.location()->x, 0);
}

TEST(FollowingByKey, AnotherCurveIsEnteredStraightAboveOrBelow) {
  auto follower = follower_of("y = 1; y = -1", {-5, 5, -5, 5});
  follower.go_to(2, 1);
  EXPECT_TRUE(follower.change_branch(Way::on));
  EXPECT_NEAR(follower.location()->x, 2, 1e-9);
  EXPECT_NEAR(follower.location()->y, -1, 1e-9);
  EXPECT_EQ(follower.location()->statement, 1);
  EXPECT_TRUE(follower.change_branch(Way::on));
  EXPECT_EQ(follower.location()->statement, 0);
  auto alone = follower_of("y = 1", {-5, 5, -5, 5});
  EXPECT_FALSE(alone.change_branch(Way::on));
}

TEST(FollowingByKey, AnotherBranchIsEnteredInsideTheWindow) {
  auto follower = follower_of("y = tan(x); y = sin x", {-6, 6, -4, 4});
  follower.step(Way::on);
  follower.go_to_end(Way::on);
  for (int i = 0; i < 12; ++i) {
    ASSERT_TRUE(follower.change_branch(i < 6 ? Way::on : Way::back));
    EXPECT_LE(std::abs(follower.location()->y), 4 + 1e-6) << i;
    EXPECT_LE(std::abs(follower.location()->x), 6 + 1e-6) << i;
  }
}

TEST(FollowingByKey, PointsOfInterestComeInTurnAndRoundAgain) {
  auto follower = follower_of("y = x^2 - 1", {-3, 3, -3, 3});
  std::vector<PointKind> kinds;
  const auto* first = follower.next_point(Way::on);
  ASSERT_NE(first, nullptr);
  const auto* point = first;
  do {
    kinds.push_back(point->kind);
    EXPECT_NEAR(follower.location()->x, point->x, 1e-12);
    point = follower.next_point(Way::on);
  } while (point != first && kinds.size() < 20);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), PointKind::zero), 2);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), PointKind::minimum), 1);
  const auto* last = follower.next_point(Way::back);
  EXPECT_NE(last, first);
}

TEST(FollowingByKey, AStepBesideAPointOfInterestTellsIt) {
  auto follower = follower_of("y = x^2 - 1", {-3, 3, -3, 3});
  follower.go_to(1, 0);
  const auto* here = follower.point_here();
  ASSERT_NE(here, nullptr);
  EXPECT_EQ(here->kind, PointKind::zero);
  follower.step(Way::on);
  EXPECT_EQ(follower.point_here(), nullptr);
}

TEST(FollowingByKey, ACrossingIsToldOnBothCurves) {
  auto follower = follower_of("y = x; y = 2 - x", {-3, 3, -3, 3});
  follower.go_to(1, 1);
  std::set<int> curves;
  for (int i = 0; i < 2; ++i) {
    curves.insert(follower.location()->statement);
    const auto* here = follower.point_here();
    ASSERT_NE(here, nullptr) << "on curve " << follower.location()->statement;
    EXPECT_EQ(here->kind, PointKind::crossing);
    ASSERT_TRUE(follower.change_branch(Way::on));
  }
  EXPECT_EQ(curves, (std::set{0, 1}));
}

TEST(FollowingByKey, TheSlopeIsTheDerivative) {
  auto follower = follower_of("y = x^3", {-2, 2, -2, 2});
  follower.go_to(1, 1);
  const double x = follower.location()->x;
  ASSERT_TRUE(follower.slope());
  EXPECT_NEAR(*follower.slope(), 3 * x * x, 1e-9);
  auto polar = follower_of("r = 1; 0 <= theta <= 2pi", {-2, 2, -2, 2});
  polar.go_to(std::sqrt(0.5), std::sqrt(0.5));
  ASSERT_TRUE(polar.slope());
  // Across the radius.
  EXPECT_NEAR(*polar.slope(), -polar.location()->x / polar.location()->y, 1e-6);
}

TEST(FollowingByKey, AnUprightLineHasAnInfiniteSlope) {
  auto follower = follower_of("x = 1", {-2, 2, -2, 2});
  follower.go_to(1, 0.5);
  ASSERT_TRUE(follower.slope());
  EXPECT_TRUE(std::isinf(*follower.slope()));
}

TEST(FollowingByKey, AnUprightLineThatOnlyAnEquationDescribesHasAnInfiniteSlopeToo) {
  // Zero at x = 0.3 only: the points of the drawn line have rounding errors.
  for (const std::string equation :
       {"sin(x - 0.3)*y^2 + x - 0.3 = 0", "(e^(x - 0.3) - 1)*(cos(x*y) + 2) + x - 0.3 = 0"}) {
    auto follower = follower_of(equation, {-2, 2.1, -2.7, 2});
    follower.go_to(0.3, 0);
    for (int i = 0; i < 40; ++i) {
      ASSERT_TRUE(follower.location());
      EXPECT_NEAR(follower.location()->x, 0.3, 1e-9);
      const auto slope = follower.slope();
      ASSERT_TRUE(slope);
      EXPECT_TRUE(std::isinf(*slope)) << equation << ": " << *slope << " at " << follower.location()->y;
      ASSERT_EQ(follower.step(i < 20 ? Way::on : Way::back), Step::done);
    }
  }
}

TEST(FollowingByKey, BeaconsAreGoneToInTurn) {
  auto follower = follower_of("y = x", {-4, 4, -4, 4});
  EXPECT_EQ(follower.go_to_next_beacon(), 0);
  follower.go_to(1, 1);
  follower.drop_beacon();
  follower.go_to(-2, -2);
  follower.drop_beacon();
  EXPECT_EQ(follower.go_to_next_beacon(), 1);
  EXPECT_NEAR(follower.location()->x, 1, 1e-6);
  EXPECT_EQ(follower.go_to_next_beacon(), 2);
  EXPECT_NEAR(follower.location()->x, -2, 1e-6);
}

TEST(FollowingByKey, AZoomedWindowLeavesTheHandWhereItWasInThePlane) {
  CurveFollower follower;
  follower.set_drawing(draw("y = sin x", {-5, 5, -5, 5}));
  follower.go_to(kPi / 2, 1);
  const Window near{0.5, 2.5, 0, 2};
  follower.set_drawing(draw("y = sin x", near));
  ASSERT_TRUE(follower.location());
  EXPECT_NEAR(follower.location()->x, kPi / 2, 1e-3);
  EXPECT_NEAR(follower.location()->at.u, near.u(follower.location()->x), 1e-3);
}

TEST(FollowingByKey, WhereNothingIsDrawnThereIsNowhereToGo) {
  auto follower = follower_of("y = sqrt(-1 - x^2)", {-3, 3, -3, 3});
  EXPECT_EQ(follower.step(Way::on), Step::end);
  EXPECT_FALSE(follower.location());
  EXPECT_EQ(follower.next_point(Way::on), nullptr);
  EXPECT_FALSE(follower.slope());
  EXPECT_FALSE(follower.change_branch(Way::on));
}

TEST(FollowingByKey, AClosedCurveIsWalkedRound) {
  auto follower = follower_of("x^2 + y^2 = 1", {-2, 2, -2, 2});
  follower.go_to(1, 0);
  double turned = 0;
  double before = std::atan2(follower.location()->y, follower.location()->x);
  for (int i = 0; i < 300; ++i) {
    ASSERT_NE(follower.step(Way::on), Step::next_branch);
    const double now = std::atan2(follower.location()->y, follower.location()->x);
    turned += std::remainder(now - before, 2 * kPi);
    before = now;
    EXPECT_NEAR(std::hypot(follower.location()->x, follower.location()->y), 1, 0.01);
  }
  EXPECT_GT(std::abs(turned), 2 * kPi);
}

TEST(FollowingByKey, BranchesComeByStatementThenFromLeftToRightThenFromBelow) {
  auto follower = follower_of("y^2 = 4; y = 1/x", {-3, 3, -3, 3});
  follower.go_to(0, -2);
  std::vector<std::pair<int, bool>> seen;  // statement, and whether it is the upper or the right one
  for (int i = 0; i < 5; ++i) {
    const auto& at = *follower.location();
    seen.emplace_back(at.statement, at.statement == 0 ? at.y > 0 : at.x > 0);
    ASSERT_TRUE(follower.change_branch(Way::on));
  }
  using Seen = std::vector<std::pair<int, bool>>;
  EXPECT_EQ(seen, (Seen{{0, false}, {0, true}, {1, false}, {1, true}, {0, false}}));
  follower.go_to(0, -2);
  ASSERT_TRUE(follower.change_branch(Way::back));
  EXPECT_EQ(follower.location()->statement, 1);
  EXPECT_GT(follower.location()->x, 0) << "round, to the last";
}

TEST(FollowingByKey, AnotherBranchThatDoesNotReachTheSameXIsEnteredAtItsNearestEnd) {
  auto follower = follower_of("y = sqrt(x); y = 2", {-4, 4, -1, 3});
  follower.go_to(-3, 2);
  ASSERT_EQ(follower.location()->statement, 1);
  ASSERT_TRUE(follower.change_branch(Way::on));
  EXPECT_EQ(follower.location()->statement, 0);
  EXPECT_NEAR(follower.location()->x, 0, 1e-3);
}

TEST(FollowingByKey, ACurveThatLeavesTheWindowUpwardsIsEnteredAtItsEdge) {
  auto follower = follower_of("y = 0; y = x^2 + 2", {-3, 3, -1, 4});
  follower.go_to(2.5, 0);
  ASSERT_EQ(follower.location()->statement, 0);
  ASSERT_TRUE(follower.change_branch(Way::on));
  EXPECT_NEAR(follower.location()->y, 4, 1e-3);
  EXPECT_NEAR(follower.location()->x, std::sqrt(2.0), 1e-3);
  EXPECT_LE(follower.location()->at.v, 1);
}

TEST(FollowingByKey, PiecesBesideTheWindowAreNotWalkedTo) {
  // The middle piece of the three passes, the outer ones of 1/(x^2 - 4) lie outside.
  auto follower = follower_of("y = 1/(x^2 - 4)", {-1.5, 1.5, -1, 1});
  follower.step(Way::on);
  EXPECT_FALSE(follower.change_branch(Way::on));
  follower.go_to_end(Way::on);
  EXPECT_EQ(follower.step(Way::on), Step::end);
  follower.go_to_end(Way::back);
  EXPECT_EQ(follower.step(Way::back), Step::end);
}

TEST(FollowingByKey, BeforeTheFirstStepTheFirstPointIsTheFirstAndBackwardsTheLast) {
  auto follower = follower_of("y = x^2 - 1", {-3, 3, -3, 3});
  const auto count = draw("y = x^2 - 1", {-3, 3, -3, 3})->points.size();
  const auto* last = follower.next_point(Way::back);
  ASSERT_NE(last, nullptr);
  const auto* first = follower.next_point(Way::on);
  EXPECT_EQ(last - first, static_cast<std::ptrdiff_t>(count) - 1);
  EXPECT_EQ(follower.next_point(Way::on) - first, 1);
  EXPECT_EQ(follower.next_point(Way::back), first);
  EXPECT_EQ(follower.next_point(Way::back), last);
}

TEST(FollowingByKey, AnAsymptoteIsGoneToInTheMiddleOfTheWindow) {
  auto follower = follower_of("y = 1/(x - 1) + 2", {-4, 4, -2, 8});
  std::set<PointKind> seen;
  const auto* first = follower.next_point(Way::on);
  const auto* point = first;
  do {
    if (point->kind == PointKind::vertical_asymptote) {
      EXPECT_NEAR(follower.location()->x, 1, 1e-9);
      EXPECT_NEAR(follower.location()->y, 3, 1e-9);
      EXPECT_FALSE(follower.location()->on) << "no curve is there";
    }
    seen.insert(point->kind);
    point = follower.next_point(Way::on);
  } while (point != first);
  EXPECT_TRUE(seen.count(PointKind::vertical_asymptote));
}

TEST(FollowingByKey, APointIsToldWithinHalfAStepAndNotBeyond) {
  auto follower = follower_of("y = 0.001x", {-4, 4, -4, 4});
  const auto at = [&](double x) {
    follower.go_to(x, 0.001 * x);
    return follower.point_here();
  };
  // A step is 0.08 wide here.
  EXPECT_NE(at(0.039), nullptr);
  EXPECT_NE(at(-0.039), nullptr);
  EXPECT_EQ(at(0.041), nullptr);
  EXPECT_EQ(at(-0.041), nullptr);
}

TEST(FollowingByKey, OfTwoPointsBesideEachOtherTheNearerIsTold) {
  // Zeros at 0 and at 0.03, half a step is 0.04.
  auto follower = follower_of("y = x^2 - 0.03x", {-4, 4, -4, 4});
  const auto zero_at = [&](double x) {
    follower.go_to(x, x * x - 0.03 * x);
    const auto* point = follower.point_here();
    return point != nullptr ? point->x : std::nan("");
  };
  EXPECT_NEAR(zero_at(-0.01), 0, 1e-6);
  EXPECT_NEAR(zero_at(0.04), 0.03, 1e-6);
}

TEST(FollowingByKey, BackwardsFromTickToTickToo) {
  auto follower = follower_of("y = 0.5x", {-4.5, 4.5, -4.5, 4.5});
  follower.go_to(1.5, 0.75);
  EXPECT_EQ(follower.step_to_tick(Way::back), Step::done);
  EXPECT_EQ(follower.location()->x, 1);
  EXPECT_EQ(follower.step_to_tick(Way::on), Step::done);
  EXPECT_EQ(follower.location()->x, 2);
  EXPECT_EQ(follower.location()->y, 1);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(follower.step_to_tick(Way::back), Step::done) << i;
  EXPECT_EQ(follower.location()->x, -4);
  EXPECT_EQ(follower.step_to_tick(Way::back), Step::end);
  EXPECT_NEAR(follower.location()->x, -4.5, 1e-6) << "the end of the curve";
  EXPECT_EQ(follower.step_to_tick(Way::back), Step::end);
  EXPECT_NEAR(follower.location()->x, -4.5, 1e-6);
}

TEST(FollowingByKey, TicksLieWhereTheWindowHasThemNotWhereItBegins) {
  auto follower = follower_of("y = 1", {10.3, 14.7, 0, 2});
  follower.go_to(12.2, 1);
  EXPECT_EQ(follower.step_to_tick(Way::on), Step::done);
  const double tick = tick_step(10.3, 14.7);
  EXPECT_NEAR(follower.location()->x, std::ceil(12.2 / tick) * tick, 1e-9);
}

TEST(FollowingByKey, AParametricCurveIsWalkedAsItsParameterGrows) {
  // From the right to the left.
  auto follower = follower_of("x = -t; y = 0.5; -2 <= t <= 2", {-3, 3, -2, 2});
  follower.go_to(0.5, 0.5);
  const double x = follower.location()->x;
  EXPECT_EQ(follower.step(Way::on), Step::done);
  EXPECT_LT(follower.location()->x, x);
  follower.go_to_end(Way::on);
  EXPECT_NEAR(follower.location()->x, -2, 1e-6);
  follower.go_to_end(Way::back);
  EXPECT_NEAR(follower.location()->x, 2, 1e-6);
  EXPECT_EQ(follower.step(Way::back), Step::end);
}

TEST(FollowingByKey, TheSlopeOfEachKindOfCurveIsItsDerivative) {
  auto sideways = follower_of("x = y^2", {-1, 4, -2, 2});
  sideways.go_to(1, 1);
  ASSERT_TRUE(sideways.slope());
  EXPECT_NEAR(*sideways.slope(), 0.5 / sideways.location()->y, 1e-9);
  auto parametric = follower_of("x = t^2; y = t^3; 0 <= t <= 1.5", {-1, 3, -1, 4});
  parametric.go_to(1, 1);
  ASSERT_TRUE(parametric.slope());
  EXPECT_NEAR(*parametric.slope(), 1.5 * std::cbrt(parametric.location()->y), 1e-3);
  auto spiral = follower_of("r = theta; 0 <= theta <= 2pi", {-7, 7, -7, 7});
  spiral.go_to(0, kPi / 2);
  // At a quarter turn dx is -r and dy is 1 for a small angle.
  ASSERT_TRUE(spiral.slope());
  EXPECT_NEAR(*spiral.slope(), -2 / kPi, 0.02);
  auto implicit = follower_of("x^2 + y^2 = 4", {-3, 3, -3, 3});
  implicit.go_to(std::sqrt(2.0), std::sqrt(2.0));
  ASSERT_TRUE(implicit.slope());
  EXPECT_NEAR(*implicit.slope(), -1, 0.05);
}

TEST(FollowingByKey, TheCoordinatesOfEachKindOfCurveSatisfyIt) {
  auto sideways = follower_of("x = y^2", {-1, 4, -2, 2});
  auto parametric = follower_of("x = t^2; y = t^3; 0 <= t <= 1.5", {-1, 3, -1, 4});
  auto spiral = follower_of("r = theta; 0 <= theta <= 2pi", {-7, 7, -7, 7});
  for (int i = 0; i < 20; ++i) {
    for (auto* follower : {&sideways, &parametric, &spiral}) follower->step(Way::on);
    EXPECT_NEAR(sideways.location()->x, std::pow(sideways.location()->y, 2), 1e-12);
    EXPECT_NEAR(std::pow(parametric.location()->x, 3), std::pow(parametric.location()->y, 2), 1e-9);
    const auto& at = *spiral.location();
    const double r = std::hypot(at.x, at.y);
    EXPECT_NEAR(std::remainder(std::atan2(at.y, at.x) - r, 2 * kPi), 0, 1e-9);
  }
}

TEST(FollowingByKey, AWindowThatLeavesTheHandBehindForgetsIt) {
  auto follower = follower_of("y = x", {-4, 4, -4, 4});
  follower.go_to(1, 1);
  follower.set_drawing(draw("y = x", {2, 4, 2, 4}));
  EXPECT_FALSE(follower.location());
  follower.go_to(3, 3);
  ASSERT_TRUE(follower.location());
  // The nearest curve is half a window away: not one that the hand was on.
  follower.set_drawing(draw("y = x - 1.5", {2, 4, 0, 4}));
  EXPECT_FALSE(follower.location());
  follower.set_drawing({});
  EXPECT_FALSE(follower.location());
  EXPECT_EQ(follower.step(Way::on), Step::end);
  EXPECT_EQ(follower.go_to_next_beacon(), 0);
}

TEST(FollowingByKey, AThirdBeaconComesAfterTheSecondAndThenTheFirstAgain) {
  auto follower = follower_of("y = x", {-4, 4, -4, 4});
  follower.drop_beacon();
  EXPECT_EQ(follower.beacon_count(), 0U) << "the hand is nowhere";
  for (const double x : {1.0, 2.0, 3.0}) {
    follower.go_to(x, x);
    follower.drop_beacon();
  }
  EXPECT_EQ(follower.beacon_count(), 3U);
  for (const int number : {1, 2, 3, 1}) {
    EXPECT_EQ(follower.go_to_next_beacon(), number);
    EXPECT_NEAR(follower.location()->x, number, 1e-6);
  }
}

}  // namespace
}  // namespace nazori::functions
