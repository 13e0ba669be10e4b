// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/groove_sound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace {

using nazori::audio::GrooveMotion;
using nazori::audio::GrooveSound;

constexpr int kRate_hz = 44'100;

/// Half a second of sound after all changes have finished.
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

TEST(GrooveSound, AVolumeThatIsNotSetIsOneHalf) {
  GrooveSound plain;
  GrooveSound half;
  half.set_volume(0.5F);
  EXPECT_EQ(heard(plain, {0.2F, 1, false, 0}), heard(half, {0.2F, 1, false, 0}));
}

TEST(GrooveSound, AVolumeOutOfRangeIsTheNearestOneInItAndNoNumberIsSilence) {
  const auto at_volume = [](float volume) {
    GrooveSound sound;
    sound.set_volume(volume);
    return loudness(heard(sound, {0.2F, 1, true, 0}));
  };
  EXPECT_EQ(at_volume(3), at_volume(1));
  EXPECT_NEAR(at_volume(1), 2 * at_volume(0.5F), 1e-6);
  EXPECT_EQ(at_volume(-1), 0);
  EXPECT_EQ(at_volume(std::numeric_limits<float>::quiet_NaN()), 0);
}

/// Sum of the powers of the left channel at the frequencies of a band, a hertz apart.
double band_power(const std::vector<float>& stereo, int from_hz, int to_hz) {
  const double frames = static_cast<double>(stereo.size()) / 2;
  double power = 0;
  for (int hz = from_hz; hz < to_hz; ++hz) {
    const double step = 2 * std::numbers::pi * hz / kRate_hz;
    double re = 0, im = 0, c = 1, s = 0;
    for (std::size_t i = 0; i < stereo.size(); i += 2) {
      re += stereo[i] * c;
      im += stereo[i] * s;
      const double next = c * std::cos(step) - s * std::sin(step);
      s = s * std::cos(step) + c * std::sin(step);
      c = next;
    }
    power += (re * re + im * im) / (frames * frames);
  }
  return power;
}

/// What two low passes at `cutoff_hz` and a high pass leave of white noise in a band, from their responses.
double expected_power(double cutoff_hz, double rumble_hz, double gain, double frames, int from_hz,
                      int to_hz) {
  const double a = 1 - std::exp(-2 * std::numbers::pi * cutoff_hz / kRate_hz);
  const double h = 1 - std::exp(-2 * std::numbers::pi * rumble_hz / kRate_hz);
  double power = 0;
  for (int hz = from_hz; hz < to_hz; ++hz) {
    const double w = std::cos(2 * std::numbers::pi * hz / kRate_hz);
    const double low = a * a / (1 - 2 * (1 - a) * w + (1 - a) * (1 - a));
    const double high =
        rumble_hz > 0 ? (1 - h) * (1 - h) * (2 - 2 * w) / (1 - 2 * (1 - h) * w + (1 - h) * (1 - h)) : 1;
    // A third is the power of numbers spread evenly over -1..1, shared by as many frequencies as frames.
    power += low * low * high / 3 / frames;
  }
  return power * gain * gain / a;
}

TEST(GrooveSound, AScratchIsNoiseBetweenTheRumbleAndItsBrightness) {
  // At the full speed up to 6,000 Hz, at a quarter of it a decade's half lower: 600 * sqrt(10).
  for (const auto& [speed, cutoff_hz] : {std::pair{0.3F, 6'000.0}, std::pair{0.075F, 1'897.4}}) {
    GrooveSound sound;
    sound.set_volume(1);
    const float pressure = 0.5F;
    std::vector<float> steady = heard(sound, {speed, pressure, true, -1});
    std::vector<float> more(2 * static_cast<std::size_t>(2 * kRate_hz), 0.0F);
    sound.add_to(more);
    const double gain = 0.6 * std::sqrt(speed / 0.3 * pressure);
    for (const auto& [from, to] : {std::pair{60, 160}, std::pair{500, 700}, std::pair{3'000, 3'400}}) {
      const double wanted = expected_power(cutoff_hz, 150, gain, 2 * kRate_hz, from, to);
      EXPECT_NEAR(band_power(more, from, to) / wanted, 1, 0.16) << speed << " m/s, " << from << " Hz";
    }
  }
}

TEST(GrooveSound, BesideTheStrokeTheNoiseIsDullAndHalfAsStrong) {
  GrooveSound sound;
  sound.set_volume(1);
  (void)heard(sound, {0.3F, 1, false, -1});
  std::vector<float> more(4 * static_cast<std::size_t>(kRate_hz), 0.0F);
  sound.add_to(more);
  // Between the tones of 110, 220 and 330 Hz, and above them.
  for (const auto& [from, to] : {std::pair{10, 100}, std::pair{120, 210}, std::pair{500, 700}}) {
    const double wanted = expected_power(0.35 * 600, 0, 0.6 * 0.5, 2 * kRate_hz, from, to);
    EXPECT_NEAR(band_power(more, from, to) / wanted, 1, 0.25) << from;
  }
}

