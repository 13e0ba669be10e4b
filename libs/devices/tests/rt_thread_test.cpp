// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/rt_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace nazori::devices {
namespace {

using std::chrono::milliseconds;

TEST(RtThread, CallsUntilItIsStoppedAndNotAfterwards) {
  RtThread thread;
  std::atomic<int> calls{0};
  ASSERT_TRUE(thread.start(0.001, [&](double) { ++calls; }));
  while (calls < 5) std::this_thread::sleep_for(milliseconds(1));
  thread.stop();
  const int at_stop = calls;
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_EQ(calls, at_stop);
  EXPECT_EQ(thread.status().ticks, static_cast<std::uint64_t>(at_stop));
  EXPECT_FALSE(thread.status().running);
}

TEST(RtThread, TimeOnlyGoesForwardAndNoPeriodIsLostUncounted) {
  RtThread thread;
  std::atomic<double> first{-1}, last{-1};
  std::atomic<bool> backwards{false};
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(thread.start(0.001, [&](double now_s) {
    if (first < 0) first = now_s;
    if (now_s < last) backwards = true;
    last = now_s;
  }));
  while (thread.status().ticks < 150) std::this_thread::sleep_for(milliseconds(1));
  const ClockStatus running = thread.status();
  EXPECT_TRUE(running.running);
  EXPECT_NE(running.real_time, !running.message.empty());
  thread.stop();
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_FALSE(backwards);
  const ClockStatus s = thread.status();
  const double periods = static_cast<double>(s.ticks + s.missed);
  // Up to the last tick all are counted, and none that was not.
  EXPECT_GE(periods, (last - s.max_lateness_s) / 0.001);
  EXPECT_LE(periods, elapsed_s / 0.001 + 1);
}

TEST(RtThread, CountsThePeriodsThatASlowTickSwallowed) {
  RtThread thread;
  std::atomic<int> calls{0};
  ASSERT_TRUE(thread.start(0.001, [&](double) {
    if (calls++ == 0) std::this_thread::sleep_for(milliseconds(30));
  }));
  while (calls < 3) std::this_thread::sleep_for(milliseconds(1));
  thread.stop();
  EXPECT_GE(thread.status().missed, 28U);
}

TEST(RtThread, RefusesAbsurdPeriodsAndASecondStart) {
  RtThread thread;
  const auto nothing = [](double) {};
  EXPECT_EQ(thread.start(0, nothing).error().code, base::Errc::bad_argument);
  EXPECT_EQ(thread.start(5, nothing).error().code, base::Errc::bad_argument);
  ASSERT_TRUE(thread.start(0.001, nothing));
  EXPECT_EQ(thread.start(0.001, nothing).error().code, base::Errc::device);
  thread.stop();
  EXPECT_TRUE(thread.start(0.001, nothing));
}

}  // namespace
}  // namespace nazori::devices
