// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/spine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "hairs.h"

namespace nazori::brush {
namespace {

constexpr double kPi = std::numbers::pi;

using test::form;
using test::hair;
using test::rubbing;

/// Root above the paper so that a straight hair is pressed `depth` beyond first touch.
SpinePose pressed(double depth, double x = 0, double tilt_rad = 0) {
  return {{x, std::cos(tilt_rad) - depth}, tilt_rad};
}

// K. Bisshopp, D. Drucker, Large deflection of cantilever beams, Quarterly of Applied Mathematics 3(3), 1945.
TEST(Spine, TheTipOfACantileverLiesWhereTheClosedFormSays) {
  struct Elastica {
    double force, across, shortened;
  };
  for (const int segments : {6, 24})
    for (const Elastica& want : {Elastica{1, 0.3017, 0.0564}, Elastica{10, 0.8106, 0.5550}}) {
      const double share = segments == 6 ? 0.02 : 0.002;
      Spine spine(form(segments, 0));
      spine.set_tip_force({want.force, 0});
      spine.place({{0, 5}, 0});
      const SpinePoint tip = spine.nodes().back();
      EXPECT_NEAR(tip.x, want.across, share * want.across) << segments;
      EXPECT_NEAR(1 - (5 - tip.z), want.shortened, share * want.shortened) << segments;
    }
}

TEST(Spine, AFreeTipBucklesAtEulersLoad) {
  for (const int segments : {6, 24}) {
    Spine spine(form(segments, 1e-5));
    spine.place(pressed(0.002));
    EXPECT_NEAR(spine.push(), kPi * kPi / 4, 0.01 * kPi * kPi / 4) << segments;
  }
}

TEST(Spine, ATipThatCannotSlideBucklesAtEulersLoad) {
  for (const int segments : {6, 24}) {
    SpineFriction stuck = rubbing(50);
    stuck.sideways = 1e4;
    Spine spine(form(segments, 1e-5), stuck);
    spine.place(pressed(0.004));
    EXPECT_NEAR(spine.push(), 20.19, segments == 6 ? 0.06 * 20.19 : 0.01 * 20.19) << segments;
  }
}

TEST(Spine, IsStraightAndFreeOfForceAboveThePaper) {
  Spine spine(form(6, 0), rubbing(0.3));
  spine.place({{0.2, 1.05}, 0.3});
  EXPECT_EQ(spine.push(), 0);
  EXPECT_EQ(spine.drag(), 0);
  EXPECT_NEAR(spine.nodes().back().x, 0.2 + std::sin(0.3), 1e-9);
  EXPECT_NEAR(spine.nodes().back().z, 1.05 - std::cos(0.3), 1e-9);
  EXPECT_DOUBLE_EQ(spine.along().back(), 1);
}

TEST(Spine, BendsToTheSideToWhichItLeans) {
  for (const double tilt : {0.25, -0.25}) {
    Spine spine(hair());
    spine.place(pressed(0.3, 0, tilt));
    EXPECT_GT(spine.nodes().back().x * tilt, 0.1);
  }
}

// Figures of another program for the same brush: 15 degrees, hair tapered to a tenth, no friction.
TEST(Spine, PushesAsPublishedForATaperedBrush) {
  constexpr double kDepths[] = {0.04, 0.1, 0.2, 0.3, 0.4, 0.6};
  constexpr double kPushes[] = {0.38, 0.56, 0.75, 0.9, 1.3, 3.2};
  const double tilt = 15 * kPi / 180;
  Spine spine(hair());
  spine.place({{0, 1.1}, tilt});
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(spine.move_to(pressed(kDepths[i], 0, tilt)));
    EXPECT_NEAR(spine.push(), kPushes[i], 0.05 * kPushes[i]) << kDepths[i];
  }
}

TEST(Spine, TheWorkOfPressingIsTheEnergyOfTheBend) {
  Spine spine(form(6, 0));
  const double tilt = 0.3;
  spine.place(pressed(0, 0, tilt));
  double work = 0, before = spine.push();
  for (int i = 1; i <= 400; ++i) {
    spine.move_to(pressed(0.001 * i, 0, tilt));
    work += 0.001 * 0.5 * (spine.push() + before);
    before = spine.push();
  }
  double energy = 0;
  for (int i = 0; i < 6; ++i) {
    const double bend = spine.bends()[static_cast<std::size_t>(i)];
    energy += 0.5 * (i == 0 ? 12 : 6) * bend * bend;
  }
  EXPECT_NEAR(work, energy, 0.003 * energy);
}

TEST(Spine, PushesTheSameOnTheWayBackWithoutFriction) {
  Spine spine(hair());
  spine.place(pressed(0.1, 0, 0.2));
  const double before = spine.push();
  spine.move_to(pressed(0.4, 0, 0.2));
  spine.move_to(pressed(0.1, 0, 0.2));
  EXPECT_NEAR(spine.push(), before, 1e-4 * before);
  spine.move_to(pressed(-0.2, 0, 0.2));
  EXPECT_EQ(spine.push(), 0);
}

TEST(Spine, NoNodeEntersThePaperAndFrictionStaysInItsConeHoweverTheRootMoves) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  SpineFriction friction = rubbing(0.4);
  friction.along_hair = 0.5;
  friction.yield_rad = 0.2;
  friction.keeps_rad = 0.1;
  friction.inner_share = 0.3;
  friction.inner_rad = 0.02;
  Spine spine(hair(), friction);
  double x = 0, depth = 0, tilt = 0;
  int failed = 0;
  for (int i = 0; i < 3000; ++i) {
    x += 0.05 * any(random);
    depth = std::clamp(depth + 0.05 * any(random), -0.1, 0.6);
    tilt = std::clamp(tilt + 0.05 * any(random), -0.6, 0.6);
    failed += spine.move_to(pressed(depth, x, tilt)) ? 0 : 1;
    double length = 0;
    for (std::size_t k = 1; k < spine.nodes().size(); ++k) {
      const SpinePoint a = spine.nodes()[k - 1], b = spine.nodes()[k];
      length += std::hypot(b.x - a.x, b.z - a.z);
      ASSERT_GE(b.z, 0);
      ASSERT_GE(spine.pushes()[k], 0);
      ASSERT_LE(std::abs(spine.drags()[k]), 0.4 * spine.pushes()[k] * 1.002 + 1e-6) << i;
      if (b.z > Spine::kTouching) {
        ASSERT_EQ(spine.pushes()[k], 0);
      }
    }
    ASSERT_NEAR(length, 1, 1e-3);
  }
  EXPECT_EQ(failed, 0);
}

