// SPDX-License-Identifier: Apache-2.0
#include "stylus.h"

#include <algorithm>
#include <chrono>

namespace nazori::ui {

Stylus::Stylus()
    : TabletDevice(event_loop.inbox(), clock, [this](base::Clock::Steady at) {
        using std::chrono::milliseconds;
        const auto left = std::chrono::ceil<milliseconds>(at - clock.steady());
        timer.start(std::max(left, milliseconds(0)));
      }) {
  timer.setSingleShot(true);
  QObject::connect(&timer, &QTimer::timeout, &timer, [this] { update(); });
}

}  // namespace nazori::ui
