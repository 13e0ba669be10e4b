// SPDX-License-Identifier: Apache-2.0
#include "../src/tick_durations.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nazori::devices {
namespace {

const double kBin = std::exp2(1.0 / 32);  // the times of one bin differ by no more than this factor

TEST(TickDurations, AQuantileIsThatOfTheTimesWithinABin) {
  TickDurations times;
  for (int i = 0; i < 998; ++i) times.add(1e-5);
  times.add(2e-4);
  times.add(3e-2);
  const auto expect_bound = [&](double share, double seconds) {
    EXPECT_GE(times.quantile_s(share), seconds * (1 - 1e-12)) << share;
    EXPECT_LE(times.quantile_s(share), seconds * kBin * (1 + 1e-12)) << share;
  };
  expect_bound(0.5, 1e-5);
  expect_bound(0.998, 1e-5);
  expect_bound(0.9981, 2e-4);
  expect_bound(0.999, 2e-4);
  expect_bound(0.9991, 3e-2);
  expect_bound(1, 3e-2);
}

TEST(TickDurations, EveryTimeFromANanosecondToFourSecondsHasItsBin) {
  for (double seconds = 1e-9; seconds < 4; seconds *= 1.3) {
    TickDurations one;
    one.add(seconds);
    EXPECT_GE(one.quantile_s(0.999), seconds * (1 - 1e-9)) << seconds;
    EXPECT_LE(one.quantile_s(0.999), seconds * kBin * (1 + 1e-9)) << seconds;
  }
}

TEST(TickDurations, WhatIsShorterOrLongerCountsInTheFirstOrLastBin) {
  TickDurations extremes;
  EXPECT_EQ(extremes.quantile_s(0.5), 0) << "no time yet";
  extremes.add(0);
  extremes.add(1e-12);
  EXPECT_DOUBLE_EQ(extremes.quantile_s(1), 1e-9 * kBin);
  for (int i = 0; i < 3; ++i) extremes.add(1e9);
  EXPECT_DOUBLE_EQ(extremes.quantile_s(1), 1e-9 * std::exp2(32));
}

}  // namespace
}  // namespace nazori::devices
