// SPDX-License-Identifier: Apache-2.0
// What a hand gets back from the springs of a servo: all that it put in, and nothing else.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <memory>

#include "relief.h"
#include "servo_hand.h"

namespace nazori::haptics {
namespace {

using test::Hand;
using test::plate;
using test::Relief;

/// A spring along one direction.
struct Spring {
  std::shared_ptr<HapticScene> scene;
  double stiffness_n_m;
  Vec3 rest_m;  ///< here it is not bent
  Vec3 bent_m;  ///< here it is, by `lag_m`
  double lag_m;
};

Spring surface_spring() {
  static const Relief flat(64, 0.01, plate);
  return {flat.scene(), 400, {0.02, 0.01, 1e-6}, {0.02, 0.01, -0.002}, 0.002};
}
Spring brush_spring() {
  auto scene = std::make_shared<HapticScene>();
  scene->soft_tip = std::make_shared<SoftTip>(SoftTip{0.005, {0, 0.5, 1, 1.5}, 0});
  return {scene, 100, {0.02, 0.01, 1e-6}, {0.02, 0.01, -0.004}, 0.004};
}
Spring stroke_spring() {
  auto scene = std::make_shared<HapticScene>();
  scene->strokes = {{{{-0.04, 0, 0}, {0.04, 0, 0}}}};
  scene->snapping.enabled = true;
  return {scene, 100, {0.02, 0, 0}, {0.02, 0.006, 0}, 0.006};
}

/// A hand at a bent spring. It also gave the device energy that no spring keeps: its joints damp.
class HandAtASpring {
 public:
  explicit HandAtASpring(const Spring& of) : spring(of), hand(device()) {
    hand.servo.set_scene(spring.scene);
    hand.rest(spring.rest_m, 400);
    hand.go(spring.rest_m, spring.bent_m, 400);
    // Along the plate or the stroke, so that the spring stays as it is.
    const Vec3 aside = spring.bent_m + Vec3(0.003, 0, 0);
    for (int i = 0; i < 400; ++i) force = hand.at(i % 2 == 0 ? aside : spring.bent_m);
    force = hand.rest(spring.bent_m, 10);
  }
  static DeviceDescription device() {
    DeviceDescription made;
    made.limits.own_damping_n_s_m = 0.001;
    made.limits.max_damping_n_s_m = 1000;  // it can brake as hard as it needs to
    made.limits.max_slew_n_s = 1e6;
    return made;
  }
  [[nodiscard]] double held_j() const { return 0.5 * spring.stiffness_n_m * spring.lag_m * spring.lag_m; }
  /// The work that the hand gets on a straight way.
  double work_j(const Vec3& from, const Vec3& to, int ticks) {
    double work = 0;
    for (int i = 1; i <= ticks; ++i) {
      work += glm::dot(force, (to - from) / static_cast<double>(ticks));
      force = hand.at(from + (to - from) * (static_cast<double>(i) / ticks));
    }
    return work;
  }

  Spring spring;
  Hand hand;
  Vec3 force{0, 0, 0};
};

TEST(ServoEnergy, WhatASpringHoldsComesBack) {
  for (const Spring& spring : {surface_spring(), brush_spring(), stroke_spring()}) {
    HandAtASpring at(spring);
    EXPECT_NEAR(glm::length(at.force), spring.stiffness_n_m * spring.lag_m, 1e-9);
    EXPECT_NEAR(at.work_j(spring.bent_m, spring.rest_m, 400), at.held_j(), 0.02 * at.held_j());
  }
}

TEST(ServoEnergy, AHandThatGotTwiceWhatASpringHeldGetsNothingTheNextTime) {
  // In one tick from the bent spring to rest the full force acts all the way: that is twice what it held.
  // What the joints damped before does not count, because no spring keeps it.
  for (const Spring& spring : {surface_spring(), brush_spring(), stroke_spring()}) {
    HandAtASpring at(spring);
    EXPECT_NEAR(at.work_j(spring.bent_m, spring.rest_m, 1), 2 * at.held_j(), 0.02 * 2 * at.held_j());
    (void)at.work_j(spring.rest_m, spring.bent_m, 400);
    EXPECT_LT(at.work_j(spring.bent_m, spring.rest_m, 400), 0.25 * at.held_j());
  }
}

}  // namespace
}  // namespace nazori::haptics
