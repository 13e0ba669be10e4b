// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/slope_gain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nazori/tablet/carved_tablet.h"
#include "relief.h"

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

void expect_at(geometry::TabletPoint found, double x, double y) {
  EXPECT_NEAR(found.x, x, 1e-7);
  EXPECT_NEAR(found.y, y, 1e-7);
}

TEST(SlopeGain, OnAPlaneItIsSlowerByWhatThePlaneRisesInItsDirection) {
  const haptics::test::Relief plane(64, 0.03, [](double x, double y) { return -0.012 + 0.2 * x - 0.1 * y; });
  SlopeGain gain;
  expect_at(gain.follow({0.01, -0.02}, plane.tablet), 0.01, -0.02);
  expect_at(gain.follow({0.01, -0.02}, plane.tablet), 0.01, -0.02);
  // Up along x by 0.2, down along y by 0.1, and along (0.6, 0.8) up by 0.12 - 0.08.
  expect_at(gain.follow({0.013, -0.02}, plane.tablet), 0.01 + 0.003 / 1.2, -0.02);
  gain.reset();
  expect_at(gain.follow({0, 0}, plane.tablet), 0, 0);
  expect_at(gain.follow({0, 0.002}, plane.tablet), 0, 0.002 / 0.9);
  gain.reset();
  (void)gain.follow({0.01, 0}, plane.tablet);
  expect_at(gain.follow({0.0076, 0}, plane.tablet), 0.01 - 0.0024 / 0.8, 0);
  gain.reset();
  (void)gain.follow({0, 0}, plane.tablet);
  expect_at(gain.follow({0.0018, 0.0024}, plane.tablet), 0.0018 / 1.04, 0.0024 / 1.04);
}

TEST(SlopeGain, TheSlopeIsThatUnderTheStylusNotUnderThePointer) {
  // Level left of x = 0.02; the stylus has fallen behind the pointer before it gets there.
  const haptics::test::Relief ramp(256, 0.03, [](double x, double) {
    return x < 0 ? -0.02 + 0.2 * x : x > 0.02 ? -0.02 + 0.2 * (x - 0.02) : -0.02;
  });
  SlopeGain gain;
  (void)gain.follow({-0.02, 0.03}, ramp.tablet);
  expect_at(gain.follow({-0.008, 0.03}, ramp.tablet), -0.02 + 0.012 / 1.2, 0.03);
  expect_at(gain.follow({-0.002, 0.03}, ramp.tablet), -0.02 + 0.018 / 1.2, 0.03);
  gain.reset();
  (void)gain.follow({0.005, -0.02}, ramp.tablet);
  expect_at(gain.follow({0.008, -0.02}, ramp.tablet), 0.008, -0.02);
}

TEST(SlopeGain, StraysBySixMillimetresAtMostInItsDirection) {
  // A slope of a half: after a way of w the stylus is behind by a third of it.
  const haptics::test::Relief plane(64, 0.05, [](double x, double) { return -0.025 + 0.5 * x; });
  for (const double way : {1.0, -1.0}) {
    SlopeGain gain;
    (void)gain.follow({-0.02 * way, 0.01}, plane.tablet);
    const double g = way > 0 ? 1 / 1.5 : 2;
    for (int i = 1; i <= 60; ++i) {
      const double walked = 0.0005 * i;
      const double off = std::clamp((g - 1) * walked, -0.006, 0.006);
      expect_at(gain.follow({(-0.02 + walked) * way, 0.01}, plane.tablet), (-0.02 + walked + off) * way,
                0.01);
    }
  }
}

TEST(SlopeGain, WithoutASurfaceTheStylusIsThePointer) {
  SlopeGain gain;
  for (const double x : {0.0, 0.01, -0.02}) expect_at(gain.follow({x, 2 * x}, {}), x, 2 * x);
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
