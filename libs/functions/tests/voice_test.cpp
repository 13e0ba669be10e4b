// SPDX-License-Identifier: Apache-2.0
#include "../src/voice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace nazori::functions {
namespace {

constexpr int kRate = 48'000;

/// How much of a tone of `hertz` is in `samples` (Goertzel's sum).
double share_of(double hertz, const std::vector<double>& samples) {
  double real = 0;
  double imaginary = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double angle = 2 * std::numbers::pi * hertz * static_cast<double>(i) / kRate;
    real += samples[i] * std::cos(angle);
    imaginary += samples[i] * std::sin(angle);
  }
  return std::hypot(real, imaginary);
}

/// The strongest of the pitches that earcons use in a stretch of one, as a factor of 660 Hz.
double pitch_of(PointKind kind, double from_s, double to_s) {
  Earcon earcon(kind, -1, kRate);
  std::vector<double> samples;
  for (int i = 0; i < static_cast<int>(to_s * kRate); ++i) {
    const double left = earcon.next().left;
    if (i >= static_cast<int>(from_s * kRate)) samples.push_back(left);
  }
  double best = 0;
  double most = -1;
  for (const double factor : {0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0}) {
    const double share = share_of(660 * factor, samples);
    if (share > most) {
      most = share;
      best = factor;
    }
  }
  return best;
}

TEST(Earcon, EachKindOfPointHasItsTwoTones) {
  // As in docs/functions.md: rising tones mark a maximum, falling ones a minimum.
  struct Sign {
    PointKind kind;
    double first, second;
  };
  const Sign signs[] = {{PointKind::zero, 2, 2},
                        {PointKind::y_intercept, 1.5, 1.5},
                        {PointKind::maximum, 2, 3},
                        {PointKind::minimum, 3, 2},
                        {PointKind::crossing, 1, 2.5},
                        {PointKind::touching, 2.5, 2.5},
                        {PointKind::hole, 0.5, 0.5},
                        {PointKind::vertical_asymptote, 4, 1},
                        {PointKind::horizontal_asymptote, 4, 1},
                        {PointKind::jump, 1, 4},
                        {PointKind::end, 1, 0.75}};
  for (const Sign& sign : signs) {
    EXPECT_EQ(pitch_of(sign.kind, 0.01, 0.05), sign.first) << static_cast<int>(sign.kind);
    EXPECT_EQ(pitch_of(sign.kind, 0.07, 0.11), sign.second) << static_cast<int>(sign.kind);
  }
}

TEST(Earcon, LastsItsTimeAndIsThenSilent) {
  Earcon earcon(PointKind::zero, 0, kRate);
  int samples = 0;
  while (!earcon.is_over()) {
    (void)earcon.next();
    ++samples;
  }
  EXPECT_EQ(samples, static_cast<int>(Earcon::kSeconds * kRate));
  const StereoSample after = earcon.next();
  EXPECT_EQ(after.left, 0);
  EXPECT_EQ(after.right, 0);
}

