// SPDX-License-Identifier: Apache-2.0
#include "slope_gain.h"

#include <gtest/gtest.h>

#include <QtGlobal>
#include <cmath>

#include "nazori/tablet/carved_tablet.h"
#include "stroke_sound.h"

namespace nazori::ui {
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

haptics::ServoSample sample(double time_s, haptics::Vec3 proxy_m, double below_m, bool touching = true) {
  haptics::ServoSample s;
  s.time_s = time_s;
  s.proxy_m = proxy_m;
  s.device_m = proxy_m - haptics::Vec3(0, 0, below_m);
  s.touching = touching;
  return s;
}

TEST(GrooveMotion, KnowsSpeedPressureAndWhetherTheStylusIsInAGroove) {
  const geometry::TabletShape shape;
  const auto in =
      groove_motion(sample(1, {0, 0, -0.01}, 0.0075), sample(1.01, {0.001, 0, -0.01}, 0.0075), shape);
  EXPECT_NEAR(in.speed_m_s, 0.1, 1e-6);
  EXPECT_NEAR(in.pressure, 0.5, 1e-6);
  EXPECT_TRUE(in.on_stroke);
  EXPECT_NEAR(in.pan, 0.02, 1e-6);
  const auto beside = groove_motion(sample(1, {0, 0, 0}, 0.001), sample(1.01, {0.001, 0, 0}, 0.001), shape);
  EXPECT_FALSE(beside.on_stroke);
  const auto lifted = groove_motion(sample(1, {0, 0, 0}, 0, false), sample(1.01, {0.001, 0, 0}, 0), shape);
  EXPECT_EQ(lifted.speed_m_s, 0);
  EXPECT_EQ(lifted.pressure, 0);
}

TEST(StrokeSound, WithoutASoundCardItSaysSoOnceAndNothingElseHappens) {
  qputenv("SDL_AUDIODRIVER", "no-such-driver");
  StrokeSound sound;
  int told = 0;
  QObject::connect(&sound, &StrokeSound::failed, [&told](const base::Error&) { ++told; });
  sound.set_on(true);
  sound.set_on(false);
  sound.set_on(true);
  const auto s = sample(1, {0, 0, 0}, 0.001);
  sound.follow({&s, 1}, {});
  EXPECT_EQ(told, 1);
  qputenv("SDL_AUDIODRIVER", "dummy");
  StrokeSound heard;
  heard.set_on(true);
  heard.follow({&s, 1}, {});
}

}  // namespace
}  // namespace nazori::ui