TEST(Spine, SlidingFrictionReachesTheConeAndOpposesTheWay) {
  for (const double way : {1.0, -1.0}) {
    Spine spine(hair(), rubbing(0.3));
    spine.place(pressed(0.2, 0, 0.2));
    spine.move_to(pressed(0.2, 0.9 * way, 0.2));
    EXPECT_LT(spine.drag() * way, 0);
    EXPECT_NEAR(std::abs(spine.drag()), 0.3 * spine.push(), 0.01 * spine.push());
  }
}

TEST(Spine, HairSlidesMoreEasilyAlongItsLie) {
  SpineFriction friction = rubbing(0.3);
  friction.along_hair = 0.5;
  Spine trailing(hair(), friction);
  trailing.place(pressed(0.2, 0, 0.2));
  trailing.move_to(pressed(0.2, -0.9, 0.2));
  EXPECT_LT(trailing.drag(), 0.22 * trailing.push());
  EXPECT_GT(trailing.drag(), 0.14 * trailing.push());
  Spine against(hair(), friction);
  against.place(pressed(0.2, 0, 0.2));
  against.move_to(pressed(0.2, 0.02, 0.2));
  EXPECT_GT(-against.drag(), 0.29 * against.push());
}

TEST(Spine, AShortWayLeavesTheTipWhereItIs) {
  Spine spine(hair(), rubbing(0.5));
  spine.place(pressed(0.2, 0, 0.2));
  spine.move_to(pressed(0.2, -0.3, 0.2));  // the hair trails
  spine.move_to(pressed(0.2, -0.2992, 0.2));
  const double tip = spine.nodes().back().x;
  spine.move_to(pressed(0.2, -0.2988, 0.2));
  EXPECT_NEAR(spine.nodes().back().x, tip, 0.0002);
  spine.move_to(pressed(0.2, 0.4, 0.2));
  EXPECT_GT(spine.nodes().back().x, tip + 0.3);
}

TEST(Spine, KeepsAPartOfItsBendAfterItWasReleasedWetMoreThanDry) {
  double kept[2] = {};
  for (int i = 0; i < 2; ++i) {
    SpineFriction friction;
    friction.yield_rad = 0.1;
    friction.keeps_rad = i == 0 ? 0.05 : 0.15;
    Spine spine(hair(), friction);
    spine.place(pressed(0.5, 0, 0.2));
    spine.move_to(pressed(-0.5, 0, 0.2));
    for (const double bend : spine.bends()) {
      EXPECT_LE(std::abs(bend), friction.keeps_rad + 0.001);
      kept[i] += bend;
    }
  }
  EXPECT_GT(kept[0], 0.02);
  EXPECT_GT(kept[1], 1.5 * kept[0]);
}

TEST(Spine, KeepsNothingOfABendBelowItsYield) {
  SpineFriction friction;
  friction.yield_rad = 0.5;
  friction.keeps_rad = 0.2;
  Spine spine(hair(), friction);
  spine.place(pressed(0.1, 0, 0.2));
  spine.move_to(pressed(-0.5, 0, 0.2));
  for (const double bend : spine.bends()) EXPECT_NEAR(bend, 0.005 / 6, 1e-6);
}

