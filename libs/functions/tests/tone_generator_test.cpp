// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/tone_generator.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "../src/voice.h"
#include "allocation_count.h"

namespace nazori::functions {
namespace {

/// Zero crossings of the low-passed sum of both sides give the pitch of a steady tone.
double pitch_of(const std::vector<float>& stereo, int rate, double expected) {
  const auto at = [&](std::size_t k) { return static_cast<double>(stereo[2 * k] + stereo[2 * k + 1]); };
  const std::size_t frames = stereo.size() / 2;
  const double period = rate / expected;
  double best = -1e9;
  double lag_of_best = 1;
  for (double lag = 0.8 * period; lag < 1.25 * period; lag += 0.02 * period / 10) {
    const auto whole = static_cast<std::size_t>(lag);
    const double share = lag - static_cast<double>(whole);
    double sum = 0;
    for (std::size_t i = frames / 4; i < frames / 2; ++i)
      sum += at(i) * (at(i + whole) * (1 - share) + at(i + whole + 1) * share);
    if (sum > best) {
      best = sum;
      lag_of_best = lag;
    }
  }
  return rate / lag_of_best;
}

float loudest(const std::vector<float>& samples) {
  float most = 0;
  for (const float s : samples) most = std::max(most, std::abs(s));
  return most;
}

TEST(ToneGenerator, SoundsTheFrequencyItIsTold) {
  SoundSettings settings;
  settings.sample_rate = 48'000;
  for (const double hertz : {200.0, 440.0, 1000.0}) {
    ToneGenerator tone(settings);
    tone.set({hertz, 0, 0, 1});
    std::vector<float> block(2 * 9600);
    tone.fill(block);
    EXPECT_NEAR(pitch_of(block, 48'000, hertz) / hertz, 1, 0.005) << hertz;
  }
}

TEST(ToneGenerator, FollowsTheHeightOfAPointOnALogarithmicScale) {
  const Window w{-1, 1, -1, 1};
  ToneGenerator tone;
  for (const double v : {0.6, 0.75, 1.0}) {
    tone.set(cue_at({0.5, v}, w, 1));
    std::vector<float> block(2 * 8820);
    tone.fill(block);
    EXPECT_NEAR(pitch_of(block, 44'100, 200 * std::pow(5.0, v)) / (200 * std::pow(5.0, v)), 1, 0.01) << v;
  }
}

TEST(ToneGenerator, IsSilentBeforeAnythingIsSetWhenMutedAndAtVolumeZero) {
  ToneGenerator tone;
  std::vector<float> block(2048);
  tone.fill(block);
  EXPECT_EQ(loudest(block), 0.0F);
  tone.set({440, 0, 0, 1});
  tone.fill(block);
  EXPECT_GT(loudest(block), 0.1F);
  tone.set_muted(true);
  for (int i = 0; i < 4; ++i) tone.fill(block);
  EXPECT_EQ(loudest(block), 0.0F);
  tone.set_muted(false);
  tone.set_volume(0);
  for (int i = 0; i < 4; ++i) tone.fill(block);
  EXPECT_EQ(loudest(block), 0.0F);
  tone.set_volume(0.5);
  tone.set({440, 0, 0, 0});
  for (int i = 0; i < 8; ++i) tone.fill(block);
  EXPECT_EQ(loudest(block), 0.0F);
}

TEST(ToneGenerator, LeftAndRightFollowThePlace) {
  ToneGenerator tone;
  std::vector<float> block(2 * 8820);
  for (const double pan : {-1.0, 1.0}) {
    tone.set({440, pan, 0, 1});
    tone.fill(block);
    tone.fill(block);
    double left = 0;
    double right = 0;
    for (std::size_t i = 0; i < block.size(); i += 2) {
      left += std::abs(block[i]);
      right += std::abs(block[i + 1]);
    }
    EXPECT_GT(pan < 0 ? left : right, 50 * (pan < 0 ? right : left));
  }
}

/// The samples of a generator after one setting, from silence on.
std::vector<float> filled(ToneGenerator& tone, std::size_t frames) {
  std::vector<float> block(2 * frames);
  tone.fill(block);
  return block;
}

TEST(ToneGenerator, IsTheVoiceAtItsCueAndVolumeGlidingThere) {
  SoundSettings settings;
  settings.sample_rate = 48'000;
  settings.volume = 0.75;
  for (const Cue& cue : {Cue{440, -1, 0, 1}, Cue{1200.5, 1, 1, 1}, Cue{300.0625, 0.25, 0.5, 0.3}}) {
    for (const bool trembles : {false, true}) {
      ToneGenerator tone(settings);
      tone.set(cue, trembles);
      const auto block = filled(tone, 2'000);
      Voice voice(48'000);
      for (std::size_t i = 0; i < 2'000; ++i) {
        const StereoSample sample = voice.next(cue, trembles);
        const double volume = 0.75 * (1 - std::exp(-static_cast<double>(i + 1) / (0.004 * 48'000)));
        // Pan, noise and loudness are kept in 4095ths.
        ASSERT_NEAR(block[2 * i], sample.left * volume, 1e-3) << i;
        ASSERT_NEAR(block[2 * i + 1], sample.right * volume, 1e-3) << i;
      }
    }
  }
}

TEST(ToneGenerator, ASignIsItsEarconWhereItStands) {
  SoundSettings settings;
  settings.sample_rate = 48'000;
  settings.volume = 1;
  for (const double pan : {-1.0, 0.5, 1.0}) {
    ToneGenerator tone(settings);
    (void)filled(tone, 4'800);
    tone.play(PointKind::isolated, pan);
    const auto block = filled(tone, 6'000);
    Earcon earcon(PointKind::isolated, pan, 48'000);
    for (std::size_t i = 0; i < 6'000; ++i) {
      const StereoSample sample = earcon.next();
      ASSERT_NEAR(block[2 * i], sample.left, 1e-3) << i;
      ASSERT_NEAR(block[2 * i + 1], sample.right, 1e-3) << i;
    }
  }
}

TEST(ToneGenerator, ValuesOutOfRangeAreTheNearestInIt) {
  const auto steady = [](const SoundSettings& settings, double volume, const Cue& cue) {
    ToneGenerator tone(settings);
    if (!std::isnan(volume)) tone.set_volume(volume);
    tone.set(cue);
    (void)filled(tone, 4'800);
    return loudest(filled(tone, 4'800));
  };
  const double unset = std::nan("");
  const Cue cue{440, -1, 0, 1};
  const float whole = steady({}, 1, cue);
  EXPECT_GT(whole, 0.5F);
  EXPECT_EQ(steady({}, 1.4, cue), whole);
  EXPECT_EQ(steady({}, -1, cue), 0);
  EXPECT_NEAR(steady({}, unset, cue), whole / 2, 1e-3);
  SoundSettings settings;
  settings.volume = 3;
  EXPECT_EQ(steady(settings, unset, cue), whole);
  settings.volume = -3;
  EXPECT_EQ(steady(settings, unset, cue), 0);
  EXPECT_EQ(steady({}, 1, {440, -3, 0, 2}), whole);
  EXPECT_EQ(steady({}, 1, {unset, -1, 0, 1}), 0);
  EXPECT_EQ(steady({}, 1, {-5, -1, 0, 1}), 0);
  EXPECT_EQ(steady({}, 1, {0, -1, 0, 1}), 0);
  EXPECT_EQ(steady({}, 1, {1e9, -1, 0, 1}), 0) << "no harmonic of it can be played";
}

TEST(ToneGenerator, AnOddLastSampleIsSilent) {
  ToneGenerator tone;
  tone.set({440, 0, 0, 1});
  std::vector<float> block(4'001, 7.0F);
  tone.fill(block);
  EXPECT_EQ(block.back(), 0);
  EXPECT_NE(block[3'998], 7.0F);
  EXPECT_NE(block[3'998], 0);
}

TEST(ToneGenerator, NoStepIsLargeEnoughToClick) {
  ToneGenerator tone;
  tone.set({300, 0, 0, 1});
  std::vector<float> block(256);
  float last = 0;
  float step = 0;
  for (int k = 0; k < 200; ++k) {
    tone.set({k % 2 == 0 ? 300.0 : 900.0, k % 3 - 1.0, 0, k % 5 == 0 ? 0.0 : 1.0});
    tone.fill(block);
    for (std::size_t i = 0; i < block.size(); i += 2) {
      step = std::max(step, std::abs(block[i] - last));
      last = block[i];
    }
  }
  // 900 Hz with harmonics up to four times that moves by at most 0.5 * 2 pi * 900 * 3 / 44100.
  EXPECT_LT(step, 0.2F);
}

TEST(ToneGenerator, ASignSoundsOnceAndEnds) {
  ToneGenerator tone;
  std::vector<float> block(2 * 4410);
  tone.fill(block);
  tone.play(PointKind::maximum, 0);
  tone.fill(block);
  EXPECT_GT(loudest(block), 0.05F);
  tone.fill(block);
  tone.fill(block);
  EXPECT_EQ(loudest(block), 0.0F);
  tone.play(PointKind::maximum, 0);
  tone.fill(block);
  EXPECT_GT(loudest(block), 0.05F);
}

TEST(ToneGenerator, ToneAndSignTogetherStayWithinWhatALoudspeakerTakes) {
  SoundSettings settings;
  ToneGenerator tone(settings);
  tone.set_volume(1);
  tone.set({660, -1, 0, 1});
  std::vector<float> block(2 * 44'100);
  float most = 0;
  for (int i = 0; i < 8; ++i) {
    tone.play(PointKind::zero, -1);
    tone.fill(block);
    most = std::max(most, loudest(block));
  }
  EXPECT_LE(most, 1.0F);
  EXPECT_EQ(most, 1.0F) << "else nothing was tried";
}

TEST(ToneGenerator, FillingDoesNotAllocate) {
  ToneGenerator tone;
  std::vector<float> block(1024);
  test::begin_counting_allocations();
  for (int k = 0; k < 50; ++k) {
    tone.set({200.0 + k, 0, 0.3, 1}, k % 2 == 0);
    if (k % 10 == 0) tone.play(PointKind::zero, 0.5);
    tone.fill(block);
  }
  EXPECT_EQ(test::end_counting_allocations(), 0);
}

TEST(ToneGenerator, TwoThreadsNeedNotWaitForEachOther) {
  ToneGenerator tone;
  std::atomic<bool> done{false};
  std::thread hand([&] {
    for (int k = 0; k < 20'000; ++k) {
      tone.set({200.0 + k % 800, (k % 21 - 10) / 10.0, 0, 1});
      if (k % 1000 == 0) tone.play(PointKind::crossing, 0);
      tone.set_volume(0.3 + 0.2 * (k % 2));
    }
    done = true;
  });
  std::vector<float> block(512);
  do {
    tone.fill(block);
    for (const float s : block) ASSERT_LE(std::abs(s), 1.0F);
  } while (!done);
  hand.join();
}

}  // namespace
}  // namespace nazori::functions
