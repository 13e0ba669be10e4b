// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/device_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numeric>
#include <string>

namespace nazori::devices {
namespace {

using haptics::DeviceSample;

TEST(DeviceTrial, CountsTicksByHowLateTheyCame) {
  DeviceTrial trial(1000);
  double now = 0;
  const auto after = [&](double period) {
    now += period;
    (void)trial.tick({now, {0, 0, 0}, 0, true});
  };
  after(0);
  for (int i = 0; i < 96; ++i) after(0.001);
  after(0.0011);  // 0.1 ms late
  after(0.0025);  // 1.5 ms
  after(0.0075);  // 6.5 ms
  const TrialResult r = trial.result();
  EXPECT_EQ(r.ticks, 100U);
  EXPECT_NEAR(r.seconds, 0.1071, 1e-12);
  EXPECT_NEAR(r.rate_hz, 99 / 0.1071, 1e-6);
  EXPECT_EQ(r.lateness[0], 96U);
  EXPECT_EQ(r.lateness[5], 1U);  // up to 2 ms
  EXPECT_EQ(r.lateness[7], 1U);  // beyond 5 ms
  EXPECT_EQ(std::accumulate(r.lateness.begin(), r.lateness.end(), std::uint64_t{0}), 99U);
  EXPECT_NEAR(r.max_lateness_s, 0.0065, 1e-12);
}

TEST(DeviceTrial, ATickThatIsAsLateAsAnEdgeIsWithinIt) {
  for (std::size_t i = 0; i < TrialResult::kEdges_s.size(); ++i) {
    const double edge = TrialResult::kEdges_s[i];
    for (const auto& [late, bin] : {std::pair{edge, i}, {std::nextafter(edge, 1.0), i + 1}}) {
      DeviceTrial trial(1e300);  // its period is nothing
      (void)trial.tick({0, {0, 0, 0}, 0, true});
      (void)trial.tick({late, {0, 0, 0}, 0, true});
      EXPECT_EQ(trial.result().lateness[bin], 1U) << late;
      EXPECT_EQ(trial.result().max_lateness_s, late);
    }
  }
}

TEST(DeviceTrial, TheNoiseIsThatOfTheQuietestStretch) {
  DeviceTrial trial(1000);
  double now = 0;
  // A hand that moves at 0.1 m/s, then lies down: +-20 um along x, the root of the mean square is 20 um.
  for (int i = 0; i < 1000; ++i) (void)trial.tick({now += 0.001, {0.0001 * i, 0, 0}, 0, true});
  for (int i = 0; i < 1000; ++i)
    (void)trial.tick({now += 0.001, {0.1 + (i % 2 == 0 ? 20e-6 : -20e-6), 0.05, 0}, 4, true});
  EXPECT_NEAR(trial.result().rest_noise_m, 20e-6, 1e-9);
  EXPECT_EQ(trial.result().buttons_seen, 4U);
}

TEST(DeviceTrial, SmallNoiseIsMeasuredFarFromTheMiddleToo) {
  DeviceTrial trial(1000);
  // A square of a hundred-millionth of a metre: plain sums of squares would lose it.
  for (int i = 0; i < 250; ++i)
    (void)trial.tick({0.001 * i, {0.3 + (i % 2 == 0 ? 1e-8 : -1e-8), -0.4, 0.2}, 0, true});
  EXPECT_NEAR(trial.result().rest_noise_m, 1e-8, 1e-10);
}

TEST(DeviceTrial, AStylusThatIsAwayHasNoNoise) {
  DeviceTrial trial(1000);
  for (int i = 0; i < 1000; ++i) (void)trial.tick({0.001 * i, {0, 0, 0}, 0, i % 100 != 0});
  EXPECT_LT(trial.result().rest_noise_m, 0);
  EXPECT_EQ(trial.result().absent, 10U);
  EXPECT_EQ(DeviceTrial(1000).result().ticks, 0U);
}

TEST(RealTimeReadiness, SaysForEachLimitWhatToChange) {
  const auto ready = real_time_readiness(95, -1, "6.1.0", "#1 SMP PREEMPT_DYNAMIC Debian");
  EXPECT_TRUE(ready.advice.empty());
  EXPECT_TRUE(ready.kernel_preempts);
  EXPECT_TRUE(real_time_readiness(-1, 1L << 30, "6.1.0", "#1 SMP PREEMPT_RT").advice.empty());
  // The servo's thread needs priority 40, and 64 MiB are enough for its memory.
  EXPECT_TRUE(real_time_readiness(40, 64L << 20, "6.1.0", "PREEMPT").advice.empty());
  EXPECT_EQ(real_time_readiness(39, 64L << 20, "6.1.0", "PREEMPT").advice.size(), 1U);
  EXPECT_EQ(real_time_readiness(40, (64L << 20) - 1, "6.1.0", "PREEMPT").advice.size(), 1U);
  EXPECT_EQ(real_time_readiness(40, 0, "6.1.0", "#1 SMP").kernel, "6.1.0 #1 SMP");
  const auto poor = real_time_readiness(0, 8 << 20, "4.19", "#1 SMP Debian");
  ASSERT_EQ(poor.advice.size(), 3U);
  EXPECT_NE(poor.advice[0].find("rtprio"), std::string::npos);
  EXPECT_NE(poor.advice[1].find("8192 KiB"), std::string::npos);
  EXPECT_NE(poor.advice[2].find("linux-image-rt"), std::string::npos);
  // The kernel tells the same two lines in its file system.
  std::string release, version;
  std::getline(std::ifstream("/proc/sys/kernel/osrelease"), release);
  std::getline(std::ifstream("/proc/sys/kernel/version"), version);
  EXPECT_EQ(real_time_readiness().kernel, release + " " + version);
}

TEST(RealTimeReadiness, AsksForNothingThatRootOrACapabilityGives) {
  // The numbers of linux/capability.h: 14 locks memory, 23 sets priorities.
  const auto with = [](std::uint64_t capabilities) {
    return real_time_readiness(0, 8 << 20, "6.1.0", "#1 SMP PREEMPT", capabilities);
  };
  EXPECT_EQ(with(0).advice.size(), 2U);
  EXPECT_TRUE(with((1ULL << 14) | (1ULL << 23)).advice.empty());
  EXPECT_TRUE(with(0x1ffffffffffULL).advice.empty());
  ASSERT_EQ(with(1ULL << 23).advice.size(), 1U);
  EXPECT_NE(with(1ULL << 23).advice[0].find("memory"), std::string::npos);
  ASSERT_EQ(with(1ULL << 14).advice.size(), 1U);
  EXPECT_NE(with(1ULL << 14).advice[0].find("priority"), std::string::npos);
  EXPECT_EQ(with(1ULL << 23).priority_limit, -1);
  EXPECT_EQ(with(1ULL << 14).locked_bytes, -1);
}

TEST(RealTimeReadiness, CapabilitiesAreReadAsTheKernelWritesThem) {
  EXPECT_EQ(effective_capabilities("Name:\tx\nCapPrm:\tffff\nCapEff:\t0000000000804000\nCapBnd:\t1\n"),
            (1ULL << 14) | (1ULL << 23));
  EXPECT_EQ(effective_capabilities("CapEff:\t000001ffffffffff"), 0x1ffffffffffULL);
  EXPECT_EQ(effective_capabilities("CapEff:"), 0U);
  EXPECT_EQ(effective_capabilities(""), 0U);
}

}  // namespace
}  // namespace nazori::devices
