// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/soft_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "alloc_guard.h"
#include "nazori/haptics/servo.h"
#include "soft_tip_under_test.h"

namespace nazori::haptics {
namespace {

TEST(SoftTipTable, PushesAsItsValuesSayAndBetweenThemInProportion) {
  const SoftTipTable tip = table();
  ASSERT_TRUE(tip.exists());
  EXPECT_EQ(tip.push_n(-0.001), 0);
  EXPECT_EQ(tip.push_n(0), 0);
  EXPECT_NEAR(tip.push_n(0.0025), 0.05, 1e-12);
  EXPECT_NEAR(tip.push_n(0.005), 0.1, 1e-12);
  EXPECT_NEAR(tip.push_n(0.0075), 0.25, 1e-12);
  EXPECT_NEAR(tip.push_n(0.0125), 0.35, 1e-12);
  EXPECT_NEAR(tip.push_n(0.02), 0.5, 1e-12);
  EXPECT_NEAR(tip.push_n(0.9), 0.5, 1e-12);
  EXPECT_EQ(tip.push_n(kNan), 0);
}

TEST(SoftTipTable, StoresTheIntegralOfItsPush) {
  const SoftTipTable tip = table();
  EXPECT_EQ(tip.stored_j(-1), 0);
  double sum = 0;
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 25'000; ++i) {
    sum += kStep * tip.push_n((i + 0.5) * kStep);
    ASSERT_NEAR(tip.stored_j((i + 1) * kStep), sum, 1e-9);
  }
}

TEST(SoftTipTable, IsBroughtWithinTheLimitsOfTheDevice) {
  SoftTip tip;
  tip.step_m = 0.001;
  tip.push_n = {9, 9, 9, -3, 2, 1.5};
  tip.friction = -1;
  tip.along_hair = 7;
  tip.sideways_n_m = 1e6;
  tip.tow_m = kNan;
  const SoftTipTable made(tip, 500, 0.8);
  EXPECT_EQ(made.push_n(0), 0);
  EXPECT_NEAR(made.push_n(0.001), 0.5, 1e-12);
  EXPECT_NEAR(made.push_n(0.002), 0.8, 1e-12);
  EXPECT_NEAR(made.push_n(0.003), 0.3, 1e-12);
  EXPECT_NEAR(made.push_n(0.004), 0.8, 1e-12);
  EXPECT_NEAR(made.push_n(0.005), 0.8, 1e-12);
  EXPECT_EQ(made.friction(), 0);
  EXPECT_EQ(made.along_hair(), 1);
  EXPECT_EQ(made.sideways_n_m(), 500);
  EXPECT_GT(made.tow_m(), 0);
}

TEST(SoftTipTable, ThereIsNoTipWithoutTwoFiniteValues) {
  SoftTip tip = brush();
  for (const std::vector<double>& values : {std::vector<double>{}, {0.1}, {0, kNan}}) {
    tip.push_n = values;
    EXPECT_FALSE(table(tip).exists());
    EXPECT_EQ(table(tip).push_n(0.01), 0);
    EXPECT_EQ(table(tip).stored_j(0.01), 0);
  }
  tip = brush();
  for (const double step : {0.0, -1.0, kNan, 5.0}) {
    tip.step_m = step;
    EXPECT_FALSE(table(tip).exists());
  }
}

TEST(SoftContact, PushesUpWhereItIsPressedAndNotAbove) {
  const SoftTipTable tip = table();
  SoftContact contact;
  contact.update(tip, {0, 0, 0.001});
  EXPECT_FALSE(contact.touching());
  contact.update(tip, {0, 0, -0.005});
  EXPECT_TRUE(contact.touching());
  EXPECT_EQ(contact.force_n(), Vec3(0, 0, 0.1));
  contact.update(tip, {0, 0, 0});
  EXPECT_FALSE(contact.touching());
  EXPECT_EQ(contact.force_n(), Vec3(0));
  EXPECT_EQ(contact.stored_j(), 0);
}

TEST(SoftContact, ResistsAsASpringAndThenSlipsAtTheCone) {
  SoftTip hair = brush();
  hair.along_hair = 0;
  const SoftTipTable tip = table(hair);
  SoftContact contact;
  contact.update(tip, {0.01, 0.02, -0.01});
  contact.update(tip, {0.012, 0.02, -0.01});
  EXPECT_NEAR(contact.force_n().x, -0.04, 1e-12);
  EXPECT_NEAR(contact.stored_j(), tip.stored_j(0.01) + 0.5 * 20 * 0.002 * 0.002, 1e-12);
  contact.update(tip, {0.010, 0.02, -0.01});
  EXPECT_NEAR(contact.force_n().x, 0, 1e-12);
  for (int i = 1; i <= 200; ++i) contact.update(tip, {0.01, 0.02 + 0.0001 * i, -0.01});
  EXPECT_NEAR(contact.force_n().y, -0.3 * 0.4, 1e-9);
  EXPECT_NEAR(contact.force_n().x, 0, 1e-9);
  // Back by a little: the spring is let off before it slips the other way.
  contact.update(tip, {0.01, 0.04 - 0.006, -0.01});
  EXPECT_NEAR(contact.force_n().y, 0, 1e-9);
}

TEST(SoftContact, SlidesMoreEasilyWhereTheHairTrails) {
  const SoftTipTable tip = table();
  SoftContact contact;
  for (int i = 0; i <= 300; ++i) contact.update(tip, {0.0001 * i, 0, -0.01});
  EXPECT_NEAR(contact.force_n().x, -0.3 * 0.6 * 0.4, 1e-6);
  // Against the lie of the hair, while it has not turned round yet.
  double most = 0;
  for (int i = 1; i <= 95; ++i) {
    contact.update(tip, {0.03 - 0.0001 * i, 0, -0.01});
    most = std::max(most, contact.force_n().x);
  }
  EXPECT_GT(most, 0.97 * 0.3 * 0.4);
  for (int i = 96; i <= 400; ++i) contact.update(tip, {0.03 - 0.0001 * i, 0, -0.01});
  EXPECT_NEAR(contact.force_n().x, 0.3 * 0.6 * 0.4, 1e-6);
}

TEST(SoftContact, ForgetsTheWayWhenItIsLifted) {
  const SoftTipTable tip = table();
  SoftContact contact;
  for (int i = 0; i <= 100; ++i) contact.update(tip, {0.0001 * i, 0, -0.01});
  EXPECT_LT(contact.force_n().x, -0.05);
  contact.update(tip, {0.01, 0, 0.001});
  contact.update(tip, {0.05, 0, -0.01});
  EXPECT_EQ(sideways(contact.force_n()), 0);
  contact.update(SoftTipTable(), {0.06, 0, -0.01});
  EXPECT_FALSE(contact.touching());
}

/// Closed ways: sums of sines in all three directions, partly above the sheet.
class ClosedWay {
 public:
  explicit ClosedWay(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    for (auto& axis : waves_)
      for (auto& wave : axis) wave = {any(random), std::numbers::pi * any(random)};
    depth_ = 0.006 + 0.006 * any(random);
  }
  [[nodiscard]] Vec3 at(double turn) const {
    Vec3 p(0);
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 3; ++i) {
        const auto& wave = waves_[axis][i];
        p[axis] += 0.008 * wave.size * std::sin(2 * std::numbers::pi * (i + 1) * turn + wave.phase);
      }
    p.z -= depth_;
    return p;
  }

