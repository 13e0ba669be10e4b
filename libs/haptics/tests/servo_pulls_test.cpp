// SPDX-License-Identifier: Apache-2.0
// The pull of a stroke and the pull of guidance at the same time.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

#include "nazori/haptics/servo.h"
#include "servo_hand.h"

namespace nazori::haptics {
namespace {

using test::Hand;

TEST(ServoPulls, ADisturbanceBeginsWithWhatTheCaptureLeavesOfAStep) {
  // The stroke pulls down with so much. In a tenth of a second it has all of it, so a hundredth in each tick.
  // Both together change by 0.04 N in a tick, but a tenth of that is always the disturbance's.
  for (const auto& [pull_n, left_n] : {std::pair{0.5, 0.035}, {2.0, 0.02}, {3.5, 0.005}, {3.9, 0.004}}) {
    DeviceDescription device;
    device.limits.max_force_n = device.limits.continuous_force_n = 20;
    device.limits.max_stiffness_n_m = 1000;
    device.limits.max_slew_n_s = 1e6;
    Hand hand(device);
    const Vec3 down{0.001, 0, -0.005};
    hand.servo.set_scene(std::make_shared<HapticScene>());
    hand.rest(down, 400);

    auto scene = std::make_shared<HapticScene>();
    scene->strokes = {{{{0, 0, -0.01}, {0.06, 0, -0.01}}}};
    scene->material.stiffness = 0;
    scene->snapping.enabled = true;
    scene->snapping.stiffness = pull_n / (1000 * 0.005);
    scene->snapping.snap_distance_m = 0.02;
    scene->guiding.mode = GuidingMode::disturb;
    scene->guiding.strength = scene->guiding.disturbance_n = 1;
    hand.servo.set_scene(scene);
    for (int tick = 1; tick <= 5; ++tick) {
      const Vec3 force = hand.at(down);
      ASSERT_NEAR(force.z, -0.01 * pull_n * tick, 1e-9) << tick;
      ASSERT_NEAR(std::hypot(force.x, force.y), left_n * tick, 1e-4) << pull_n << " " << tick;
    }
  }
}

}  // namespace
}  // namespace nazori::haptics