/// Work of the spine on the hand over a closed way, relative to the work without regard to its sign.
double work_of_a_loop(const SpineFriction& friction, double turns) {
  Spine spine(hair(), friction);
  const auto at = [](double t) {
    return pressed(0.25 - 0.2 * std::cos(t), 0.15 * std::sin(2 * t + 0.4), 0.2);
  };
  spine.place(at(0));
  constexpr int kSteps = 2000;
  double work = 0, all = 0;
  SpinePose pose = spine.pose();
  double push = spine.push(), drag = spine.drag();
  for (int i = 1; i <= kSteps; ++i) {
    spine.move_to(at(2 * kPi * turns * i / kSteps));
    const double done = 0.5 * (push + spine.push()) * (spine.pose().root.z - pose.root.z) +
                        0.5 * (drag + spine.drag()) * (spine.pose().root.x - pose.root.x);
    work += done;
    all += std::abs(done);
    pose = spine.pose();
    push = spine.push();
    drag = spine.drag();
  }
  return work / all;
}

TEST(Spine, GivesNoWorkOverAClosedWayAndFrictionTakesSome) {
  EXPECT_NEAR(work_of_a_loop({}, 1), 0, 1e-3);
  const double rubbed = work_of_a_loop(rubbing(0.3), 3);
  EXPECT_LT(rubbed, -0.05);
  SpineFriction all = rubbing(0.3);
  all.inner_share = 0.5;
  all.inner_rad = 0.05;
  all.yield_rad = 0.1;
  all.keeps_rad = 0.2;
  EXPECT_LT(work_of_a_loop(all, 3), rubbed);
  SpineFriction inner;
  inner.inner_share = 0.5;
  inner.inner_rad = 0.05;
  EXPECT_LT(work_of_a_loop(inner, 1), -0.01);
}

TEST(Spine, AMirroredSpineMovesAsItsMirrorImage) {
  Spine spine(form(6, 0), rubbing(0.3)), image(form(6, 0), rubbing(0.3));
  spine.place(pressed(0.2, 0, 0.2));
  image.place(pressed(0.2, 0, -0.2));
  image.mirror();
  spine.move_to(pressed(0.3, 0.2, 0.1));
  image.move_to(pressed(0.3, 0.2, 0.1));
  for (std::size_t k = 0; k < spine.nodes().size(); ++k)
    EXPECT_NEAR(spine.nodes()[k].x, image.nodes()[k].x, 1e-6);
  EXPECT_NEAR(spine.drag(), image.drag(), 1e-5);
}

TEST(Spine, AShiftedSpineMovesAsBefore) {
  Spine spine(hair(), rubbing(0.3)), other(hair(), rubbing(0.3));
  spine.place(pressed(0.2, 0, 0.2));
  other.place(pressed(0.2, 0, 0.2));
  other.shift(2);
  EXPECT_EQ(other.pose().root.x, 2);
  for (std::size_t k = 0; k < spine.nodes().size(); ++k)
    EXPECT_DOUBLE_EQ(other.nodes()[k].x, spine.nodes()[k].x + 2) << k;
  spine.move_to(pressed(0.3, 0.2, 0.1));
  other.move_to(pressed(0.3, 2.2, 0.1));
  for (std::size_t k = 0; k < spine.nodes().size(); ++k)
    EXPECT_NEAR(spine.nodes()[k].x + 2, other.nodes()[k].x, 1e-6);
}

TEST(Spine, APoseThatIsNoNumberLeavesTheLastGoodShape) {
  Spine spine(hair(), rubbing(0.3));
  spine.place(pressed(0.2, 0, 0.2));
  const double push = spine.push();
  EXPECT_FALSE(spine.move_to({{std::numeric_limits<double>::quiet_NaN(), 0.5}, 0}));
  EXPECT_FALSE(spine.move_to({{0, std::numeric_limits<double>::infinity()}, 0}));
  EXPECT_FALSE(spine.move_to({{0, std::numeric_limits<double>::quiet_NaN()}, 0}));
  EXPECT_EQ(spine.push(), push);
  EXPECT_TRUE(spine.move_to(pressed(0.2, 0, 0.2)));
}

TEST(Spine, NeedsFewNewtonStepsForASmallMove) {
  Spine spine(hair(), rubbing(0.3));
  spine.place(pressed(0.2, 0, 0.2));
  long sum = 0;
  for (int i = 1; i <= 200; ++i) {
    spine.move_to(pressed(0.2 + 0.1 * std::sin(0.05 * i), -0.005 * i, 0.2));
    sum += spine.iterations();
  }
  EXPECT_LT(sum, 200 * 8);
}

}  // namespace
}  // namespace nazori::brush
