// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/stroke_constraint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace nazori::haptics {
namespace {

constexpr double kTick_s = 0.001;
constexpr StrokeConstraint::Settings kSettings{100, 0.01, 0.0105};

StrokePath line(const Vec3& from, const Vec3& to, int pieces = 1) {
  StrokePath path;
  for (int i = 0; i <= pieces; ++i) path.points.push_back(from + (to - from) * (double(i) / pieces));
  return path;
}

void rest(StrokeConstraint& snap, const StrokeIndex& index, const Vec3& at, int ticks) {
  for (int i = 0; i < ticks; ++i) snap.update(index, kSettings, at, kTick_s);
}

TEST(StrokeIndex, FindsTheNearestPlaceAsTryingAllSegmentsDoes) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> any(-0.05, 0.05);
  std::vector<StrokePath> strokes(12);
  for (StrokePath& s : strokes)
    for (int i = 0; i < 30; ++i) s.points.emplace_back(any(random), any(random), 0.1 * any(random));
  const StrokeIndex index(strokes, 0);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p{any(random), any(random), any(random)};
    double best = std::numeric_limits<double>::infinity();
    for (const StrokePath& s : strokes)
      for (std::size_t k = 0; k + 1 < s.points.size(); ++k) {
        const Vec3 d = s.points[k + 1] - s.points[k];
        const double t = std::clamp(glm::dot(p - s.points[k], d) / glm::dot(d, d), 0.0, 1.0);
        best = std::min(best, glm::length(p - s.points[k] - t * d));
      }
    const auto hit = index.nearest(p, 1.0);
    EXPECT_NEAR(std::sqrt(hit.squared_m2), best, 1e-12);
    EXPECT_EQ(index.nearest(p, best * 0.999).segment, -1);
    EXPECT_NEAR(glm::length(hit.point - p), best, 1e-12);
  }
}

TEST(StrokeIndex, LeavesOutWhatIsNoStrokeAndKeepsTheNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<StrokePath> strokes{
      {{}}, {{{nan, 0, 0}}}, {{{0, 0, 0}, {0, nan, 0}, {0, 0, nan}, {0.01, 0, 0}}}};
  const StrokeIndex index(strokes, 0);
  const auto hit = index.nearest({0.005, 0, 0.001}, 1);
  ASSERT_GE(hit.segment, 0);
  EXPECT_EQ(index.stroke(hit.segment), 3);
  EXPECT_NEAR(index.arc_length_m(hit), 0.005, 1e-12);
  EXPECT_NEAR(index.stroke_length_m(hit.segment), 0.01, 1e-12);
  EXPECT_TRUE(StrokeIndex(strokes, 1).empty());
  EXPECT_TRUE(StrokeIndex(strokes, 9).empty());
  EXPECT_NEAR(index.at_length(3, 0.004).point.x, 0.004, 1e-12);
  EXPECT_NEAR(index.at_length(3, 1).point.x, 0.01, 1e-12);
  EXPECT_EQ(index.at_length(2, 0).segment, -1);
}

TEST(StrokeIndex, FollowingLooksPastTwoWorseSegmentsOrFourMillimetresOfThem) {
  // The line moves away from the tip in steps and comes back in one.
  const auto comes_back = [](int steps, double away_m) {
    StrokePath path{{{-0.002, 0, 0}}};
    for (int i = 0; i <= steps; ++i) path.points.emplace_back(away_m * i / steps, 0, 0);
    path.points.emplace_back(0, 0.0012, 0);
    const StrokeIndex index(std::vector{path}, 0);
    return index.follow({0, 0.001, 0}, 0).segment == steps + 1;
  };
  EXPECT_TRUE(comes_back(3, 0.0039));
  EXPECT_FALSE(comes_back(3, 0.0041));
  EXPECT_TRUE(comes_back(1, 0.02));
  EXPECT_FALSE(comes_back(2, 0.02));
}

TEST(StrokeConstraint, CatchesWithinTheSnapDistanceOnly) {
  const StrokeIndex index(std::vector{line({-0.03, 0, 0}, {0.03, 0, 0})}, 0);
  StrokeConstraint snap;
  rest(snap, index, {0, 0.0101, 0}, 10);
  EXPECT_EQ(snap.stroke(), 0);
  EXPECT_EQ(snap.force_n(), Vec3(0));
  rest(snap, index, {0, 0.0099, 0}, 1);
  EXPECT_EQ(snap.stroke(), 1);
}

