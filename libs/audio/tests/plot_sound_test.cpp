// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/plot_sound.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "with_driver.h"

namespace nazori::audio {
namespace {

functions::Sound half_a_second() {
  functions::Sound sound;
  sound.samples.assign(44'100, 0.1F);
  return sound;
}

TEST(PlotSound, WithoutASoundCardOneMessageIsGivenAndAllElseGoesOn) {
  const WithDriver none("no such driver");
  PlotSound sound;
  int failed = 0;
  sound.on_failure([&](const base::Error& error) {
    ++failed;
    EXPECT_EQ(error.code, base::Errc::device);
  });
  EXPECT_FALSE(sound.is_refused());
  sound.play(half_a_second());
  sound.sign(functions::PointKind::zero, 0);
  sound.touch({440, 0, 0, 1});
  sound.play(half_a_second());
  EXPECT_EQ(failed, 1);
  EXPECT_TRUE(sound.is_refused());
  EXPECT_FALSE(sound.is_playing());
  sound.stop();
}

TEST(PlotSound, ASweepPlaysToItsEnd) {
  const WithDriver dummy("dummy");
  PlotSound sound;
  EXPECT_FALSE(sound.is_open());
  sound.play(half_a_second());
  EXPECT_TRUE(sound.is_open());
  EXPECT_TRUE(sound.is_playing());
  for (int waited = 0; sound.is_playing() && waited < 2000; ++waited)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(sound.is_playing());
}

TEST(PlotSound, StopEndsASweepAtOnce) {
  const WithDriver dummy("dummy");
  PlotSound sound;
  functions::Sound minute;
  minute.samples.assign(60 * 2 * 44'100, 0.1F);
  sound.play(minute);
  sound.play(minute);
  EXPECT_TRUE(sound.is_playing());
  sound.stop();
  EXPECT_FALSE(sound.is_playing());
}

TEST(PlotSound, MutedOrSilentItDoesNotEvenAskForASoundCard) {
  const WithDriver none("no such driver");
  PlotSound sound;
  int failed = 0;
  sound.on_failure([&](const base::Error&) { ++failed; });
  sound.touch({});
  sound.set_muted(true);
  EXPECT_TRUE(sound.muted());
  sound.play(half_a_second());
  sound.touch({440, 0, 0, 1});
  EXPECT_EQ(failed, 0);
  EXPECT_FALSE(sound.is_playing());
  EXPECT_FALSE(sound.is_refused());
}

TEST(PlotSound, TheVolumeIsHeldBetweenNothingAndAll) {
  PlotSound sound;
  EXPECT_EQ(sound.volume(), 50);
  sound.set_volume(120);
  EXPECT_EQ(sound.volume(), 100);
  sound.set_volume(-1);
  EXPECT_EQ(sound.volume(), 0);
}

}  // namespace
}  // namespace nazori::audio
