// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/voice_sound.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "alloc_guard.h"
#include "with_driver.h"

namespace nazori::audio {
namespace {

speech::Sound level(float value, std::size_t count, int rate_hz = 44'100) {
  return {rate_hz, std::vector<float>(count, value)};
}

TEST(VoiceMixer, PlaysASoundOnceOnBothSidesAndAddsItToTheRest) {
  VoiceMixer mixer;
  std::vector<float> block(8, 0.25F);
  mixer.add_to(block);
  EXPECT_EQ(block, std::vector<float>(8, 0.25F));
  EXPECT_FALSE(mixer.is_playing());
  mixer.play(level(0.5F, 6));
  EXPECT_TRUE(mixer.is_playing());
  mixer.add_to(block);
  EXPECT_EQ(block, std::vector<float>(8, 0.75F));
  EXPECT_TRUE(mixer.is_playing());
  mixer.add_to(block);
  EXPECT_EQ(block, (std::vector<float>{1.25F, 1.25F, 1.25F, 1.25F, 0.75F, 0.75F, 0.75F, 0.75F}));
  EXPECT_FALSE(mixer.is_playing());
}

TEST(VoiceMixer, ANewSoundReplacesTheOneBeforeAndStopEndsIt) {
  VoiceMixer mixer;
  mixer.play(level(0.5F, 1000));
  std::vector<float> block(4);
  mixer.add_to(block);
  mixer.play(level(-0.25F, 1000));
  block.assign(4, 0);
  mixer.add_to(block);
  EXPECT_EQ(block, std::vector<float>(4, -0.25F));
  mixer.stop();
  EXPECT_FALSE(mixer.is_playing());
  block.assign(4, 0);
  mixer.add_to(block);
  EXPECT_EQ(block, std::vector<float>(4, 0.0F));
}

TEST(VoiceMixer, TurnsTheVolumeDown) {
  VoiceMixer mixer;
  mixer.set_volume(0.5F);
  mixer.play(level(0.5F, 10));
  std::vector<float> block(2);
  mixer.add_to(block);
  EXPECT_EQ(block, std::vector<float>(2, 0.25F));
}

TEST(VoiceMixer, ConvertsTheRateSoThatTheSoundLastsAsLongAndSoundsTheSame) {
  speech::Sound tone{22'050, {}};
  for (int i = 0; i < 22'050; ++i)
    tone.samples.push_back(static_cast<float>(std::sin(2 * 3.14159265358979 * 440 * i / 22'050)));
  const auto samples = at_rate(tone, 44'100);
  ASSERT_EQ(samples.size(), 44'100U);
  for (std::size_t i = 0; i < samples.size() - 2; ++i)
    ASSERT_NEAR(samples[i], std::sin(2 * 3.14159265358979 * 440 * static_cast<double>(i) / 44'100), 2.5e-3)
        << i;
  EXPECT_EQ(at_rate(tone, 11'025).size(), 11'025U);
  EXPECT_EQ(at_rate(tone, 22'050), tone.samples);
  EXPECT_TRUE(at_rate({}, 44'100).empty());
  for (const int none : {0, -1}) {
    EXPECT_TRUE(at_rate({none, {0.5F, 0.5F}}, 44'100).empty()) << none;
    EXPECT_TRUE(at_rate({22'050, {0.5F, 0.5F}}, none).empty()) << none;
  }
}

TEST(VoiceMixer, NeverAllocatesOnTheAudioThread) {
  VoiceMixer mixer;
  mixer.play(level(0.1F, 100'000));
  std::vector<float> block(1024);
  long calls = 0;
  {
    const haptics::test::AllocGuard guard;
    for (int i = 0; i < 300; ++i) mixer.add_to(block);
    calls = guard.calls();
  }
  EXPECT_EQ(calls, 0);
}

TEST(VoiceMixer, SoundsMayBeReplacedWhileTheAudioThreadReadsThem) {
  VoiceMixer mixer;
  std::atomic<bool> done{false};
  std::thread audio([&] {
    std::vector<float> block(64);
    while (!done) {
      std::fill(block.begin(), block.end(), 0.0F);
      mixer.add_to(block);
      for (const float x : block) ASSERT_TRUE(x == 0 || x == 0.25F || x == 0.5F);
    }
  });
  for (int i = 0; i < 2000; ++i) mixer.play(level(i % 2 == 0 ? 0.25F : 0.5F, 200));
  done = true;
  audio.join();
}

TEST(VoiceSound, WithoutASoundCardSaysSoEachTime) {
  const WithDriver none("no such driver");
  VoiceSound sound;
  for (int i = 0; i < 2; ++i) {
    const auto played = sound.play(level(0.5F, 100));
    ASSERT_FALSE(played);
    EXPECT_EQ(played.error().code, base::Errc::device);
  }
  EXPECT_FALSE(sound.is_open());
  EXPECT_FALSE(sound.is_playing());
}

TEST(VoiceSound, PlaysToTheEndAndGivesTheSoundCardBack) {
  const WithDriver dummy("dummy");
  VoiceSound sound;
  sound.set_volume(0.5);
  EXPECT_FALSE(sound.is_open());
  ASSERT_TRUE(sound.play(level(0.5F, 4410)));
  EXPECT_TRUE(sound.is_playing());
  for (int waited = 0; sound.is_playing() && waited < 2000; ++waited)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_FALSE(sound.is_playing());
  EXPECT_TRUE(sound.is_open());
  sound.close();
  EXPECT_FALSE(sound.is_open());
}

}  // namespace
}  // namespace nazori::audio