TEST(StrokeConstraint, HoldsAtTheNearestPointWithTheSpringOnceBlendedIn) {
  const StrokeIndex index(std::vector{line({-0.03, 0, -0.005}, {0.03, 0, -0.005}, 7)}, 0);
  StrokeConstraint snap;
  rest(snap, index, {0.0123, 0.004, -0.003}, 200);
  EXPECT_NEAR(glm::length(snap.point_m() - Vec3(0.0123, 0, -0.005)), 0, 1e-12);
  EXPECT_NEAR(glm::length(snap.force_n() - 100.0 * Vec3(0, -0.004, -0.002)), 0, 1e-9);
  // Beyond the end of the stroke its end attracts the tip.
  rest(snap, index, {0.036, 0.001, -0.005}, 200);
  EXPECT_NEAR(glm::length(snap.point_m() - Vec3(0.03, 0, -0.005)), 0, 1e-12);
}

TEST(StrokeConstraint, TheSpringBlendsInEvenlyAndFadesOutAsLong) {
  const StrokeIndex index(std::vector{line({-0.03, 0, 0}, {0.03, 0, 0})}, 0);
  StrokeConstraint snap;
  constexpr double kAway_m = 0.002;
  constexpr double kSpring_n = 100 * kAway_m;  // weak, so that only the blend limits the change
  const int blend = static_cast<int>(std::lround(StrokeConstraint::kBlend_s / kTick_s));
  for (int i = 1; i <= blend; ++i) {
    rest(snap, index, {0, kAway_m, 0}, 1);
    EXPECT_NEAR(glm::length(snap.force_n()), kSpring_n * i / blend, 1e-9) << i;
  }
  rest(snap, index, {0, kAway_m, 0}, 1);
  EXPECT_NEAR(glm::length(snap.force_n()), kSpring_n, 1e-12);
  const StrokeIndex none;
  snap.let_go();
  for (int i = blend - 1; i >= 0; --i) {
    rest(snap, none, {0, kAway_m, 0}, 1);
    EXPECT_NEAR(glm::length(snap.force_n()), kSpring_n * i / blend, 1e-9) << i;
  }
}

TEST(StrokeConstraint, LetsGoWhenPulledBeyondTheReleaseDistance) {
  const StrokeIndex index(std::vector{line({-0.03, 0, 0}, {0.03, 0, 0})}, 0);
  StrokeConstraint snap;
  rest(snap, index, {0, 0.001, 0}, 200);
  rest(snap, index, {0, 0.0104, 0}, 1);
  EXPECT_EQ(snap.stroke(), 1);
  rest(snap, index, {0, 0.0106, 0}, 1);
  EXPECT_EQ(snap.stroke(), 0);
  rest(snap, index, {0, 0.0106, 0}, 200);
  EXPECT_EQ(snap.force_n(), Vec3(0));
}

// A hand that moves 5 um a tick changes the spring by 0.5 or 5 mN a tick; a larger change is a step.
TEST(StrokeConstraint, CatchAndReleaseAreNotFeltAsSteps) {
  const StrokeIndex index(std::vector{line({-0.03, 0, 0}, {0.03, 0, 0}, 9)}, 0);
  for (const double stiffness : {100.0, 1000.0}) {
    StrokeConstraint::Settings settings = kSettings;
    settings.stiffness_n_m = stiffness;
    StrokeConstraint snap;
    Vec3 before(0);
    double worst = 0;
    int caught = 0, released = 0;
    const double motion = 5e-6 * stiffness;
    for (int i = 0; i < 40'000; ++i) {
      const double y = 0.02 * std::cos(0.00025 * i);
      const std::int32_t was = snap.stroke();
      snap.update(index, settings, {0.001, y, 0.002}, kTick_s);
      caught += was == 0 && snap.stroke() != 0 ? 1 : 0;
      released += was != 0 && snap.stroke() == 0 ? 1 : 0;
      worst = std::max(worst, glm::length(snap.force_n() - before));
      before = snap.force_n();
    }
    EXPECT_GE(caught, 3);
    EXPECT_GE(released, 3);
    EXPECT_LT(worst, 0.05 + motion);
  }
}

