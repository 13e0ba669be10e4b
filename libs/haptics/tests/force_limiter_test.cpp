// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/force_limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace nazori::haptics {
namespace {

constexpr double kTick_s = 0.001;

TEST(ForceLimiter, RisesOverThreeTenthsOfASecondAfterTheStart) {
  ForceLimiter limiter{DeviceLimits{}};
  double before = 0;
  for (int i = 1; i <= 300; ++i) {
    const double now = limiter.limit({0, 0, 0.8}, kTick_s).z;
    EXPECT_NEAR(now, 0.8 * i / 300, 1e-9);
    EXPECT_GE(now, before);
    before = now;
  }
  EXPECT_NEAR(limiter.limit({0, 0, 0.8}, kTick_s).z, 0.8, 1e-12);
}

TEST(ForceLimiter, PassesNothingOverThePeakOrFasterThanTheSlewLimit) {
  const DeviceLimits limits;
  ForceLimiter limiter{limits};
  std::mt19937 random(3);
  std::normal_distribution<double> wild(0, 5);
  Vec3 before(0);
  for (int i = 0; i < 100'000; ++i) {
    const Vec3 force = limiter.limit({wild(random), wild(random), wild(random)}, kTick_s);
    ASSERT_LE(glm::length(force), limits.max_force_n * (1 + 1e-12));
    ASSERT_LE(glm::length(force - before), limits.max_slew_n_s * kTick_s * (1 + 1e-9));
    before = force;
  }
}

TEST(ForceLimiter, WhatIsNotFiniteGivesZeroAndStartsTheRampAgain) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const Vec3 bad : {Vec3(nan, 0, 0), Vec3(0, inf, 0), Vec3(0, 0, -inf), Vec3(1e200, 0, 0)}) {
    ForceLimiter limiter{DeviceLimits{}};
    for (int i = 0; i < 400; ++i) (void)limiter.limit({0, 0, 0.5}, kTick_s);
    EXPECT_EQ(limiter.limit(bad, kTick_s), Vec3(0));
    EXPECT_LT(limiter.limit({0, 0, 0.5}, kTick_s).z, 0.01);
  }
}

TEST(ForceLimiter, DropIsAtOnceAndARestartedRampFallsWithTheSlewLimit) {
  ForceLimiter limiter{DeviceLimits{}};
  for (int i = 0; i < 400; ++i) (void)limiter.limit({0, 0, 0.8}, kTick_s);
  limiter.restart_ramp();
  EXPECT_NEAR(limiter.limit({0, 0, 0.8}, kTick_s).z, 0.6, 1e-9);  // 200 N/s
  limiter.drop();
  EXPECT_EQ(limiter.last_n(), Vec3(0));
}