TEST(GrooveSound, BesideTheStrokeTheToneHasThreePartials) {
  GrooveSound sound;
  sound.set_volume(1);
  (void)heard(sound, {0.3F, 1, false, -1});
  std::vector<float> more(4 * static_cast<std::size_t>(kRate_hz), 0.0F);
  sound.add_to(more);
  // Whole periods: the power at one frequency is a quarter of the square of the amplitude.
  for (const auto& [hz, amplitude] :
       {std::pair{110, 0.35}, std::pair{220, 0.35 * 0.5}, std::pair{330, 0.35 * 0.33}})
    EXPECT_NEAR(2 * std::sqrt(band_power(more, hz, hz + 1)), amplitude, 0.012) << hz;
}

TEST(GrooveSound, FasterThanBriskWritingIsNoLouderAndBackwardsIsAsLoud) {
  const auto steady = [](float speed, float pressure) {
    GrooveSound sound;
    return heard(sound, {speed, pressure, true, 0});
  };
  EXPECT_EQ(steady(0.9F, 1), steady(0.3F, 1));
  EXPECT_EQ(steady(-0.2F, 1), steady(0.2F, 1));
  EXPECT_EQ(steady(0.2F, 2), steady(0.2F, 1));
  EXPECT_LT(loudness(steady(0.25F, 1)), 0.95 * loudness(steady(0.3F, 1)));
  EXPECT_EQ(loudness(steady(0.2F, -1)), 0);
}

TEST(GrooveSound, APressureOrPlaceThatIsNoNumberCountsAsNothing) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  GrooveSound sound, middle;
  EXPECT_EQ(heard(sound, {0.2F, 1, true, kNan}), heard(middle, {0.2F, 1, true, 0}));
  EXPECT_LT(loudness(heard(sound, {0.2F, kNan, true, 0})), 1e-4);
  EXPECT_LT(loudness(heard(sound, {kNan, 1, true, 0})), 1e-4);
}

TEST(GrooveSound, TheTwoSidesHaveOnePowerTogetherWhereverTheStylusIs) {
  for (const float pan : {-1.0F, -0.5F, 0.0F, 0.25F, 1.0F}) {
    GrooveSound sound, left;
    const auto there = heard(sound, {0.2F, 1, true, pan});
    const auto all = heard(left, {0.2F, 1, true, -1});
    EXPECT_NEAR(loudness(there, 1) * loudness(there, 1) / (loudness(there) * loudness(there)), (1 + pan) / 2,
                1e-3);
    EXPECT_NEAR(loudness(there), loudness(all), 1e-3 * loudness(all));
  }
}

TEST(GrooveSound, LoudnessAndPlaceGlideWithATimeOfTwentyMilliseconds) {
  // The same noise in both: their quotient is the change alone.
  GrooveSound steady, later;
  const GrooveMotion motion{0.2F, 1, true, -1};
  later.set_muted(true);
  (void)heard(steady, motion);
  (void)heard(later, motion);
  later.set_muted(false);
  std::vector<float> a(8'820, 0.0F), b(8'820, 0.0F);
  steady.add_to(a);
  later.add_to(b);
  for (const std::size_t frame : {440U, 882U, 2'000U}) {
    const double part = 1 - std::exp(-static_cast<double>(frame + 1) / (0.02 * kRate_hz));
    EXPECT_NEAR(b[2 * frame] / a[2 * frame], part, 1e-3) << frame;
  }
  steady.set({0.2F, 1, true, 1});
  std::fill(a.begin(), a.end(), 0.0F);
  steady.add_to(a);
  for (const std::size_t frame : {440U, 882U, 2'000U}) {
    const double part = 1 - std::exp(-static_cast<double>(frame + 1) / (0.02 * kRate_hz));
    const double left = a[2 * frame], right = a[2 * frame + 1];
    EXPECT_NEAR(right * right / (left * left + right * right), part, 1e-3) << frame;
  }
}

TEST(GrooveSound, AddsToWhatIsThereAndLeavesASampleWithoutAPartner) {
  GrooveSound alone, added;
  alone.set({0.2F, 1, true, 0});
  added.set({0.2F, 1, true, 0});
  std::vector<float> a(101, 0.0F), b(101, 0.25F);
  alone.add_to(a);
  added.add_to(b);
  for (std::size_t i = 0; i < 100; ++i) ASSERT_FLOAT_EQ(b[i], a[i] + 0.25F);
  EXPECT_NE(a[98], 0.0F);
  EXPECT_EQ(b[100], 0.25F);
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
