// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/slope_gain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nazori/tablet/carved_tablet.h"

namespace nazori::devices {
namespace {

/// One level groove through the middle.
std::shared_ptr<const tablet::CarvedTablet> groove() {
  kanji::StrokeLine line;
  line.points = {{10, 54.5}, {99, 54.5}};
  return *tablet::CarvedTablet::from_lines({line}, 256);
}

TEST(SlopeGain, IsOneOnTheLevelSlowerUpFasterDownAndBounded) {
  EXPECT_EQ(SlopeGain::gain(0), 1);
  EXPECT_DOUBLE_EQ(SlopeGain::gain(1), 0.5);
  EXPECT_DOUBLE_EQ(SlopeGain::gain(-0.5), 2);
  EXPECT_EQ(SlopeGain::gain(100), 0.3);
  for (const double steep : {-0.67, -1.0, -1.5, -100.0}) EXPECT_EQ(SlopeGain::gain(steep), 3) << steep;
}

TEST(SlopeGain, OverThePlateauTheStylusIsThePointer) {
  const auto tablet = groove();
  const haptics::TabletSurface surface(*tablet->surface(), tablet->shape());
  SlopeGain gain;
  for (double x = -0.04; x < 0.04; x += 0.001) {
    const auto at = gain.follow({x, 0.04}, surface);
    EXPECT_NEAR(at.x, x, 1e-9);
    EXPECT_NEAR(at.y, 0.04, 1e-9);
  }
}

TEST(SlopeGain, LeavingAGrooveTakesALongerWayOfTheHandThanWithoutAndNeverStraysFar) {
  const auto tablet = groove();
  const haptics::TabletSurface surface(*tablet->surface(), tablet->shape());
  SlopeGain gain;
  (void)gain.follow({0, 0}, surface);
  double hand_m = 0;
  geometry::TabletPoint at{};
  while (surface.height(at.x, at.y) < -0.0005 && hand_m < 0.02) {
    hand_m += 0.0002;
    at = gain.follow({0, hand_m}, surface);
    EXPECT_LE(std::abs(at.y - hand_m), SlopeGain::kStray_m + 1e-12);
  }
  EXPECT_GT(hand_m, 1.3 * at.y);
}

}  // namespace
}  // namespace nazori::devices
