// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/groove_sound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace {

using nazori::audio::GrooveMotion;
using nazori::audio::GrooveSound;

constexpr int kRate_hz = 44'100;

/// Half a second of sound after the glides are over.
std::vector<float> heard(GrooveSound& sound, const GrooveMotion& motion) {
  sound.set(motion);
  std::vector<float> stereo(kRate_hz / 2, 0.0F);
  sound.add_to(stereo);
  std::vector<float> steady(static_cast<std::size_t>(kRate_hz), 0.0F);
  sound.add_to(steady);
  return steady;
}

double loudness(const std::vector<float>& stereo, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = channel; i < stereo.size(); i += 2) sum += static_cast<double>(stereo[i]) * stereo[i];
  return std::sqrt(sum / (static_cast<double>(stereo.size()) / 2));
}
double loudness(const std::vector<float>& stereo) {
  return std::hypot(loudness(stereo, 0), loudness(stereo, 1));
}

/// Mean of the frequencies, each weighed with its power: of the left channel, from the mean square of its
/// slope.
double brightness_hz(const std::vector<float>& stereo) {
  double power = 0, slope = 0;
  for (std::size_t i = 2; i < stereo.size(); i += 2) {
    const double step = static_cast<double>(stereo[i]) - stereo[i - 2];
    power += static_cast<double>(stereo[i]) * stereo[i];
    slope += step * step;
  }
  return std::sqrt(slope / power) * kRate_hz / (2 * std::numbers::pi);
}

/// Share of the left channel's power at one frequency (Goertzel).
double share_at(const std::vector<float>& stereo, double hz) {
  double re = 0, im = 0, power = 0;
  std::size_t n = 0;
  for (std::size_t i = 0; i < stereo.size(); i += 2, ++n) {
    const double angle = 2 * std::numbers::pi * hz * static_cast<double>(n) / kRate_hz;
    re += stereo[i] * std::cos(angle);
    im += stereo[i] * std::sin(angle);
    power += static_cast<double>(stereo[i]) * stereo[i];
  }
  return 2 * (re * re + im * im) / (static_cast<double>(n) * power);
}

TEST(GrooveSound, IsSilentAtRestAndLifted) {
  GrooveSound sound;
  EXPECT_EQ(loudness(heard(sound, {})), 0);
  EXPECT_EQ(loudness(heard(sound, {0, 1, true, 0})), 0);
  EXPECT_EQ(loudness(heard(sound, {0.2F, 0, false, 0})), 0);
  (void)heard(sound, {0.2F, 1, true, 0});
  EXPECT_LT(loudness(heard(sound, {})), 1e-4) << "and again after it was heard";
}

TEST(GrooveSound, GrowsLouderWithSpeedAndWithPressure) {
  GrooveSound sound;
  double before = 0;
  for (const float speed : {0.01F, 0.04F, 0.1F, 0.3F}) {
    const double now = loudness(heard(sound, {speed, 0.8F, true, 0}));
    EXPECT_GT(now, before * 1.2) << speed;
    before = now;
  }
  before = 0;
  for (const float pressure : {0.1F, 0.3F, 1.0F}) {
    const double now = loudness(heard(sound, {0.1F, pressure, true, 0}));
    EXPECT_GT(now, before * 1.2) << pressure;
    before = now;
  }
}

TEST(GrooveSound, GrowsBrighterWithSpeed) {
  GrooveSound sound;
  const double slow = brightness_hz(heard(sound, {0.02F, 1, true, 0}));
  const double fast = brightness_hz(heard(sound, {0.3F, 1, true, 0}));
  EXPECT_GT(fast, 2 * slow);
}

TEST(GrooveSound, BesideTheStrokeALowToneIsHeardThatTheScratchHasNot) {
  GrooveSound sound;
  EXPECT_LT(share_at(heard(sound, {0.1F, 1, true, 0}), 110), 0.01);
  EXPECT_GT(share_at(heard(sound, {0.1F, 1, false, 0}), 110), 0.2);
}

TEST(GrooveSound, StandsWhereTheStylusIs) {
  GrooveSound sound;
  const auto left = heard(sound, {0.2F, 1, true, -1});
  EXPECT_GT(loudness(left, 0), 20 * loudness(left, 1));
  const auto right = heard(sound, {0.2F, 1, true, 1});
  EXPECT_GT(loudness(right, 1), 20 * loudness(right, 0));
}

TEST(GrooveSound, NeverLeavesTheRangeOfTheLoudspeakersWhateverItIsTold) {
  GrooveSound sound;
  sound.set_volume(1);
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  for (const GrooveMotion& motion : {GrooveMotion{1e9F, 1e9F, true, 1e9F}, GrooveMotion{1e9F, 1e9F, false, 0},
                                     GrooveMotion{kNan, kInfinite, false, kNan}}) {
    for (const float sample : heard(sound, motion)) {
      ASSERT_TRUE(std::isfinite(sample));
      ASSERT_LE(std::abs(sample), 1.6F);
    }
  }
}

TEST(GrooveSound, ChangesGlideSoThatNothingClicks) {
  GrooveSound sound;
  sound.set_volume(1);
  std::vector<float> stereo(2, 0.0F);
  sound.set({0.3F, 1, true, 0});
  sound.add_to(stereo);
  EXPECT_LT(std::abs(stereo[0]), 0.01F) << "the first sample after silence";
}

TEST(GrooveSound, MutedItIsSilentAndKeepsItsVolume) {
  GrooveSound sound;
  const double before = loudness(heard(sound, {0.2F, 1, true, 0}));
  sound.set_muted(true);
  EXPECT_LT(loudness(heard(sound, {0.2F, 1, true, 0})), 1e-4);
  sound.set_muted(false);
  EXPECT_NEAR(loudness(heard(sound, {0.2F, 1, true, 0})), before, before * 0.1);
}

}  // namespace
