// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/clock.h"

#include <gtest/gtest.h>

namespace nazori::base {
namespace {

using std::chrono::milliseconds;

TEST(ManualClock, StandsStillUntilItIsTurnedAndThenTurnsBothTimes) {
  ManualClock clock(Clock::Calendar{milliseconds{1000}});
  const auto began = clock.steady();
  EXPECT_EQ(clock.calendar(), Clock::Calendar{milliseconds{1000}});
  clock.advance(milliseconds{250});
  EXPECT_EQ(clock.calendar(), Clock::Calendar{milliseconds{1250}});
  EXPECT_EQ(clock.steady() - began, milliseconds{250});
}

TEST(ManualClock, SettingTheCalendarLeavesTheSteadyTime) {
  ManualClock clock(Clock::Calendar{milliseconds{1000}});
  const auto began = clock.steady();
  clock.set_calendar(Clock::Calendar{milliseconds{10}});
  EXPECT_EQ(clock.calendar(), Clock::Calendar{milliseconds{10}});
  EXPECT_EQ(clock.steady(), began);
}

TEST(SystemClock, ShowsTheTimesOfTheComputer) {
  const SystemClock clock;
  const auto calendar_before = std::chrono::floor<milliseconds>(std::chrono::system_clock::now());
  const auto steady_before = std::chrono::steady_clock::now();
  const auto calendar = clock.calendar();
  const auto steady = clock.steady();
  EXPECT_GE(calendar, calendar_before);
  EXPECT_LE(calendar, std::chrono::system_clock::now());
  EXPECT_GE(steady, steady_before);
  EXPECT_LE(steady, std::chrono::steady_clock::now());
}

}  // namespace
}  // namespace nazori::base
