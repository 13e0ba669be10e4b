// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/output.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

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
    asked.fetch_add(stereo.size() / 2);
  }
  std::atomic<std::size_t> asked{0};
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
    if (heard == 0 && frame == silence) continue;  // the card runs a little before the source is asked
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
  Level level;
  for (const auto& settings :
       {nazori::audio::OutputSettings{1'000, 512}, nazori::audio::OutputSettings{1'000'000, 512},
        nazori::audio::OutputSettings{44'100, 500}, nazori::audio::OutputSettings{44'100, 16'384}}) {
    const auto output = Output::open(level, settings);
    ASSERT_FALSE(output);
    EXPECT_EQ(output.error().code, Errc::bad_argument);
  }
}

}  // namespace