TEST(StrokeConstraint, JoinedSegmentsActAsOneCurveRoundCornersAndKicks) {
  StrokePath hook = line({0, 0.03, -0.005}, {0, -0.02, -0.005}, 20);
  hook.points.emplace_back(-0.002, -0.0195, -0.004);  // a hook, back up to the left
  hook.points.emplace_back(-0.006, -0.015, -0.001);
  const StrokeIndex index(std::vector{hook}, 0);
  StrokeConstraint snap;
  rest(snap, index, {0, 0.03, -0.005}, 5);
  double arc = 0;
  for (std::size_t k = 0; k + 1 < hook.points.size(); ++k)
    for (int i = 1; i <= 100; ++i) {
      const Vec3 on = hook.points[k] + (hook.points[k + 1] - hook.points[k]) * (i / 100.0);
      snap.update(index, kSettings, on, kTick_s);
      ASSERT_EQ(snap.stroke(), 1);
      EXPECT_NEAR(glm::length(snap.point_m() - on), 0, 1e-12);
      EXPECT_GT(index.arc_length_m(snap.hit()), arc - 1e-12);
      arc = index.arc_length_m(snap.hit());
    }
  EXPECT_NEAR(arc, index.stroke_length_m(0), 1e-12);
}

// A brush stroke may overshoot a little before the hook turns back.
TEST(StrokeConstraint, LooksPastAShortOvershootAtASharpKick) {
  const StrokePath kick{{{0, 0.02, 0}, {0, 0, 0}, {0.0005, -0.0005, 0}, {-0.003, 0.003, 0}}};
  const StrokeIndex index(std::vector{kick}, 0);
  StrokeConstraint snap;
  rest(snap, index, {0, 0.002, 0}, 5);
  ASSERT_EQ(snap.segment(), 0);
  rest(snap, index, {-0.002, 0.002, 0}, 1);
  EXPECT_EQ(snap.segment(), 2);
}

TEST(StrokeConstraint, AnotherStrokeCannotTakeOverWhileOneHolds) {
  const StrokeIndex index(std::vector{line({-0.03, 0, 0}, {0.03, 0, 0}), line({0, -0.03, 0}, {0, 0.03, 0})},
                          0);
  StrokeConstraint snap;
  rest(snap, index, {-0.02, 0.001, 0}, 5);
  for (int i = -200; i < 200; ++i) {
    snap.update(index, kSettings, {1e-4 * i, 0.003, 0}, kTick_s);
    EXPECT_EQ(snap.stroke(), 1);
  }
}

TEST(StrokeConstraint, WhileOnePullFadesNoOtherBegins) {
  const StrokeIndex index(
      std::vector{line({-0.03, 0, 0}, {0.03, 0, 0}), line({-0.03, 0.03, 0}, {0.03, 0.03, 0})}, 0);
  StrokeConstraint snap;
  rest(snap, index, {0, 0.009, 0}, 200);
  ASSERT_EQ(snap.stroke(), 1);
  // Moves away from the first and onto the second.
  int waited = 0;
  for (; snap.stroke() != 2 && waited < 500; ++waited) {
    const double before = glm::length(snap.force_n());
    rest(snap, index, {0, 0.029, 0}, 1);
    if (snap.stroke() == 2) break;
    EXPECT_EQ(snap.stroke(), 0);
    EXPECT_LE(glm::length(snap.force_n()), before + 1e-12) << waited;
  }
  EXPECT_EQ(snap.stroke(), 2);
  EXPECT_GE(waited, 30) << "the pull of 0.9 N goes by at most 0.04 N a tick";
  EXPECT_LT(glm::length(snap.force_n()), 0.05);
}

TEST(StrokeConstraint, OnlyTheChosenStrokeHolds) {
  const std::vector strokes{line({-0.03, 0, 0}, {0.03, 0, 0}), line({-0.03, 0.002, 0}, {0.03, 0.002, 0})};
  const StrokeIndex index(strokes, 2);
  StrokeConstraint snap;
  rest(snap, index, {0, 0, 0}, 5);
  EXPECT_EQ(snap.stroke(), 2);
}

TEST(StrokeConstraint, WhatIsForgottenPullsNoMoreAndBlendsInAgainFromNothing) {
  const StrokeIndex index(std::vector{line({-0.03, 0, 0}, {0.03, 0, 0})}, 0);
  StrokeConstraint snap;
  const Vec3 at{0, 0.005, 0};
  rest(snap, index, at, 200);
  ASSERT_NEAR(glm::length(snap.force_n()), 0.5, 1e-9);
  snap.forget();
  EXPECT_EQ(snap.force_n(), Vec3(0));
  EXPECT_EQ(snap.stroke(), 0);
  EXPECT_EQ(snap.segment(), -1);
  StrokeConstraint fresh;
  for (int i = 0; i < 150; ++i) {
    rest(snap, index, at, 1);
    rest(fresh, index, at, 1);
    ASSERT_EQ(snap.force_n(), fresh.force_n()) << i;
  }
  snap.update(StrokeIndex(), kSettings, at, kTick_s);
  EXPECT_EQ(snap.stroke(), 0) << "the stroke that held is no longer there";
  snap.forget();
  snap.update(StrokeIndex(), kSettings, at, kTick_s);
  EXPECT_EQ(snap.force_n(), Vec3(0)) << "nothing is left to fade out";
}

