// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "nazori/devices/simulated_hand.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::devices {
namespace {

TEST(SimulatedHandTimes, ATickTakesSomeTimeAndWithoutAClockNoneIsLate) {
  const auto tablet =
      *tablet::CarvedTablet::from_lines({{{{40, 50}, {70, 50}}, kanji::StrokeEnding::stop, {}}}, 128);
  const std::vector scenes{tablet->scene({}, {}), tablet->scene({}, {})};
  SimulatedHand hand(tablet->paths(), scenes, SimulatedHardware::touch());
  ASSERT_TRUE(hand.run(HandClock::none, {}));
  const HandReport report = hand.report();
  // Measured around the servo's tick, which measures itself; a bin is 2 % wide.
  EXPECT_GT(report.p999_tick_s, 0.9 * report.timing.mean_tick_s);
  // The first bin ends a little over a nanosecond.
  EXPECT_GT(report.p999_lateness_s, 0);
  EXPECT_LT(report.p999_lateness_s, 1e-8);
  EXPECT_EQ(report.clock.ticks, 0U);
}

}  // namespace
}  // namespace nazori::devices
