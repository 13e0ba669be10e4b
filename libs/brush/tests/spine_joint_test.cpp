// SPDX-License-Identifier: Apache-2.0
// A spine of one or two segments, whose balance is known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "nazori/brush/spine.h"

namespace nazori::brush {
namespace {

// Of the joint of a spine of one segment, half of which bends at it.
constexpr double kStiffness = 2;
constexpr double kRest_rad = 0.01;

SpineForm one_segment(double own_bend_rad = kRest_rad) {
  SpineForm form;
  form.segments = 1;
  form.own_bend_rad = own_bend_rad;
  return form;
}

/// The tip of one segment lies on the paper, so the height of its root says how far it is bent.
void bend_to(Spine& spine, double angle_rad, double x = 0) { spine.move_to({{x, std::cos(angle_rad)}, 0}); }

/// The moment of the joint, which the push at the tip holds where nothing rubs.
double moment(const Spine& spine) { return spine.push() * std::sin(spine.bends()[0]); }

TEST(SpineJoint, IsASpringAroundItsOwnBend) {
  for (const double own : {kRest_rad, -kRest_rad, 0.1}) {
    Spine spine(one_segment(own));
    for (const double angle : {0.3, 0.5, 0.9, 0.4}) {
      const double bent = own > 0 ? angle : -angle;
      bend_to(spine, angle);
      EXPECT_NEAR(spine.bends()[0], bent, 1e-4) << own << " " << angle;
      EXPECT_NEAR(moment(spine), kStiffness * (bent - own), 1e-3) << own << " " << angle;
      EXPECT_EQ(spine.drag(), 0);
    }
    spine.move_to({{0, 1.2}, 0});
    EXPECT_EQ(spine.push(), 0);
    EXPECT_NEAR(spine.bends()[0], own, 1e-6);
  }
}

TEST(SpineJoint, BeyondItsYieldItsZeroFollowsUpToWhatItKeeps) {
  for (const double side : {1.0, -1.0}) {
    SpineFriction friction;
    friction.yield_rad = 0.2;
    friction.keeps_rad = 0.15;
    Spine spine(one_segment(side * 0.1), friction);
    bend_to(spine, 0.25);
    EXPECT_NEAR(side * moment(spine), kStiffness * 0.15, 1e-3) << "not beyond it";
    bend_to(spine, 0.4);
    EXPECT_NEAR(side * moment(spine), kStiffness * 0.2, 1e-3) << "its zero is at 0.2";
    bend_to(spine, 0.35);
    EXPECT_NEAR(side * moment(spine), kStiffness * 0.15, 1e-3) << "and stays there";
    bend_to(spine, 0.43);
    EXPECT_NEAR(side * moment(spine), kStiffness * 0.2, 1e-3) << "its zero has come to 0.23";
    bend_to(spine, 0.5);
    EXPECT_NEAR(side * moment(spine), kStiffness * (0.5 - 0.25), 1e-3) << "its own bend and what it keeps";
    bend_to(spine, 0.3);
    EXPECT_NEAR(side * moment(spine), kStiffness * (0.3 - 0.25), 1e-3);
    spine.move_to({{0, 1.2}, 0});
    EXPECT_NEAR(side * spine.bends()[0], 0.25, 1e-5);
  }
}

TEST(SpineJoint, AZeroBeyondASmallerLimitStaysUntilTheBendIsLess) {
  SpineFriction friction;
  friction.yield_rad = 0.2;
  friction.keeps_rad = 0.15;
  Spine spine(one_segment(0.1), friction);
  bend_to(spine, 0.5);
  friction.keeps_rad = 0.05;
  spine.set_friction(friction);
  bend_to(spine, 0.52);
  EXPECT_NEAR(moment(spine), kStiffness * (0.52 - 0.25), 1e-3);
  spine.move_to({{0, 1.2}, 0});
  EXPECT_NEAR(spine.bends()[0], 0.25, 1e-5);
}

TEST(SpineJoint, OneStepTakesItsZeroAsFarAsManySmallOnes) {
  // A root that goes down by 0.019 does so in one step.
  const double angle = std::acos(0.981);
  for (const auto& [yield, keeps, want] : {std::tuple{0.05, 0.5, 0.05}, {0.01, 0.03, angle - 0.1 - 0.03}}) {
    SpineFriction friction;
    friction.yield_rad = yield;
    friction.keeps_rad = keeps;
    Spine spine(one_segment(0.1), friction);
    spine.move_to({{0, 1}, 0});
    spine.move_to({{0, 0.981}, 0});
    EXPECT_NEAR(moment(spine), kStiffness * want, 1e-3) << keeps;
  }
}

TEST(SpineJoint, HairsHoldOneAnotherUntilTheySlip) {
  SpineFriction friction;
  friction.inner_share = 0.5;
  friction.inner_rad = 0.05;
  for (const double side : {1.0, -1.0}) {
    Spine spine(one_segment(side * kRest_rad), friction);
    const auto elastic = [](double angle) { return kStiffness * (angle - kRest_rad); };
    bend_to(spine, 0.5);
    EXPECT_NEAR(side * moment(spine), elastic(0.5) + 0.05, 1e-3);
    bend_to(spine, 0.46);
    EXPECT_NEAR(side * moment(spine), elastic(0.46) + 0.01, 1e-3) << "let off by 0.04";
    bend_to(spine, 0.42);
    EXPECT_NEAR(side * moment(spine), elastic(0.42) - 0.03, 1e-3);
    bend_to(spine, 0.3);
    EXPECT_NEAR(side * moment(spine), elastic(0.3) - 0.05, 1e-3) << "slipped the other way";
  }
}

/// Bent to 0.5 without friction, which begins there.
Spine rubbing(const SpineFriction& friction) {
  Spine spine(one_segment());
  bend_to(spine, 0.5);
  spine.set_friction(friction);
  return spine;
}

constexpr double kMoment = kStiffness * (0.5 - kRest_rad);

TEST(SpineJoint, ATipHoldsToThePaperAsASpringAndSlipsAtTheCone) {
  const double sine = std::sin(0.5), cosine = std::cos(0.5);
  SpineFriction friction;
  friction.paper = 0.3;
  friction.sideways = 200;
  {
    Spine spine = rubbing(friction);
    bend_to(spine, 0.5, 0.0005);
    EXPECT_NEAR(spine.drag(), -0.1, 5e-3) << "its place is exact to a hundred-thousandth of its length";
    EXPECT_NEAR(spine.push(), (kMoment + 0.1 * cosine) / sine, 1e-2);
    bend_to(spine, 0.5, 0.0008);
    EXPECT_NEAR(spine.drag(), -0.16, 5e-3);
    bend_to(spine, 0.5, 0.0002);
    EXPECT_NEAR(spine.drag(), -0.04, 5e-3) << "it has not slipped";
  }
  for (const double way : {1.0, -1.0}) {
    Spine spine = rubbing(friction);
    // A tip that is pushed ahead of the root presses harder, one that trails less.
    const double push = kMoment / (sine - way * 0.3 * cosine);
    for (int i = 1; i <= 20; ++i) bend_to(spine, 0.5, 0.01 * way * i);
    EXPECT_NEAR(spine.push(), push, 0.005 * push) << way;
    EXPECT_NEAR(spine.drag(), -way * 0.3 * push, 0.005 * push) << way;
    const double slipped = spine.drag();
    bend_to(spine, 0.5, 0.2 * way - 0.0005 * way);
    EXPECT_NEAR(spine.drag(), slipped + way * 0.1, 0.005 * push) << "let off by half a thousandth";
  }
}

TEST(SpineJoint, HairThatTrailsRubsLessByThePowerOfItsLie) {
  const double sine = std::sin(0.5), cosine = std::cos(0.5);
  SpineFriction friction;
  friction.paper = 0.3;
  friction.along_hair = 0.6;
  friction.exponent = 2;
  for (const double way : {1.0, -1.0}) {
    Spine spine = rubbing(friction);
    for (int i = 1; i <= 20; ++i) bend_to(spine, 0.5, 0.01 * way * i);
    // The tip lies ahead of its root by the sine of its angle.
    const double paper = way > 0 ? 0.3 : 0.3 * (1 - 0.6 * sine * sine);
    const double push = kMoment / (sine - way * paper * cosine);
    EXPECT_NEAR(spine.push(), push, 0.005 * push) << way;
    EXPECT_NEAR(spine.drag(), -way * paper * push, 0.005 * push) << way;
  }
}

TEST(SpineJoint, TwoJointsShareATipForceByTheirStiffness) {
  for (const double power : {2.0, 4.0}) {
    SpineForm form;
    form.segments = 2;
    form.own_bend_rad = 0;
    form.taper = 0.2;
    form.taper_power = power;
    // A quarter and three quarters of the hair bend at the joints; halfway the radius is 0.6.
    const double root = 1 / 0.25, middle = std::pow(0.6, power) / 0.5;
    Spine down(form);
    down.set_tip_force({0.001, 0});
    down.place({{0, 5}, 0});
    EXPECT_NEAR(down.bends()[0], 0.001 / root, 2e-7);
    EXPECT_NEAR(down.bends()[1], 0.0005 / middle, 4e-6);
    Spine level(form);
    level.set_tip_force({0, 0.001});
    level.place({{0, 5}, std::numbers::pi / 2});
    EXPECT_NEAR(level.bends()[0], 0.001 / root, 2e-7);
    EXPECT_NEAR(level.bends()[1], 0.0005 / middle, 4e-6);
    EXPECT_GT(level.nodes()[2].z, 5);
  }
}

TEST(SpineForm, SegmentsBecomeShorterByTheSameRatio) {
  SpineForm form;
  form.segments = 3;
  form.tip_segment = 0.25;
  form.thickness = 0.2;
  form.bulge = 3;
  form.own_bend_rad = 0.06;
  const Spine spine(form);
  // 4 : 2 : 1.
  const double along[] = {0, 4.0 / 7, 6.0 / 7, 1};
  ASSERT_EQ(spine.along().size(), 4U);
  ASSERT_EQ(spine.clearances().size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(spine.along()[k], along[k], 1e-15) << k;
    EXPECT_NEAR(spine.clearances()[k], k == 0 ? 0 : 0.2 * (1 - std::pow(along[k], 3)), 1e-15) << k;
  }
  ASSERT_EQ(spine.bends().size(), 3U);
  for (const double bend : spine.bends()) EXPECT_NEAR(bend, 0.02, 1e-9);
  EXPECT_EQ(spine.segments(), 3);
  const Spine one(one_segment());
  EXPECT_EQ(one.along()[1], 1);
}

TEST(Spine, WhatItsJointsKeepIsMirroredToo) {
  SpineForm form;
  form.own_bend_rad = 0;
  form.taper = 0.1;
  SpineFriction friction;
  friction.paper = 0.3;
  friction.yield_rad = 0.05;
  friction.keeps_rad = 0.1;
  friction.inner_share = 0.4;
  friction.inner_rad = 0.02;
  Spine spine(form, friction), image(form, friction);
  const auto both = [&](double depth, double x, double tilt) {
    spine.move_to({{x, std::cos(tilt) - depth}, tilt});
    image.move_to({{-x, std::cos(tilt) - depth}, -tilt});
  };
  both(0.3, 0, 0.2);
  both(0.5, 0.1, 0.3);
  both(0.4, 0.1, 0.25);
  image.mirror();
  EXPECT_NEAR(image.pose().root.x, spine.pose().root.x, 1e-15);
  EXPECT_NEAR(image.pose().tilt_rad, spine.pose().tilt_rad, 1e-15);
  for (int i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < spine.nodes().size(); ++k) {
      EXPECT_NEAR(image.nodes()[k].x, spine.nodes()[k].x, 1e-6) << i;
      EXPECT_NEAR(image.drags()[k], spine.drags()[k], 1e-4) << i;
      EXPECT_NEAR(image.pushes()[k], spine.pushes()[k], 1e-4) << i;
    }
    for (std::size_t k = 0; k < spine.bends().size(); ++k)
      EXPECT_NEAR(image.bends()[k], spine.bends()[k], 1e-5) << i;
    const double depth = 0.35 - 0.1 * i;
    spine.move_to({{0.12, std::cos(0.2) - depth}, 0.2});
    image.move_to({{0.12, std::cos(0.2) - depth}, 0.2});
  }
}

TEST(Spine, WhatSlippedIsShiftedToo) {
  SpineFriction friction;
  friction.paper = 0.3;
  Spine spine = rubbing(friction), other = rubbing(friction);
  bend_to(spine, 0.5, 0.0005);
  bend_to(other, 0.5, 0.0005);
  other.shift(-3);
  bend_to(spine, 0.5, 0.0007);
  bend_to(other, 0.5, -3 + 0.0007);
  EXPECT_NEAR(other.drag(), spine.drag(), 1e-6);
  EXPECT_NEAR(other.push(), spine.push(), 1e-5);
}

}  // namespace
}  // namespace nazori::brush
