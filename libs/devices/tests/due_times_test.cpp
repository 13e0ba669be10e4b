// SPDX-License-Identifier: Apache-2.0
#include "../src/due_times.h"

#include <gtest/gtest.h>

namespace nazori::devices {
namespace {

TEST(DueTimes, AreNotFoldedIntoOnePeriod) {
  // A clock of 1 kHz as in RtThread: tick 1 comes on time, tick 2 is 5.3 ms late, tick 3 follows.
  DueTimes due(0.001);
  EXPECT_EQ(due.lateness_s(0), 0);
  due.ended(0.00001);
  EXPECT_NEAR(due.lateness_s(0.0012), 0.0002, 1e-12);
  due.ended(0.00121);
  EXPECT_NEAR(due.lateness_s(0.0073), 0.0053, 1e-12);
  due.ended(0.00731);  // 3, 4, 5 and 6 ms are skipped, 7 is due at once
  EXPECT_NEAR(due.lateness_s(0.00731), 0.00031, 1e-12);
  due.ended(0.0074);
  EXPECT_NEAR(due.lateness_s(0.008), 0, 1e-12);
  // A tick that takes long itself delays the next.
  due.ended(0.0108);
  EXPECT_NEAR(due.lateness_s(0.0108), 0.0008, 1e-12);
  due.ended(0.0109);
  EXPECT_EQ(due.lateness_s(0.01099), 0);  // clocks differ by some nanoseconds: never negative
}

}  // namespace
}  // namespace nazori::devices
