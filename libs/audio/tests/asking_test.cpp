// SPDX-License-Identifier: Apache-2.0
// What runs on the audio thread.
#include "asking.h"

#include <gtest/gtest.h>

#include <vector>

#include "alloc_guard.h"
#include "nazori/audio/groove_sound.h"
#include "system_calls.h"

namespace nazori::audio {
namespace {

class Loud final : public Source {
 public:
  void add_to(std::span<float> stereo) noexcept override {
    for (std::size_t i = 0; i < stereo.size(); ++i) stereo[i] += static_cast<float>(i) - 2;
  }
};

TEST(AudioCallback, StartsFromSilenceAndHoldsTheSourceToWhatCanBePlayed) {
  Loud loud;
  std::vector<float> block(5, 7.0F);
  ask(&loud, reinterpret_cast<std::uint8_t*>(block.data()), static_cast<int>(block.size() * sizeof(float)));
  EXPECT_EQ(block, (std::vector<float>{-1, -1, 0, 1, 1}));
}

TEST(AudioCallback, NeverAllocatesOrEntersTheKernel) {
  GrooveSound sound;
  std::vector<float> block(1024);
  const auto play = [&] {
    for (int i = 0; i < 300; ++i) {
      sound.set({0.001F * static_cast<float>(i), 0.5F, i % 60 < 30, 0.2F});
      ask(static_cast<Source*>(&sound), reinterpret_cast<std::uint8_t*>(block.data()),
          static_cast<int>(block.size() * sizeof(float)));
    }
  };
  long calls = 0;
  {
    const haptics::test::AllocGuard guard;
    play();
    calls = guard.calls();
  }
  EXPECT_EQ(calls, 0);
  if (!nazori::test::sees_system_calls()) GTEST_SKIP() << "no seccomp here, or a clock that needs the kernel";
  EXPECT_TRUE(nazori::test::ends_without_system_call(play));
}

}  // namespace
}  // namespace nazori::audio
