// SPDX-License-Identifier: Apache-2.0
// The steps in which a spine moves and settles, and what it does where it does not settle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "hairs.h"

namespace nazori::brush {
namespace {

using test::form;
using test::hair;
using test::rubbing;

/// A hair that thins out, on paper.
Spine on_paper() {
  Spine spine(hair(), rubbing(0.3));
  spine.place({{0, 0.8}, 0.2});
  return spine;
}

SpinePose between(const SpinePose& from, const SpinePose& to, double t) {
  return {{from.root.x + t * (to.root.x - from.root.x), from.root.z + t * (to.root.z - from.root.z)},
          from.tilt_rad + t * (to.tilt_rad - from.tilt_rad)};
}

/// Moves two spines to a pose, one at once and one by as many equal moves; expects the same way of both.
void expect_steps(const SpinePose& to, int steps) {
  Spine once = on_paper(), often = on_paper();
  const SpinePose from = once.pose();
  EXPECT_TRUE(once.move_to(to));
  int iterations = 0;
  for (int i = 1; i <= steps; ++i) {
    EXPECT_TRUE(often.move_to(i < steps ? between(from, to, static_cast<double>(i) / steps) : to));
    iterations += often.iterations();
  }
  EXPECT_EQ(once.iterations(), iterations) << steps;
  EXPECT_EQ(once.pose().root.x, to.root.x);
  EXPECT_EQ(once.pose().root.z, to.root.z);
  EXPECT_EQ(once.pose().tilt_rad, to.tilt_rad);
  for (std::size_t k = 0; k < once.nodes().size(); ++k) {
    EXPECT_EQ(once.nodes()[k].x, often.nodes()[k].x) << steps << " " << k;
    EXPECT_EQ(once.pushes()[k], often.pushes()[k]) << steps << " " << k;
    EXPECT_EQ(once.drags()[k], often.drags()[k]) << steps << " " << k;
  }
}

TEST(SpineSteps, AMoveIsMadeInStepsOfAFiftiethOfTheHairAndATwentiethOfARadian) {
  expect_steps({{0.39, 0.8}, 0.2}, 20);
  expect_steps({{-0.39, 0.8}, 0.2}, 20);
  expect_steps({{0, 0.51}, 0.2}, 15);
  expect_steps({{0, 1.09}, 0.2}, 15);
  expect_steps({{0, 0.8}, -0.28}, 10);
  expect_steps({{0, 0.8}, 0.68}, 10);
  expect_steps({{0.07, 0.75}, 0.22}, 4);
  expect_steps({{0.01, 0.8}, 0.21}, 1);
}

TEST(SpineSteps, AtRestNothingIsComputed) {
  Spine spine(form(6, 0.005));
  spine.place({{0, 3}, 0.2});
  EXPECT_TRUE(spine.move_to({{0.5, 2}, 0.4}));
  EXPECT_EQ(spine.iterations(), 0);
  Spine other = on_paper();
  EXPECT_TRUE(other.move_to({{0.3, 0.8}, 0.2}));
  EXPECT_GT(other.iterations(), 0);
  EXPECT_TRUE(other.move_to(other.pose()));
  EXPECT_LE(other.iterations(), 2);
}

TEST(SpineSteps, AJointTurnsByTwoFifthsAtMostAtOnce) {
  // In one step far above the paper the joint springs back to its own bend. That is one step of Newton's
  // method for a spring, but for that limit.
  for (const auto& [bent, turns] : {std::pair{0.35, 1}, {0.45, 2}, {0.75, 2}, {0.85, 3}, {1.1, 3}}) {
    Spine spine(form(1, 0.01));
    spine.move_to({{0, std::cos(bent)}, 0});
    ASSERT_NEAR(spine.bends()[0], bent, 1e-4);
    EXPECT_TRUE(spine.move_to({{0, 1000}, 0}));
    EXPECT_EQ(spine.iterations(), turns) << bent;
    EXPECT_NEAR(spine.bends()[0], 0.01, 1e-12);
  }
}

TEST(SpineSteps, AGradientOfLessThanAMillionthCountsAsNone) {
  for (const auto& [force, iterations] : {std::pair{0.9e-6, 0}, {1.2e-6, 1}}) {
    Spine spine(form(1, 0));
    spine.place({{0, 3}, 0});
    spine.set_tip_force({force, 0});
    EXPECT_TRUE(spine.move_to({{0, 3}, 0}));
    EXPECT_EQ(spine.iterations(), iterations);
    EXPECT_NEAR(spine.bends()[0], iterations * force / 2, 1e-12);
  }
}

/// An exactly straight and upright hair knows no side to bend to. It enters the paper as its root is lowered.
Spine upright() {
  Spine spine(form(6, 0));
  spine.place({{0, 1.0001}, 0});
  return spine;
}

TEST(SpineSteps, WhatEntersThePaperByLessThanAThousandthTouches) {
  // The push grows by the stiffness of the paper times the depth, up to twelve times.
  for (const double depth : {0.0005, 0.0009}) {
    Spine spine = upright();
    EXPECT_TRUE(spine.move_to({{0, 1 - depth}, 0})) << depth;
    EXPECT_NEAR(spine.push(), 12 * 2000 * depth, 1e-6);
    EXPECT_EQ(spine.nodes().back().z, 0) << "it lies on the paper";
    EXPECT_EQ(spine.pose().root.z, 1 - depth);
  }
  // By less than a hundred-thousandth is as good as nothing.
  for (const auto& [depth, times] : {std::pair{0.8e-5, 1}, {1.2e-5, 12}}) {
    Spine spine = upright();
    EXPECT_TRUE(spine.move_to({{0, 1 - depth}, 0}));
    EXPECT_NEAR(spine.push(), times * 2000 * depth, 1e-6) << depth;
  }
}

TEST(SpineSteps, AStepThatDoesNotSettleKeepsTheLastGoodShape) {
  Spine spine = upright();
  EXPECT_FALSE(spine.move_to({{0, 1 - 0.0012}, 0}));
  EXPECT_EQ(spine.push(), 0);
  EXPECT_EQ(spine.pose().root.z, 1.0001);
  EXPECT_NEAR(spine.nodes().back().z, 0.0001, 1e-12);
  // The root comes as far as its steps settle.
  ASSERT_TRUE(spine.move_to({{0, 1.05}, 0}));
  EXPECT_FALSE(spine.move_to({{0, 0.971}, 0}));
  EXPECT_NEAR(spine.pose().root.z, 1.0105, 1e-12) << "two of four steps";
  EXPECT_EQ(spine.push(), 0);
  EXPECT_TRUE(spine.move_to({{0.1, 1.05}, 0}));
  EXPECT_EQ(spine.pose().root.x, 0.1);
}

TEST(SpineSteps, AMoveIsNotGoodWhereOnlyItsLastStepSettles) {
  // From one lean to the other, just above the paper; half way the hair stands upright and enters it.
  Spine spine(form(6, 0));
  spine.place({{0, 0.99885}, -0.049});
  ASSERT_EQ(spine.push(), 0);
  EXPECT_FALSE(spine.move_to({{0, 0.99885}, 0.049}));
  EXPECT_EQ(spine.pose().tilt_rad, 0.049);
  EXPECT_EQ(spine.push(), 0);
  EXPECT_TRUE(spine.move_to({{0, 0.99885}, 0.04}));
}

TEST(SpineSteps, AMoveHasSixtyFourStepsAtMost) {
  // From 3 to 0.9, of which the first 60 settle.
  Spine spine(form(6, 0));
  spine.place({{0, 3}, 0});
  EXPECT_FALSE(spine.move_to({{0, 0.9}, 0}));
  EXPECT_NEAR(spine.pose().root.z, 3 - 60 * 2.1 / 64, 1e-12);
}

TEST(SpineSteps, AForceThatNoHairBearsLeavesTheLastGoodShape) {
  Spine spine = on_paper();
  const double push = spine.push(), drag = spine.drag();
  const std::vector<SpinePoint> nodes(spine.nodes().begin(), spine.nodes().end());
  const std::vector<double> bends(spine.bends().begin(), spine.bends().end());
  for (const SpinePoint force : {SpinePoint{1e12, 0}, {0, 1e12}, {-1e12, 1e12}}) {
    spine.set_tip_force(force);
    EXPECT_FALSE(spine.move_to({{0.1, 0.7}, 0.3}));
    EXPECT_EQ(spine.push(), push);
    EXPECT_EQ(spine.drag(), drag);
    EXPECT_EQ(spine.pose().root.x, 0);
    EXPECT_EQ(spine.pose().root.z, 0.8);
    EXPECT_EQ(spine.pose().tilt_rad, 0.2);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      EXPECT_EQ(spine.nodes()[k].x, nodes[k].x) << k;
      EXPECT_EQ(spine.nodes()[k].z, nodes[k].z) << k;
    }
    for (std::size_t i = 0; i < bends.size(); ++i) EXPECT_EQ(spine.bends()[i], bends[i]) << i;
  }
  // Without that force it goes on as a spine that never felt it.
  spine.set_tip_force({});
  Spine other = on_paper();
  EXPECT_TRUE(spine.move_to({{0.1, 0.7}, 0.3}));
  EXPECT_TRUE(other.move_to({{0.1, 0.7}, 0.3}));
  EXPECT_NEAR(spine.push(), other.push(), 1e-9);
  EXPECT_NEAR(spine.drag(), other.drag(), 1e-9);
}

TEST(SpineSteps, WhereTheHairCannotReachOutOfThePaperTheRootStays) {
  // A root deeper than the hair is long leaves no node above the paper.
  Spine spine(form(1, 0.01));
  spine.move_to({{0, 0.5}, 0});
  EXPECT_FALSE(spine.move_to({{0, -1.5}, 0}));
  EXPECT_GE(spine.pose().root.z, -1 - Spine::kTouching);
  EXPECT_LT(spine.pose().root.z, -0.9);
  EXPECT_GE(spine.nodes()[1].z, 0);
  // Its joint holds the push where it stopped.
  const double moment = 2 * (spine.bends()[0] - 0.01);
  EXPECT_NEAR(spine.push() * std::sin(spine.bends()[0]), moment, 0.01 * moment);
  EXPECT_TRUE(spine.move_to({{0, 0.5}, 0}));
  EXPECT_NEAR(spine.push() * std::sin(spine.bends()[0]), 2 * (spine.bends()[0] - 0.01), 1e-3);
}

TEST(SpineSteps, WhatIsNoNumberMovesNothing) {
  Spine spine = on_paper();
  const double push = spine.push();
  for (const double none : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(spine.move_to({{0.1, 0.7}, none}));
    EXPECT_FALSE(spine.move_to({{none, 0.7}, 0}));
    EXPECT_FALSE(spine.move_to({{0.1, none}, 0}));
    EXPECT_EQ(spine.pose().root.x, 0);
    EXPECT_EQ(spine.pose().tilt_rad, 0.2);
    EXPECT_EQ(spine.push(), push);
  }
}

TEST(SpineSteps, APlacedSpineForgetsWhatHappened) {
  SpineForm hair = form(6, 0.005);
  SpineFriction friction;
  friction.paper = 0.4;
  friction.yield_rad = 0.05;
  friction.keeps_rad = 0.2;
  friction.inner_share = 0.5;
  friction.inner_rad = 0.02;
  Spine spine(hair, friction), fresh(hair, friction);
  spine.place({{0, 0.5}, 0.3});
  spine.move_to({{0.3, 0.4}, 0.1});
  for (const double height : {1.0005, 0.8}) {
    spine.place({{0, height}, 0.1});
    fresh.place({{0, height}, 0.1});
    for (std::size_t k = 0; k < spine.nodes().size(); ++k) {
      EXPECT_EQ(spine.nodes()[k].x, fresh.nodes()[k].x) << k;
      EXPECT_EQ(spine.pushes()[k], fresh.pushes()[k]) << k;
      EXPECT_EQ(spine.drags()[k], fresh.drags()[k]) << k;
    }
    for (std::size_t i = 0; i < spine.bends().size(); ++i) EXPECT_EQ(spine.bends()[i], fresh.bends()[i]) << i;
    EXPECT_EQ(spine.iterations(), fresh.iterations());
  }
}

}  // namespace
}  // namespace nazori::brush
