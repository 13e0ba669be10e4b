// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_mixer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "allocation_count.h"
#include "system_calls.h"

namespace nazori::functions {
namespace {

constexpr int kRate_hz = 44'100;

Sound constant(float value, std::size_t frames) { return {kRate_hz, std::vector<float>(2 * frames, value)}; }

TEST(PlotMixer, ASoundIsPlayedOnceAtTheVolumeOverWhatIsThere) {
  PlotMixer mixer(kRate_hz);
  mixer.set_volume(0.25, false);
  EXPECT_FALSE(mixer.is_playing());
  mixer.play(constant(0.8F, 3000));
  EXPECT_TRUE(mixer.is_playing());
  std::vector<float> block(4000, 0.5F);  // longer than a piece of the mixer
  mixer.add_to(block);
  for (const float sample : block) ASSERT_FLOAT_EQ(sample, 0.7F);
  EXPECT_TRUE(mixer.is_playing());
  std::fill(block.begin(), block.end(), 0.0F);
  mixer.add_to(block);
  EXPECT_FLOAT_EQ(block[1999], 0.2F);
  EXPECT_EQ(block[2000], 0.0F) << "it is over";
  EXPECT_FALSE(mixer.is_playing());
}

TEST(PlotMixer, AVolumeOutOfRangeIsTheNearestInItAndNoneSetIsOneHalf) {
  std::vector<float> block(10);
  const auto heard = [&](PlotMixer& mixer) {
    mixer.play(constant(0.5F, 100));
    std::fill(block.begin(), block.end(), 0.0F);
    mixer.add_to(block);
    return block[0];
  };
  PlotMixer mixer(kRate_hz);
  EXPECT_FLOAT_EQ(heard(mixer), 0.25F);
  mixer.set_volume(1.4, false);
  EXPECT_FLOAT_EQ(heard(mixer), 0.5F);
  mixer.set_volume(-0.4, false);
  EXPECT_EQ(heard(mixer), 0.0F);
  mixer.set_volume(1, true);
  EXPECT_EQ(heard(mixer), 0.0F);
}

TEST(PlotMixer, AnotherSoundTakesThePlaceOfTheFirstAndAnEmptyOneIsSilence) {
  PlotMixer mixer(kRate_hz);
  mixer.set_volume(1, false);
  std::vector<float> block(100);
  mixer.play(constant(0.1F, 1000));
  mixer.add_to(block);
  mixer.play(constant(0.2F, 1000));
  std::fill(block.begin(), block.end(), 0.0F);
  mixer.add_to(block);
  EXPECT_FLOAT_EQ(block[0], 0.2F);
  mixer.play({});
  EXPECT_FALSE(mixer.is_playing());
  std::fill(block.begin(), block.end(), 0.0F);
  mixer.add_to(block);
  EXPECT_EQ(block[0], 0.0F);
}

TEST(PlotMixer, TheToneIsHeardWithItAndMutedNothingIs) {
  PlotMixer mixer(kRate_hz);
  mixer.set_volume(0.5, false);
  mixer.tone().set({440, 0, 0, 1});
  std::vector<float> block(8820);
  mixer.add_to(block);
  const auto loudest = [&] {
    float most = 0;
    for (const float sample : block) most = std::max(most, std::abs(sample));
    return most;
  };
  EXPECT_GT(loudest(), 0.1F);
  mixer.set_volume(0.5, true);
  mixer.play(constant(1, 100'000));
  for (int i = 0; i < 2; ++i) {  // the tone glides away within the first
    std::fill(block.begin(), block.end(), 0.0F);
    mixer.add_to(block);
  }
  EXPECT_LT(loudest(), 1e-3F);
}

/// Replaced at all possible moments; the sanitizers detect reads after freeing.
TEST(PlotMixer, SoundsAreReplacedWhileTheyPlay) {
  PlotMixer mixer(kRate_hz);
  mixer.set_volume(1, false);
  std::atomic<bool> over{false}, strange{false};
  std::atomic<long> heard{0};
  std::thread audio([&] {
    std::vector<float> block(256);
    while (!over) {
      std::fill(block.begin(), block.end(), 0.0F);
      mixer.add_to(block);
      // All of one sound, then nothing.
      const float first = block[0];
      if (first != 0) ++heard;
      for (const float sample : block) {
        if (sample != first && sample != 0) strange = true;
      }
    }
  });
  for (int i = 1; i <= 2000 || heard == 0; ++i) {
    mixer.play(constant(static_cast<float>(i % 100 + 1) / 128, 50 + i % 400));
    (void)mixer.is_playing();
    mixer.set_volume(1, false);
  }
  over = true;
  audio.join();
  EXPECT_FALSE(strange);
}

TEST(PlotMixer, WhatTheSoundCardAsksNeverAllocatesOrEntersTheKernel) {
  PlotMixer mixer(kRate_hz);
  mixer.tone().set({440, 0.3, 0.5, 1}, true);
  mixer.play(constant(0.5F, 100'000));
  std::vector<float> block(1024);
  const auto ask = [&] {
    for (int i = 0; i < 300; ++i) {
      if (i % 50 == 0) mixer.tone().play(static_cast<PointKind>(i / 50), 0.5);
      mixer.add_to(block);
    }
  };
  test::begin_counting_allocations();
  ask();
  EXPECT_EQ(test::end_counting_allocations(), 0);
  if (!nazori::test::sees_system_calls()) GTEST_SKIP() << "no seccomp here, or a clock that needs the kernel";
  EXPECT_TRUE(nazori::test::ends_without_system_call(ask));
}

}  // namespace
}  // namespace nazori::functions
