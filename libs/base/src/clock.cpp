// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/clock.h"

#include <cassert>

namespace nazori::base {

Clock::Calendar SystemClock::calendar() const {
  return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
}

Clock::Steady SystemClock::steady() const { return std::chrono::steady_clock::now(); }

void ManualClock::advance(std::chrono::milliseconds by) {
  assert(by.count() >= 0);
  calendar_ += by;
  steady_ += by;
}

}  // namespace nazori::base
