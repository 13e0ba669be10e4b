// SPDX-License-Identifier: Apache-2.0
#include "stroke_sound.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

namespace nazori::ui {
namespace {

haptics::ServoSample at(double time_s, haptics::Vec3 proxy_m, double deeper_m = 0.0075) {
  haptics::ServoSample made;
  made.time_s = time_s;
  made.proxy_m = proxy_m;
  made.device_m = proxy_m - haptics::Vec3(0, 0, deeper_m);
  made.touching = true;
  return made;
}

TEST(GrooveMotion, SpeedIsTheWayByItsTime) {
  const auto motion = groove_motion(at(1, {0.01, 0, 0}), at(1.5, {0.04, 0.04, 0}), {});
  EXPECT_FLOAT_EQ(motion.speed_m_s, 0.1F);
}

TEST(GrooveMotion, PressureIsTheDepthOfTheHandAndNeverQuiteNothing) {
  const auto pressure = [](double deeper_m) {
    return groove_motion(at(0, {0, 0, 0}), at(1, {0.01, 0.02, 0}, deeper_m), {}).pressure;
  };
  EXPECT_FLOAT_EQ(pressure(0), 0.05F);
  EXPECT_FLOAT_EQ(pressure(0.0075), 0.5F) << "half of what the hardest press of a pen is";
  EXPECT_FLOAT_EQ(pressure(0.03), 1);
}

TEST(GrooveMotion, AStrokeIsWhereTheSurfaceLiesATenthOfTheDepthLower) {
  const geometry::TabletShape shape;
  const auto on_stroke = [&](double depth) {
    return groove_motion(at(0, {0, 0, 0}), at(1, {0, 0, -depth * shape.depth_m}), shape).on_stroke;
  };
  EXPECT_FALSE(on_stroke(0.09));
  EXPECT_TRUE(on_stroke(0.11));
}

TEST(GrooveMotion, IsHeardOnItsSide) {
  const geometry::TabletShape shape;
  const auto pan = [&](double x_m) { return groove_motion(at(0, {0, 0, 0}), at(1, {x_m, 0, 0}), shape).pan; };
  EXPECT_FLOAT_EQ(pan(0), 0);
  EXPECT_FLOAT_EQ(pan(shape.width_m / 4), 0.5F);
  EXPECT_FLOAT_EQ(pan(-shape.width_m / 2), -1);
  EXPECT_FLOAT_EQ(pan(-shape.width_m), -1);
  EXPECT_FLOAT_EQ(pan(shape.width_m), 1);
}

TEST(GrooveMotion, WithoutATouchOrTimeThereIsNone) {
  const auto before = at(1, {0, 0, 0});
  const auto now = at(2, {0.01, 0, 0});
  auto lifted = now;
  lifted.touching = false;
  auto lifted_before = before;
  lifted_before.touching = false;
  for (const auto& motion :
       {groove_motion(before, lifted, {}), groove_motion(lifted_before, now, {}),
        groove_motion(before, at(1, {0.01, 0, 0}), {}), groove_motion(now, before, {})}) {
    EXPECT_EQ(motion.speed_m_s, 0);
    EXPECT_EQ(motion.pressure, 0);
  }
}

TEST(StrokeSound, WithoutASoundCardItIsSaidOnce) {
  const QByteArray before = qgetenv("SDL_AUDIODRIVER");
  qputenv("SDL_AUDIODRIVER", "no such driver");
  StrokeSound sound;
  EXPECT_FALSE(sound.is_on());
  const QSignalSpy failed(&sound, &StrokeSound::failed);
  sound.set_on(true);
  EXPECT_TRUE(sound.is_on());
  EXPECT_EQ(failed.count(), 1);
  sound.set_on(false);
  EXPECT_FALSE(sound.is_on());
  sound.set_on(true);
  EXPECT_EQ(failed.count(), 1);
  const std::vector some{at(1, {0, 0, 0})};
  sound.follow(some, {});
  qputenv("SDL_AUDIODRIVER", "dummy");
  sound.set_on(true);
  sound.follow({}, {});
  sound.follow(some, {});
  EXPECT_EQ(failed.count(), 1);
  sound.set_on(false);
  before.isNull() ? qunsetenv("SDL_AUDIODRIVER") : qputenv("SDL_AUDIODRIVER", before);
}

}  // namespace
}  // namespace nazori::ui
