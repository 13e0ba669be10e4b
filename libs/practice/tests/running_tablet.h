// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <thread>

#include "nazori/base/clock.h"
#include "nazori/practice/tablet_control.h"

namespace nazori::practice::test {

/// The objects that a tablet with a servo needs; a base class, so that they are made first.
struct TabletLoop {
  base::Inbox inbox;
  base::SystemClock clock;
};

/// A tablet that runs by the clock of the computer, on the thread of the test.
class RunningTablet : private TabletLoop, public TabletControl {
 public:
  RunningTablet() : TabletControl(inbox, clock, {}) {}

  /// Acts as an event loop until `wish` is true. @return false if it is not true within `limit_ms`.
  template <class Wish>
  bool wait_for(Wish wish, int limit_ms = 20'000) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(limit_ms);
    while (!wish()) {
      if (std::chrono::steady_clock::now() > end) return false;
      while (inbox.run_one()) {
      }
      device().update();
      pump();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }
  /// Waits for at least this many more samples of the servo.
  void let_ticks_pass(std::uint64_t count) {
    const auto from = device().timing().ticks;
    wait_for([&] { return device().timing().ticks >= from + count; });
  }
};

}  // namespace nazori::practice::test
