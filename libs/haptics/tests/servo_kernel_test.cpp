// SPDX-License-Identifier: Apache-2.0
// Ticks in a process that the kernel ends at its first system call.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nazori/haptics/servo.h"
#include "relief.h"
#include "system_calls.h"

namespace nazori::haptics {
namespace {

using nazori::test::ends_without_system_call;
using test::Relief;

TEST(ServoTick, NeverEntersTheKernelEvenWhenScenesChangeFaultsComeAndTheQueueIsFull) {
  if (!nazori::test::sees_system_calls()) GTEST_SKIP() << "no seccomp here, or a clock that needs the kernel";

  const Relief groove(128, 0.01, [](double, double y) { return -0.01 * std::exp(-1e5 * y * y); });
  Servo servo{DeviceDescription{}};
  for (const GuidingMode mode :
       {GuidingMode::off, GuidingMode::lesson, GuidingMode::lead, GuidingMode::disturb}) {
    auto scene = groove.scene();
    scene->material = {0.8, 0.2, 0.4, 0.3, 0.5};
    scene->strokes.push_back({{{-0.04, 0, -0.01}, {0.04, 0, -0.01}}});
    scene->snapping.enabled = mode == GuidingMode::off;
    scene->guiding.mode = mode;
    scene->tip_radius_m = mode == GuidingMode::lead ? 0.001 : 0;
    if (mode == GuidingMode::disturb)
      scene->soft_tip = std::make_shared<SoftTip>(SoftTip{0.005, {0, 0.1, 0.3, 0.4}});
    servo.set_scene(scene);
    EXPECT_TRUE(ends_without_system_call([&] {
      double time_s = 0;
      for (int i = 0; i < 20'000; ++i) {
        time_s += i % 1000 == 999 ? 0.1 : 0.001;
        const double z =
            i % 500 == 499 ? std::numeric_limits<double>::quiet_NaN() : 0.01 * std::sin(0.05 * i);
        (void)servo.tick(
            {time_s, {0.03 * std::sin(0.01 * i), 0.01 * std::sin(0.02 * i), -0.008 + z}, 0, i % 700 != 0});
      }
    }));
  }
}

}  // namespace
}  // namespace nazori::haptics