TEST(StrokeConstraint, WhenTheStrokesGoItsPullFadesOut) {
  const StrokeIndex index(std::vector{line({-0.03, 0, 0}, {0.03, 0, 0})}, 0);
  StrokeConstraint snap;
  const Vec3 at{0, 0.005, 0};
  rest(snap, index, at, 200);
  snap.let_go();
  const StrokeIndex none;
  double before = glm::length(snap.force_n());
  EXPECT_NEAR(before, 0.5, 1e-9);
  for (int i = 0; i < 150; ++i) {
    snap.update(none, kSettings, at, kTick_s);
    const double now = glm::length(snap.force_n());
    EXPECT_LE(now, before);
    EXPECT_LT(before - now, 0.05);
    before = now;
  }
  EXPECT_EQ(before, 0);
}

TEST(StrokeConstraint, WhileItFadesTheSamePlaceMayCatchAgainButNoOther) {
  const StrokeIndex index(std::vector{line({-0.03, 0, 0}, {0.03, 0, 0})}, 0);
  for (const double aside : {0.0, 0.0009, 0.0011, -0.0009, -0.0011}) {
    StrokeConstraint snap;
    rest(snap, index, {0.01, 0.009, 0}, 200);
    rest(snap, index, {0.01, 0.0106, 0}, 1);
    ASSERT_EQ(snap.stroke(), 0);
    rest(snap, index, {0.01 + aside, 0.009, 0}, 1);
    EXPECT_EQ(snap.stroke(), std::abs(aside) < 1e-3 ? 1 : 0) << aside;
  }
}

TEST(StrokeConstraint, KnowsWhereItCaughtAtOnceAndNothingAfterLettingGo) {
  const StrokeIndex index(std::vector{line({-0.03, 0, 0}, {0.03, 0, 0}, 6)}, 0);
  StrokeConstraint snap;
  rest(snap, index, {0.012, 0.002, 0}, 1);
  EXPECT_EQ(snap.segment(), 4);
  EXPECT_EQ(snap.hit().segment, 4);
  EXPECT_NEAR(snap.hit().along, 0.2, 1e-9);
  EXPECT_NEAR(glm::length(snap.point_m() - Vec3(0.012, 0, 0)), 0, 1e-12);
  snap.let_go();
  EXPECT_EQ(snap.segment(), -1);
}

TEST(StrokeIndex, AStrokeOfOnePointIsAPlace) {
  const std::vector<StrokePath> strokes{{{{0.01, 0.02, -0.003}}}, line({-0.03, 0, 0}, {0.03, 0, 0})};
  const StrokeIndex index(strokes, 0);
  const auto hit = index.nearest({0.01, 0.02, 0}, 0.01);
  ASSERT_GE(hit.segment, 0);
  EXPECT_EQ(index.stroke(hit.segment), 1);
  EXPECT_EQ(hit.point, Vec3(0.01, 0.02, -0.003));
  EXPECT_NEAR(hit.squared_m2, 9e-6, 1e-15);
  EXPECT_EQ(hit.along, 0);
  EXPECT_EQ(index.direction(hit.segment), Vec3(0));
  const auto start = index.at_length(1, 0.5);
  EXPECT_EQ(start.point, Vec3(0.01, 0.02, -0.003));
  EXPECT_EQ(start.along, 0);
  EXPECT_EQ(start.squared_m2, 0);
}

TEST(StrokeIndex, ThereIsNoPlaceOnAStrokeThatIsNotThere) {
  const StrokeIndex index(std::vector{line({-0.03, 0, 0}, {0.03, 0, 0})}, 0);
  for (const int stroke : {-1, 0, 2, 1000}) EXPECT_EQ(index.at_length(stroke, 0.01).segment, -1) << stroke;
}

TEST(StrokeIndex, AStrokeThatBeginsWithWhatIsNoNumberBeginsWithTheNextPoint) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vec3 bad : {Vec3(nan, 0, 0), Vec3(0, nan, 0), Vec3(0, 0, nan)}) {
    const StrokePath path{{bad, {0.01, 0, 0}, {0.03, 0, 0}}};
    const StrokeIndex index(std::vector{path}, 0);
    EXPECT_EQ(index.at_length(1, 0).point, Vec3(0.01, 0, 0));
    EXPECT_NEAR(index.stroke_length_m(0), 0.02, 1e-15);
  }
}

}  // namespace
}  // namespace nazori::haptics