 private:
  struct Wave {
    double size, phase;
  };
  Wave waves_[3][3];
  double depth_;
};

TEST(SoftContact, GivesNoWorkOverTwoThousandClosedWaysAndStaysInItsCone) {
  const SoftTipTable tip = table();
  constexpr int kTicks = 400;
  int rubbed = 0;
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    const ClosedWay way(seed);
    SoftContact contact;
    Vec3 before = way.at(0);
    contact.update(tip, before);
    Vec3 force = contact.force_n();
    double stored = contact.stored_j(), work = 0;
    const double first = stored;
    for (int i = 1; i <= kTicks; ++i) {
      const Vec3 now = way.at(static_cast<double>(i) / kTicks);
      contact.update(tip, now);
      // The push is a potential's: its work is known exactly. Friction is linear between two ticks or slips.
      const double push_work = tip.stored_j(-before.z) - tip.stored_j(-now.z);
      Vec3 mean = 0.5 * (force + contact.force_n());
      mean.z = 0;
      work += push_work + glm::dot(mean, now - before);
      ASSERT_LE(sideways(contact.force_n()), 0.3 * contact.force_n().z + 1e-12);
      before = now;
      force = contact.force_n();
      stored = contact.stored_j();
      ASSERT_GE(stored, 0);
    }
    // What is still in the spring was put into it.
    ASSERT_LE(work, first + 1e-9) << seed;
    rubbed += work < -1e-5 ? 1 : 0;
  }
  EXPECT_GT(rubbed, 1000);
}

TEST(SoftContact, ItsForceChangesInProportionToTheWay) {
  const SoftTipTable tip = table();
  // The steepest push is 60 N/m; the cone changes by friction x push and by along_hair within a millimetre.
  constexpr double kMost_n_m = 60 + 20 + 0.3 * 60 + 0.3 * 0.5 * 0.4 * 1000;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const ClosedWay way(seed);
    SoftContact contact;
    Vec3 before = way.at(0);
    contact.update(tip, before);
    for (int i = 1; i <= 20'000; ++i) {
      const Vec3 now = way.at(i / 10'000.0);
      const Vec3 force = contact.force_n();
      contact.update(tip, now);
      ASSERT_LE(glm::length(contact.force_n() - force), kMost_n_m * glm::length(now - before) + 1e-12);
      before = now;
    }
  }
}

std::shared_ptr<HapticScene> soft_scene(const SoftTip& tip = brush()) {
  auto scene = std::make_shared<HapticScene>();
  scene->soft_tip = std::make_shared<SoftTip>(tip);
  return scene;
}

