// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/stroke_sound.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "with_driver.h"

namespace nazori::audio {
namespace {

haptics::ServoSample at(double time_s, haptics::Vec3 proxy_m, double deeper_m = 0.0075) {
  haptics::ServoSample made;
  made.time_s = time_s;
  made.proxy_m = proxy_m;
  made.device_m = proxy_m - haptics::Vec3(0, 0, deeper_m);
  made.touching = true;
  return made;
}

haptics::ServoSample lifted(haptics::ServoSample sample) {
  sample.touching = false;
  return sample;
}

TEST(GrooveMotion, KnowsSpeedPressureAndWhetherTheStylusIsInAGroove) {
  const geometry::TabletShape shape;
  const auto in = groove_motion(at(1, {0, 0, -0.01}, 0.0075), at(1.01, {0.001, 0, -0.01}, 0.0075), shape);
  EXPECT_NEAR(in.speed_m_s, 0.1, 1e-6);
  EXPECT_NEAR(in.pressure, 0.5, 1e-6);
  EXPECT_TRUE(in.on_stroke);
  EXPECT_NEAR(in.pan, 0.02, 1e-6);
  const auto beside = groove_motion(at(1, {0, 0, 0}, 0.001), at(1.01, {0.001, 0, 0}, 0.001), shape);
  EXPECT_FALSE(beside.on_stroke);
  const auto in_the_air = groove_motion(lifted(at(1, {0, 0, 0}, 0)), at(1.01, {0.001, 0, 0}, 0), shape);
  EXPECT_EQ(in_the_air.speed_m_s, 0);
  EXPECT_EQ(in_the_air.pressure, 0);
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
  for (const auto& motion :
       {groove_motion(before, lifted(now), {}), groove_motion(lifted(before), now, {}),
        groove_motion(before, at(1, {0.01, 0, 0}), {}), groove_motion(now, before, {})}) {
    EXPECT_EQ(motion.speed_m_s, 0);
    EXPECT_EQ(motion.pressure, 0);
  }
}

TEST(StrokeSound, WithoutASoundCardItIsSaidOnce) {
  const WithDriver none("no such driver");
  StrokeSound sound;
  EXPECT_FALSE(sound.is_on());
  int failed = 0;
  sound.on_failure([&](const base::Error&) { ++failed; });
  sound.set_on(true);
  EXPECT_TRUE(sound.is_on());
  EXPECT_EQ(failed, 1);
  sound.set_on(false);
  EXPECT_FALSE(sound.is_on());
  sound.set_on(true);
  EXPECT_EQ(failed, 1);
  const std::vector some{at(1, {0, 0, 0})};
  sound.follow(some, {});
  const WithDriver dummy("dummy");
  sound.set_on(true);
  sound.follow({}, {});
  sound.follow(some, {});
  EXPECT_EQ(failed, 1);
  sound.set_on(false);
}

}  // namespace
}  // namespace nazori::audio