TEST(ForceLimiter, HoldsTheContinuousForceInTheLongRunAndThePeakInTheShort) {
  const DeviceLimits limits;
  ForceLimiter limiter{limits};
  double force = 0;
  for (int i = 0; i < 1000; ++i) force = limiter.limit({0, 0, 3.3}, kTick_s).z;
  EXPECT_NEAR(force, 3.3, 1e-9);
  double heat = 0;
  for (int i = 0; i < 200'000; ++i) {
    force = limiter.limit({0, 0, 3.3}, kTick_s).z;
    heat = std::max(heat, limiter.heat());
  }
  EXPECT_LE(heat, 1 + 1e-6);
  EXPECT_LE(force, 1.1 * limits.continuous_force_n);
  EXPECT_GE(force, limits.continuous_force_n - 1e-9);
  // At rest the motors cool, and the peak is allowed again.
  for (int i = 0; i < 60'000; ++i) (void)limiter.limit(Vec3(0), kTick_s);
  for (int i = 0; i < 50; ++i) force = limiter.limit({0, 0, 3.3}, kTick_s).z;
  EXPECT_NEAR(force, 3.3, 1e-9);
}

TEST(ForceLimiter, HeatIsTheMeanSquareOfTheForceOverTwentySeconds) {
  DeviceLimits limits;
  limits.continuous_force_n = 2;
  limits.max_force_n = 10;
  ForceLimiter limiter{limits};
  double mean_square = 0;
  for (int i = 0; i < 5000; ++i) {
    const double force = limiter.limit({0, 0, 1.5}, 0.002).z;
    mean_square += (force * force - mean_square) * 0.002 / 20;
  }
  EXPECT_NEAR(limiter.heat(), mean_square / 4, 1e-12);
  EXPECT_GT(limiter.heat(), 0.2);
  limits.continuous_force_n = 0;
  EXPECT_EQ(ForceLimiter{limits}.heat(), 0) << "a device that says nothing about it";
}

TEST(ForceLimiter, AfterAPauseLongerThanTheHeatLastsItIsThatOfTheForceAlone) {
  ForceLimiter limiter{DeviceLimits{}};
  (void)limiter.limit({0, 0, 0.44}, 1000);
  EXPECT_NEAR(limiter.heat(), 0.25, 1e-12) << "half of 0.88 N";
}

TEST(ForceLimiter, FromEightyPerCentOfTheHeatThePeakFallsInAStraightLine) {
  DeviceLimits limits;
  limits.continuous_force_n = 2;
  limits.max_force_n = 10;
  limits.max_slew_n_s = 1e9;
  ForceLimiter limiter{limits};
  int at_peak = 0, between = 0;
  for (int i = 0; i < 40'000; ++i) {
    const double heat = limiter.heat();
    const double force = limiter.limit({0, 0, 100}, 0.001).z;
    if (i < 300) continue;
    const double allowed = heat <= 0.8 ? 10 : 2 + (1 - heat) / 0.2 * 8;
    ASSERT_NEAR(force, allowed, 1e-9) << heat;
    ++(heat <= 0.8 ? at_peak : between);
  }
  EXPECT_GT(at_peak, 100);
  EXPECT_GT(between, 100);
}

TEST(ForceLimiter, ADeviceWhosePeakItBearsForLongIsNeverHeldBack) {
  DeviceLimits limits;
  limits.continuous_force_n = limits.max_force_n = 3;
  ForceLimiter limiter{limits};
  double force = 0;
  for (int i = 0; i < 100'000; ++i) force = limiter.limit({0, 0, 9}, 0.001).z;
  EXPECT_NEAR(force, 3, 1e-12);
}

TEST(PassiveStiffness, IsThatOfColgateAndSchenkelAndOfHulin) {
  // Colgate's example: 500 N/m at 1 kHz needs 0.25 N s/m.
  EXPECT_NEAR(passive_stiffness_n_m(0.25, 0, 0.001, 0), 500, 1e-9);
  EXPECT_NEAR(passive_stiffness_n_m(2.05, 0, 0.001, 0), 4100, 1e-9);
  EXPECT_NEAR(passive_stiffness_n_m(2.05, 0, 0.001, 0.001), 4100 / 3.0,
              1e-9);  // a third remains after a delay of one tick
  EXPECT_NEAR(passive_stiffness_n_m(2.05, 1.05, 0.001, 0), 2000, 1e-9);
  EXPECT_EQ(passive_stiffness_n_m(0.1, 0.5, 0.001, 0), 0);
}

// A wall made of a sampled spring: pressed in and released at speed v it gives back K T v^2 per second more
// than it received.
TEST(Passivity, SeesTheEnergyThatASampledWallMakesAndPaysItBack) {
  DeviceLimits limits;
  limits.own_damping_n_s_m = 0;
  limits.max_damping_n_s_m = 5;
  const double stiffness = 1000, speed = 0.1;
  for (const bool controlled : {false, true}) {
    Passivity passivity{limits, kTick_s};
    double z = 0, out = 0, seen = 0;
    Vec3 force(0);
    for (int round = 0; round < 10; ++round)
      for (int i = 0; i < 100; ++i) {
        const double moved = (i < 50 ? -speed : speed) * kTick_s;
        z += moved;
        out += force.z * moved;
        const double stored = z < 0 ? 0.5 * stiffness * z * z : 0;
        passivity.observe({0, 0, moved}, force, kTick_s, stored);
        seen = std::min(seen, passivity.energy_j());
        force = {0, 0, z < 0 ? -stiffness * z : 0};
        if (controlled) force += passivity.correction({0, 0, moved}, kTick_s);
      }
    if (controlled) {
      EXPECT_LT(out, 0.5 * stiffness * kTick_s * speed * speed * kTick_s * 100);
    } else {
      EXPECT_NEAR(out, 10 * stiffness * speed * speed * kTick_s * 0.05, 1e-4);
      EXPECT_LT(seen, 0);
    }
  }
}

TEST(Passivity, BooksTheForceThatActsNotTheOneThatIsStillUnderway) {
  DeviceLimits limits;
  limits.own_damping_n_s_m = 0;
  limits.delay_s = 0.002;
  Passivity passivity{limits, kTick_s};
  passivity.observe({0, 0, 0}, {0, 0, 1}, kTick_s, 1);
  passivity.observe({0, 0, 0.001}, {0, 0, 0}, kTick_s, 1);
  EXPECT_EQ(passivity.energy_j(), 0);
  passivity.observe({0, 0, 0.001}, {0, 0, 0}, kTick_s, 1);
  EXPECT_NEAR(passivity.energy_j(), -0.001, 1e-12);
}

TEST(Passivity, KeepsNoMoreThanTheSpringsHold) {
  // However much energy the hand has put in: what exceeds the energy of the springs was dissipated in the
  // wall.
  DeviceLimits limits;
  limits.own_damping_n_s_m = 0;
  Passivity passivity{limits, kTick_s};
  constexpr double kStored_j = 0.001;
  for (int i = 0; i < 10; ++i) passivity.observe({0, 0, -0.001}, {0, 0, 1}, kTick_s, kStored_j);
  EXPECT_DOUBLE_EQ(passivity.energy_j(), kStored_j);
  // Now the force does work: first exactly the stored energy, then more.
  passivity.observe({0, 0, 0.001}, {0, 0, 1}, kTick_s, kStored_j);
  EXPECT_NEAR(passivity.energy_j(), 0, 1e-15);
  passivity.observe({0, 0, 0.0001}, {0, 0, 1}, kTick_s, kStored_j);
  EXPECT_NEAR(passivity.energy_j(), -0.0001, 1e-15);
  EXPECT_LT(passivity.correction({0, 0, 0.0001}, kTick_s).z, 0);
}

TEST(Passivity, LeavesAPassiveSpringAlone) {
  DeviceLimits limits;
  limits.own_damping_n_s_m = 1;  // b > K T / 2 with a margin
  Passivity passivity{limits, kTick_s};
  double z = 0;
  Vec3 force(0);
  for (int i = 0; i < 5000; ++i) {
    const double next = -0.002 * std::sin(0.01 * i);
    const Vec3 moved{0, 0, next - z};
    z = next;
    passivity.observe(moved, force, kTick_s, z < 0 ? 0.5 * 500 * z * z : 0);
    EXPECT_LT(glm::length(passivity.correction(moved, kTick_s)), 1e-3);
    force = {0, 0, z < 0 ? -500 * z : 0};
  }
}

TEST(ForceLimiter, WithoutAContinuousForceThePeakStillHolds) {
  DeviceLimits limits;
  limits.continuous_force_n = 0;
  limits.max_force_n = 3;
  limits.max_slew_n_s = 1e9;
  ForceLimiter limiter(limits);
  Vec3 force(0);
  for (int i = 0; i < 400; ++i) force = limiter.limit({0, 0, 50}, kTick_s);
  EXPECT_NEAR(force.z, 3, 1e-9);
  EXPECT_EQ(limiter.heat(), 0);
}

TEST(ForceLimiter, ASmallContinuousForceHasItsHeat) {
  DeviceLimits limits;
  limits.continuous_force_n = 0.5;
  ForceLimiter limiter(limits);
  for (int i = 0; i < 400; ++i) (void)limiter.limit({0, 0, 0.5}, kTick_s);
  EXPECT_GT(limiter.heat(), 0.001);
}

TEST(ForceLimiter, AMillionNewtonsIsNoForce) {
  for (const double newtons : {0.99e6, 1.01e6}) {
    ForceLimiter limiter{DeviceLimits{}};
    (void)limiter.limit({0, 0, 1}, kTick_s);
    EXPECT_EQ(limiter.limit({0, newtons, 0}, kTick_s) == Vec3(0), newtons > 1e6);
    EXPECT_EQ(limiter.ramp() == 0, newtons > 1e6);
  }
}

TEST(Passivity, TheDelayCountsInWholePeriodsFromTheHalfOn) {
  // The force that acts now was commanded that many ticks ago.
  for (const auto& [delay_s, ticks] :
       {std::pair{-0.001, 0}, {0.0, 0}, {0.0004, 0}, {0.0006, 1}, {0.0013, 1}, {0.0016, 2}, {5.0, 32}}) {
    DeviceLimits limits;
    limits.own_damping_n_s_m = 0;
    limits.delay_s = delay_s;
    Passivity passivity{limits, kTick_s};
    for (int i = 0; i < 40; ++i) {
      passivity.observe({0, 0, -1e-6}, i == 0 ? Vec3(0, 0, 1) : Vec3(0), kTick_s, 1);
      ASSERT_NEAR(passivity.energy_j(), i >= ticks ? 1e-6 : 0, 1e-18) << delay_s << ' ' << i;
    }
  }
}

TEST(Passivity, ForgetsItsDebtAndTheForcesUnderway) {
  DeviceLimits limits;
  limits.own_damping_n_s_m = 0;
  limits.delay_s = 0.002;
  Passivity passivity{limits, kTick_s};
  for (int i = 0; i < 5; ++i) passivity.observe({0, 0, 0.001}, {0, 0, 1}, kTick_s, 1);
  ASSERT_LT(passivity.energy_j(), 0);
  passivity.forget();
  EXPECT_EQ(passivity.energy_j(), 0);
  for (int i = 0; i < 2; ++i) passivity.observe({0, 0, 0.001}, {0, 0, 1}, kTick_s, 1);
  EXPECT_EQ(passivity.energy_j(), 0) << "what was commanded before no longer acts";
}

}  // namespace
}  // namespace nazori::haptics