/// Ticks until the ramp is over.
Vec3 held(Servo& servo, const Vec3& at, double& time_s) {
  Vec3 force(0);
  for (int i = 0; i < 1000; ++i) force = servo.tick({time_s += 0.001, at, 0, true});
  return force;
}

TEST(SoftTipInTheServo, PushesAsItsTableAndIsNeverBelowTheSheet) {
  Servo servo{DeviceDescription{}};
  servo.set_scene(soft_scene());
  double time_s = 0;
  EXPECT_NEAR(held(servo, {0, 0, -0.005}, time_s).z, 0.1, 1e-9);
  EXPECT_TRUE(servo.latest().touching);
  EXPECT_EQ(servo.latest().proxy_m, Vec3(0, 0, 0));
  EXPECT_EQ(held(servo, {0, 0, 0.001}, time_s), Vec3(0));
  EXPECT_FALSE(servo.latest().touching);
  EXPECT_EQ(servo.latest().proxy_m, Vec3(0, 0, 0.001));
}

TEST(SoftTipInTheServo, TakesThePlaceOfTheSurface) {
  Servo servo{DeviceDescription{}};
  auto scene = soft_scene();
  surface::HeightMap map = *surface::HeightMap::create(16);
  scene->surface = *surface::SmoothSurface::create(map);
  servo.set_scene(scene);
  double time_s = 0;
  EXPECT_NEAR(held(servo, {0, 0, -0.01}, time_s).z, 0.4, 1e-9);
}

TEST(SoftTipInTheServo, TouchesAndLetsGoAsEvents) {
  Servo servo{DeviceDescription{}};
  servo.set_scene(soft_scene());
  servo.tick({0.001, {0, 0, 0.001}, 0, true});
  servo.tick({0.002, {0, 0, -0.001}, 0, true});
  EXPECT_TRUE(has(servo.latest().events, ServoEvent::touch));
  servo.tick({0.003, {0, 0, 0.001}, 0, true});
  EXPECT_TRUE(has(servo.latest().events, ServoEvent::untouch));
  servo.tick({0.004, {0, 0, -0.001}, 0, true});
  servo.tick({0.005, {0, 0, -0.001}, 0, false});
  EXPECT_TRUE(has(servo.latest().events, ServoEvent::untouch));
}

TEST(SoftTipInTheServo, AnotherTipComesInWithoutAJolt) {
  Servo servo{DeviceDescription{}};
  servo.set_scene(soft_scene());
  double time_s = 0;
  const Vec3 before = held(servo, {0, 0, -0.02}, time_s);
  SoftTip stiff = brush();
  for (double& n : stiff.push_n) n *= 4;
  servo.set_scene(soft_scene(stiff));
  Vec3 last = before;
  const DeviceDescription device;
  for (int i = 0; i < 500; ++i) {
    const Vec3 now = servo.tick({time_s += 0.001, {0, 0, -0.02}, 0, true});
    EXPECT_LE(glm::length(now - last), device.limits.max_slew_n_s * 0.001 + 1e-9);
    last = now;
  }
  // The device bears so much for long, and the tip pushes more.
  EXPECT_GT(last.z, 0.8);
}

TEST(SoftTipInTheServo, StaysWithinTheLimitsOfTheDeviceAndAllocatesNothing) {
  DeviceDescription device;
  device.limits.max_force_n = 0.5;
  device.limits.continuous_force_n = 0.3;
  Servo servo{device};
  SoftTip tip = brush();
  for (double& n : tip.push_n) n *= 100;
  servo.set_scene(soft_scene(tip));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  Vec3 at(0), last(0);
  std::vector<Vec3> path;
  for (int i = 0; i < 20'000; ++i) {
    at += Vec3(0.001 * any(random), 0.001 * any(random), 0.002 * any(random));
    at = glm::clamp(at, Vec3(-0.05, -0.05, -0.03), Vec3(0.05, 0.05, 0.01));
    path.push_back(at);
  }
  const test::AllocGuard guard;
  double most = 0, step = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec3 force = servo.tick({0.001 * static_cast<double>(i + 1), path[i], 0, true});
    most = std::max(most, glm::length(force));
    step = std::max(step, glm::length(force - last));
    last = force;
  }
  EXPECT_EQ(guard.calls(), 0);
  EXPECT_LE(most, 0.5 + 1e-9);
  EXPECT_LE(step, device.limits.max_slew_n_s * 0.001 + 1e-9);
  EXPECT_GT(most, 0.1);
}

TEST(SoftTipInTheServo, FaultsTakeItsForceAway) {
  Servo servo{DeviceDescription{}};
  servo.set_scene(soft_scene());
  double time_s = 0;
  EXPECT_GT(held(servo, {0, 0, -0.01}, time_s).z, 0.3);
  EXPECT_EQ(servo.tick({time_s += 0.001, {0, 0, kNan}, 0, true}), Vec3(0));
  EXPECT_FALSE(servo.latest().touching);
}

}  // namespace
}  // namespace nazori::haptics
