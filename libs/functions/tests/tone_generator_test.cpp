// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/tone_generator.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "allocation_count.h"

namespace nazori::functions {
namespace {

/// Zero crossings of the low-passed sum of both sides tell the pitch of a steady tone.
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
