// SPDX-License-Identifier: Apache-2.0
#include "../src/disturbance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>

namespace nazori::haptics {
namespace {

/// splitmix64 as its author published it, by number of the output.
std::uint64_t splitmix64(std::uint64_t seed, std::uint64_t n) {
  std::uint64_t z = seed + n * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

double random_unit(std::uint64_t seed, std::uint64_t n) {
  return static_cast<double>(splitmix64(seed, n) >> 11U) * 0x1p-53;
}

TEST(Disturbance, TheRandomNumbersOfThisTestAreThePublishedOnes) {
  EXPECT_EQ(splitmix64(1234567, 1), 6457827717110365317U);
  EXPECT_EQ(splitmix64(1234567, 2), 3203168211198807973U);
  EXPECT_EQ(splitmix64(1234567, 3), 9817491932198370423U);
}

TEST(Disturbance, IsFourSinesForEachAxisOneInEachQuarterOfItsBand) {
  constexpr double kPeriod_s = 0.002;
  for (const std::uint64_t seed : {1U, 42U}) {
    Disturbance disturbance(seed, kPeriod_s);
    for (int tick = 0; tick < 5000; ++tick) {
      double expected[2] = {0, 0};
      std::uint64_t n = 0;
      for (double& axis : expected)
        for (int tone = 0; tone < 4; ++tone) {
          const double hz = 0.4 + (3.0 - 0.4) * (tone + random_unit(seed, n + 1)) / 4;
          const double phase = 2 * std::numbers::pi * random_unit(seed, n + 2);
          n += 2;
          axis += std::sqrt(0.5) / 4 * std::sin(phase + 2 * std::numbers::pi * hz * kPeriod_s * tick);
        }
      ASSERT_NEAR(disturbance.value().x, expected[0], 1e-9) << tick;
      ASSERT_NEAR(disturbance.value().y, expected[1], 1e-9) << tick;
      ASSERT_EQ(disturbance.value().z, 0);
      disturbance.advance();
    }
  }
}

TEST(Disturbance, KeepsItsSizeOverHours) {
  Disturbance disturbance(3, 0.001);
  double most = 0;
  for (int tick = 0; tick < 2'000'000; ++tick) {
    disturbance.advance();
    if (tick >= 1'980'000) most = std::max(most, glm::length(disturbance.value()));
  }
  EXPECT_GT(most, 0.3);
  EXPECT_LE(most, 1);
}

TEST(Disturbance, WithoutASeedThereIsNone) {
  Disturbance none;
  for (int i = 0; i < 100; ++i) {
    none.advance();
    EXPECT_EQ(none.value(), Vec3(0));
  }
}

}  // namespace
}  // namespace nazori::haptics
