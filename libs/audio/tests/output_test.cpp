// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/output.h"

#include <SDL.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

namespace {

/// The parameters of the last call to SDL.
SDL_AudioSpec asked_for{};

}  // namespace

// Replaces SDL's function, which it calls.
extern "C" SDL_AudioDeviceID SDL_OpenAudioDevice(const char* device, int is_capture,
                                                 const SDL_AudioSpec* wanted, SDL_AudioSpec* got,
                                                 int changes) {
  asked_for = *wanted;
  using Open = SDL_AudioDeviceID (*)(const char*, int, const SDL_AudioSpec*, SDL_AudioSpec*, int);
  const auto open = reinterpret_cast<Open>(dlsym(RTLD_NEXT, "SDL_OpenAudioDevice"));
  return open(device, is_capture, wanted, got, changes);
}

namespace {

using nazori::audio::Output;
using nazori::audio::Source;
using nazori::base::Errc;

/// A constant on the left, its opposite on the right.
struct Level final : Source {
  void add_to(std::span<float> stereo) noexcept override {
    for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
      stereo[i] += 0.25F;
      stereo[i + 1] -= 3.0F;
    }
    if (stereo.size() != 1024) other_size = true;
    asked.fetch_add(stereo.size() / 2);
  }
  std::atomic<std::size_t> asked{0};
  std::atomic<bool> other_size{false};
};

void wait_for(const std::atomic<std::size_t>& count, std::size_t least) {
  for (int i = 0; i < 2000 && count < least; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

TEST(Output, AsksTheSourceForAsLongAsItLives) {
  setenv("SDL_AUDIODRIVER", "dummy", 1);
  Level level;
  auto output = Output::open(level);
  ASSERT_TRUE(output) << nazori::base::to_line(output.error());
  EXPECT_EQ((*output)->driver(), "dummy");
  wait_for(level.asked, 1024);
  EXPECT_GE(level.asked, 1024U);
  output->reset();
  const std::size_t after = level.asked;
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  EXPECT_EQ(level.asked, after);
  EXPECT_FALSE(level.other_size) << "512 frames of two samples each";
  EXPECT_EQ(SDL_WasInit(SDL_INIT_AUDIO), 0U) << "SDL's audio is given back";
}

TEST(Output, TheCardIsAskedForWhatTheSettingsSayInStereoFloats) {
  setenv("SDL_AUDIODRIVER", "dummy", 1);
  Level level;
  for (const nazori::audio::OutputSettings& settings :
       {nazori::audio::OutputSettings{}, nazori::audio::OutputSettings{8'000, 64},
        nazori::audio::OutputSettings{192'000, 8'192}}) {
    const auto output = Output::open(level, settings);
    ASSERT_TRUE(output) << nazori::base::to_line(output.error());
    EXPECT_EQ(asked_for.freq, settings.rate_hz);
    EXPECT_EQ(asked_for.samples, settings.frames);
    EXPECT_EQ(asked_for.channels, 2);
    EXPECT_EQ(asked_for.format, AUDIO_F32SYS);
  }
  EXPECT_EQ(nazori::audio::OutputSettings{}.rate_hz, 44'100);
  EXPECT_EQ(nazori::audio::OutputSettings{}.frames, 512);
  EXPECT_STREQ(SDL_GetHint(SDL_HINT_NO_SIGNAL_HANDLERS), "1") << "Ctrl+C stays with the program";
}

TEST(Output, IsClosedThoughTheSoundOfSdlIsInUseElsewhere) {
  setenv("SDL_AUDIODRIVER", "dummy", 1);
  ASSERT_EQ(SDL_InitSubSystem(SDL_INIT_AUDIO), 0);
  Level first, second;
  auto output = Output::open(first);
  ASSERT_TRUE(output);
  wait_for(first.asked, 512);
  output->reset();
  const std::size_t after = first.asked;
  {
    const auto other = Output::open(second);
    ASSERT_TRUE(other) << nazori::base::to_line(other.error());
    wait_for(second.asked, 2048);
  }
  EXPECT_GE(second.asked, 2048U);
  EXPECT_EQ(first.asked, after);
  SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

TEST(Output, ACardThatCannotBeOpenedIsAnErrorAndNothingStaysBehind) {
  setenv("SDL_AUDIODRIVER", "disk", 1);
  setenv("SDL_DISKAUDIOFILE", "/no such folder/nazori.raw", 1);
  Level level;
  const auto output = Output::open(level);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, Errc::device);
  EXPECT_EQ(level.asked, 0U);
  EXPECT_EQ(SDL_WasInit(SDL_INIT_AUDIO), 0U);
}

TEST(Output, WhatTheSourceGivesReachesTheCardWithinItsRange) {
  const auto file = std::filesystem::temp_directory_path() / "nazori_output_test.raw";
  setenv("SDL_AUDIODRIVER", "disk", 1);
  setenv("SDL_DISKAUDIOFILE", file.c_str(), 1);
  Level level;
  auto output = Output::open(level);
  if (!output) GTEST_SKIP() << "this SDL cannot write to a file";
  wait_for(level.asked, 4096);
  output->reset();
  std::ifstream in(file, std::ios::binary);
  const std::vector<float> silence(2);
  const std::vector<float> wanted{0.25F, -1.0F};
  std::vector<float> frame(2);
  std::size_t heard = 0;
  while (in.read(reinterpret_cast<char*>(frame.data()), 2 * sizeof(float))) {
    if (heard == 0 && frame == silence) continue;  // the card runs for a moment before the source is called
    ASSERT_EQ(frame, wanted) << "frame " << heard;
    ++heard;
  }
  EXPECT_GE(heard, 3072U) << "the last buffers may be on their way";
  in.close();
  std::filesystem::remove(file);
}

TEST(Output, WithoutASoundCardThereIsAnErrorThatSaysWhatToDo) {
  setenv("SDL_AUDIODRIVER", "no such card", 1);
  Level level;
  const auto output = Output::open(level);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, Errc::device);
  EXPECT_NE(nazori::base::to_line(output.error()).find("loudspeakers"), std::string::npos);
}

TEST(Output, RefusesRatesAndBuffersThatNoCardHas) {
  setenv("SDL_AUDIODRIVER", "dummy", 1);
  Level level;
  for (const auto& settings :
       {nazori::audio::OutputSettings{7'999, 512}, nazori::audio::OutputSettings{192'001, 512},
        nazori::audio::OutputSettings{44'100, 500}, nazori::audio::OutputSettings{44'100, 32},
        nazori::audio::OutputSettings{44'100, 0}, nazori::audio::OutputSettings{44'100, 16'384}}) {
    const auto output = Output::open(level, settings);
    ASSERT_FALSE(output);
    EXPECT_EQ(output.error().code, Errc::bad_argument);
  }
}

}  // namespace
