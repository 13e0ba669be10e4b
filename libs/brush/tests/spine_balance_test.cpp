// SPDX-License-Identifier: Apache-2.0
// The balance of spines of many segments: each joint holds what pulls at the nodes beyond it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "nazori/brush/spine.h"

namespace nazori::brush {
namespace {

SpineForm form(int segments) {
  SpineForm made;
  made.segments = segments;
  made.tip_segment = 0.6;
  made.taper = 0.3;
  made.taper_power = 3;
  made.thickness = 0.04;
  made.own_bend_rad = 0.03;
  return made;
}

/// Stiffness of each joint: of the radius there, over the half segments on both sides that bend at it.
std::vector<double> stiffnesses(const Spine& spine, const SpineForm& form) {
  std::vector<double> made;
  const auto along = spine.along();
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const double bends = ((i > 0 ? along[i] - along[i - 1] : 0.0) + along[i + 1] - along[i]) / 2;
    made.push_back(std::pow(1 + (form.taper - 1) * along[i], form.taper_power) / bends);
  }
  return made;
}

/// The moment at a joint of the pushes, the drags and the force at the tip.
double pulled(const Spine& spine, std::size_t joint, SpinePoint tip_force) {
  const auto nodes = spine.nodes();
  double sum = 0;
  for (std::size_t k = joint + 1; k < nodes.size(); ++k) {
    const bool tip = k + 1 == nodes.size();
    const double x = spine.drags()[k] + (tip ? tip_force.x : 0);
    const double z = spine.pushes()[k] + (tip ? tip_force.z : 0);
    sum += z * (nodes[k].x - nodes[joint].x) + x * (nodes[joint].z - nodes[k].z);
  }
  return sum;
}

/// How much the moment of a joint differs at most from what pulls at it.
double imbalance(const Spine& spine, const SpineForm& form, SpinePoint tip_force) {
  const auto stiffness = stiffnesses(spine, form);
  double most = 0;
  for (std::size_t i = 0; i < spine.bends().size(); ++i) {
    const double moment = stiffness[i] * (spine.bends()[i] - form.own_bend_rad / form.segments);
    most = std::max(most, std::abs(moment - pulled(spine, i, tip_force)));
  }
  return most;
}

/// A way over the paper that presses, drags to both sides, leans and lifts.
std::vector<SpinePose> way() {
  std::vector<SpinePose> poses;
  for (int i = 0; i <= 60; ++i) {
    const double t = 0.1 * i;
    poses.push_back({{0.3 * std::sin(1.3 * t), 0.75 + 0.3 * std::cos(t)}, 0.4 * std::sin(0.7 * t) + 0.1});
  }
  return poses;
}

TEST(SpineBalance, EachJointHoldsThePushesAndTheForceBeyondIt) {
  for (const int segments : {2, 3, 6, 12})
    for (const SpinePoint force : {SpinePoint{}, {0.4, 0}, {-0.3, -0.2}}) {
      const SpineForm hair = form(segments);
      Spine spine(hair);
      spine.set_tip_force(force);
      spine.place({{0, 1.2}, 0.1});
      std::ptrdiff_t touching = 0;
      double most = 0;
      for (const SpinePose& pose : way()) {
        ASSERT_TRUE(spine.move_to(pose));
        most = std::max(most, imbalance(spine, hair, force));
        touching = std::max(touching, std::count_if(spine.pushes().begin(), spine.pushes().end(),
                                                    [](double push) { return push > 0; }));
      }
      EXPECT_LT(most, 1e-3) << segments << " " << force.x;
      EXPECT_GE(touching, segments > 3 ? 2 : 1) << segments;
    }
}

TEST(SpineBalance, EachJointHoldsTheFrictionBeyondItToo) {
  for (const int segments : {2, 3, 6, 12}) {
    const SpineForm hair = form(segments);
    SpineFriction friction;
    friction.paper = 0.3;
    Spine spine(hair, friction);
    spine.place({{0, 1.2}, 0.1});
    int balanced = 0;
    double drag = 0;
    for (const SpinePose& pose : way()) {
      ASSERT_TRUE(spine.move_to(pose));
      // Near a snap the friction is not found exactly.
      balanced += imbalance(spine, hair, {}) < 0.005 ? 1 : 0;
      drag = std::max(drag, std::abs(spine.drag()));
    }
    EXPECT_GT(drag, 0.1);
    EXPECT_GE(balanced, 55) << "of 61, " << segments << " segments";
  }
}

TEST(SpineBalance, ANodePushesOnlyOnThePaperAndDragsNoMoreThanItsFriction) {
  const SpineForm hair = form(8);
  SpineFriction friction;
  friction.paper = 0.3;
  Spine spine(hair, friction);
  spine.place({{0, 1.2}, 0.1});
  for (const SpinePose& pose : way()) {
    ASSERT_TRUE(spine.move_to(pose));
    double push = 0, drag = 0;
    for (std::size_t k = 0; k < spine.nodes().size(); ++k) {
      push += spine.pushes()[k];
      drag += spine.drags()[k];
      EXPECT_LE(std::abs(spine.drags()[k]), 0.3 * spine.pushes()[k] * 1.002 + 1e-6);
      if (spine.pushes()[k] > 0) {
        EXPECT_NEAR(spine.nodes()[k].z, spine.clearances()[k], 2e-5) << k;
      }
    }
    EXPECT_DOUBLE_EQ(spine.push(), push);
    EXPECT_DOUBLE_EQ(spine.drag(), drag);
  }
}

TEST(SpineBalance, NodesLieAlongTheHairFromItsRoot) {
  Spine spine(form(5));
  spine.place({{0.2, 0.7}, -0.3});
  ASSERT_EQ(spine.nodes().size(), 6U);
  ASSERT_EQ(spine.pushes().size(), 6U);
  ASSERT_EQ(spine.drags().size(), 6U);
  ASSERT_EQ(spine.bends().size(), 5U);
  EXPECT_EQ(spine.nodes()[0].x, 0.2);
  EXPECT_EQ(spine.nodes()[0].z, 0.7);
  double angle = -0.3;
  for (std::size_t i = 0; i < 5; ++i) {
    angle += spine.bends()[i];
    const double length = spine.along()[i + 1] - spine.along()[i];
    EXPECT_NEAR(spine.nodes()[i + 1].x - spine.nodes()[i].x, length * std::sin(angle), 1e-9) << i;
    EXPECT_NEAR(spine.nodes()[i].z - spine.nodes()[i + 1].z, length * std::cos(angle), 2e-5) << i;
  }
}

TEST(SpineForm, OfTwoSegmentsTheSecondIsAsMuchShorterAsTheTipSegmentSays) {
  SpineForm two;
  two.segments = 2;
  two.tip_segment = 0.25;
  EXPECT_NEAR(Spine(two).along()[1], 0.8, 1e-15);
  two.segments = 1;
  EXPECT_EQ(Spine(two).along()[1], 1);
}

/// Steps of Newton's method that a small move of the way needs on average.
double mean_iterations(const SpineFriction& friction, SpinePoint force) {
  Spine spine(form(8), friction);
  spine.set_tip_force(force);
  spine.place({{0, 1.2}, 0.1});
  int all = 0, moves = 0;
  for (const SpinePose& pose : way()) {
    const SpinePose from = spine.pose();
    for (int i = 1; i <= 10; ++i) {
      const double t = 0.1 * i;
      EXPECT_TRUE(spine.move_to(
          {{from.root.x + t * (pose.root.x - from.root.x), from.root.z + t * (pose.root.z - from.root.z)},
           from.tilt_rad + t * (pose.tilt_rad - from.tilt_rad)}));
      all += spine.iterations();
      ++moves;
    }
  }
  return static_cast<double>(all) / moves;
}

TEST(SpineBalance, IsFoundInAFewStepsOfNewtonsMethodWhichDoublesTheDigitsInEach) {
  SpineFriction friction;
  friction.paper = 0.3;
  SpineFriction inside;
  inside.inner_share = 0.3;
  inside.inner_rad = 0.02;
  inside.yield_rad = 0.1;
  inside.keeps_rad = 0.2;
  EXPECT_LT(mean_iterations({}, {}), 3.3);
  EXPECT_LT(mean_iterations({}, {0.5, 0.2}), 2.6);
  EXPECT_LT(mean_iterations(friction, {}), 6);
  EXPECT_LT(mean_iterations(inside, {}), 2.9);
}

}  // namespace
}  // namespace nazori::brush
