// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "nazori/base/clock.h"
#include "nazori/devices/tablet_device.h"
#include "scripted_device.h"

namespace nazori::devices::test {

/// A tablet with an arm that the test moves. Its deadlines follow a clock that the test sets; the servos run
/// in real time.
class TabletWithAnArm : public testing::Test {
 protected:
  /// Advances the clock in steps and runs the inbox until `wish` is true; at most for a real minute.
  template <class Wish>
  [[nodiscard]] bool comes(Wish wish, std::chrono::milliseconds step = std::chrono::milliseconds(0)) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!wish()) {
      if (std::chrono::steady_clock::now() > give_up) return false;
      std::array<haptics::ServoSample, 256> samples;
      (void)device_.take_samples(samples);
      while (inbox_.run_one()) continue;
      pass(step);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }
  void pass(std::chrono::milliseconds time) {
    clock_.advance(time);
    if (woken_at_ && *woken_at_ <= clock_.steady()) {
      woken_at_.reset();
      device_.update();
    }
  }

  std::shared_ptr<Script> script_ = std::make_shared<Script>();
  std::optional<base::Clock::Steady> woken_at_;
  int wakes_ = 0;  ///< how often the device asked to be woken
  base::Inbox inbox_;
  base::ManualClock clock_{base::Clock::Calendar{}};
  TabletDevice device_{inbox_, clock_, [this](base::Clock::Steady at) {
                         woken_at_ = at;
                         ++wakes_;
                       }};
};

}  // namespace nazori::devices::test