TEST(Earcon, IsTwoSinesUnderAnArchEachAndStandsWhereThePointIs) {
  Earcon left(PointKind::end, -1, kRate);
  Earcon right(PointKind::end, 1, kRate);
  // 5,760 samples: one tone of 660 Hz, then one of 495 Hz.
  for (int i = 0; i < 5'760; ++i) {
    const double hertz = i < 2'880 ? 660 : 495;
    const double arch = std::sin(std::numbers::pi * (i % 2'880) / 2'880);
    const double wanted = 0.35 * arch * std::sin(2 * std::numbers::pi * hertz * i / kRate);
    const StereoSample sample = left.next();
    ASSERT_NEAR(sample.left, wanted, 1e-9) << i;
    ASSERT_NEAR(sample.right, 0, 1e-9) << i;
    ASSERT_NEAR(right.next().right, wanted, 1e-9) << i;
  }
}

TEST(Earcon, KindsWithoutTonesOfTheirOwnShareTwo) {
  for (const PointKind kind :
       {PointKind::inflection, PointKind::self_crossing, PointKind::singular, PointKind::isolated}) {
    EXPECT_EQ(pitch_of(kind, 0.01, 0.05), 1.25);
    EXPECT_EQ(pitch_of(kind, 0.07, 0.11), 1.5);
  }
}

/// A tone with its harmonics after `samples` samples from the first on.
double tone_at(double hertz, int samples, int harmonics = 4) {
  const double shares[] = {1, 0.45, 0.25, 0.12};
  double sum = 0;
  for (int h = 0; h < harmonics; ++h)
    sum += shares[h] * std::sin(2 * std::numbers::pi * (h + 1) * hertz * samples / kRate);
  return sum / 1.82;
}

/// How far a glide is after so many samples: its time is 4 ms.
double glided(int samples) { return 1 - std::exp(-samples / (0.004 * kRate)); }

TEST(Voice, SwellsFromSilenceAtItsOwnPitchInFourMilliseconds) {
  Voice voice(kRate);
  for (int i = 1; i <= 2'000; ++i) {
    const double sample = voice.next({440, -1, 0, 0.8}, false).left;
    ASSERT_NEAR(sample, 0.8 * glided(i) * tone_at(440, i), 1e-9) << i;
  }
}

TEST(Voice, LeavesOutHarmonicsThatTheRateCannotHold) {
  // 0.45 of the rate is 21,600 Hz: twice 10,000 and four times 5,300 fit, three times 10,000 and four times
  // 5,500 do not.
  for (const auto& [hertz, harmonics] :
       {std::pair{10'000.0, 2}, std::pair{5'300.0, 4}, std::pair{5'500.0, 3}}) {
    Voice voice(kRate);
    for (int i = 1; i <= 300; ++i)
      ASSERT_NEAR(voice.next({hertz, -1, 0, 1}, false).left, glided(i) * tone_at(hertz, i, harmonics), 1e-9);
  }
}

TEST(Voice, PitchPlaceAndLoudnessGlideToWhatIsNew) {
  Voice voice(kRate);
  double phase = 0;
  for (int i = 1; i <= 5'000; ++i) {
    (void)voice.next({200, -1, 0, 1}, false);
    phase += 200.0 / kRate;
  }
  for (int i = 1; i <= 1'000; ++i) {
    const StereoSample sample = voice.next({800, 1, 0, 0.5}, false);
    // On a logarithmic scale: half of the way is an octave of two.
    phase += 200 * std::pow(4, glided(i)) / kRate;
    const double pan = -1 + 2 * glided(i);
    const double loudness = 1 - 0.5 * glided(i);
    double tone = 0;
    const double shares[] = {1, 0.45, 0.25, 0.12};
    for (int h = 0; h < 4; ++h) tone += shares[h] * std::sin(2 * std::numbers::pi * (h + 1) * phase);
    const StereoSample there = panned(loudness * tone / 1.82, pan);
    ASSERT_NEAR(sample.left, there.left, 1e-6) << i;
    ASSERT_NEAR(sample.right, there.right, 1e-6) << i;
  }
}

TEST(Voice, FadesAwayAtItsLastPitchAndThenBeginsAnew) {
  Voice voice(kRate);
  for (int i = 1; i <= 2'000; ++i) (void)voice.next({300, -1, 0, 1}, false);
  for (int i = 1; i <= 800; ++i) {
    const double sample = voice.next({}, false).left;
    ASSERT_NEAR(sample, std::exp(-i / (0.004 * kRate)) * tone_at(300, 2'000 + i), 1e-4) << i;
  }
  int silent = 0;
  for (int i = 0; i < 4'000; ++i) silent += voice.next({}, false).left == 0 ? 1 : 0;
  EXPECT_GT(silent, 2'000);
  // No pitch is no sound either.
  EXPECT_EQ(voice.next({0, 0, 0, 1}, false).left, 0);
  // A second tone does not glide there from the first.
  std::vector<double> samples;
  for (int i = 0; i < 4'800; ++i) {
    const double sample = voice.next({900, 1, 0, 1}, false).right;
    if (i < 240) samples.push_back(sample);
  }
  EXPECT_GT(share_of(900, samples), 3 * share_of(300, samples));
  EXPECT_GT(share_of(900, samples), 3 * share_of(600, samples));
}

TEST(Voice, NoiseIsEvenlySpreadAndTheSameEveryTime) {
  Voice voice(kRate);
  Voice again(kRate);
  double sum = 0;
  double squares = 0;
  double most = 0;
  double least = 0;
  for (int i = 0; i < 48'000; ++i) {
    const double sample = voice.next({440, -1, 1, 1}, false).left;
    ASSERT_EQ(sample, again.next({440, -1, 1, 1}, false).left);
    if (i < 2'400) continue;
    sum += sample;
    squares += sample * sample;
    most = std::max(most, sample);
    least = std::min(least, sample);
  }
  EXPECT_NEAR(sum / 45'600, 0, 0.01);
  EXPECT_NEAR(squares / 45'600, 1.0 / 3, 0.01);
  EXPECT_NEAR(most, 1, 0.001);
  EXPECT_NEAR(least, -1, 0.001);
  // Its share is what is missing of the tone.
  Voice mixed(kRate);
  std::vector<double> tone;
  for (int i = 0; i < 52'800; ++i) {
    const double sample = mixed.next({440, -1, 0.25, 1}, false).left;
    if (i >= 4'800) tone.push_back(sample);
  }
  EXPECT_NEAR(2 * share_of(440, tone) / 48'000, 0.75 / 1.82, 0.005);
}

TEST(Voice, TremblesFourteenTimesASecondBetweenAFifthAndTheWhole) {
  Voice plain(kRate);
  Voice trembling(kRate);
  int rises = 0;
  double before = 1;
  double least = 1;
  double most = 0;
  for (int i = 0; i < 48'000; ++i) {
    const double steady = plain.next({440, -1, 0, 1}, false).left;
    const double sample = trembling.next({440, -1, 0, 1}, true).left;
    if (i < 2'400 || std::abs(steady) < 0.05) continue;
    const double part = sample / steady;
    least = std::min(least, part);
    most = std::max(most, part);
    rises += before < 0.6 && part >= 0.6 ? 1 : 0;
    before = part;
  }
  EXPECT_NEAR(least, 0.2, 1e-3);
  EXPECT_NEAR(most, 1, 1e-3);
  EXPECT_EQ(rises, 13) << "in 19/20 s";
}

TEST(Panned, TheTwoSidesHaveOnePowerTogether) {
  for (double pan = -1; pan <= 1; pan += 0.125) {
    const StereoSample sample = panned(0.5, pan);
    EXPECT_NEAR(std::hypot(sample.left, sample.right), 0.5, 1e-12);
    // In the middle they differ by rounding at most.
    if (pan == 0) {
      EXPECT_NEAR(sample.left, sample.right, 1e-12);
    } else {
      EXPECT_EQ(sample.left > sample.right, pan < 0);
    }
  }
  EXPECT_NEAR(panned(1, -1).right, 0, 1e-12);
  EXPECT_NEAR(panned(1, 1).left, 0, 1e-12);
}

}  // namespace
}  // namespace nazori::functions
