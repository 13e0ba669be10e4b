// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/tablet/window_tablet.h"

#include <algorithm>
#include <chrono>

namespace nazori::ui {

using std::chrono::milliseconds;

WindowTablet::WindowTablet()
    : TabletControl(event_loop.inbox(), clock, [this](base::Clock::Steady at) {
        const auto left = std::chrono::ceil<milliseconds>(at - clock.steady());
        wake_timer.start(std::max(left, milliseconds(0)));
      }) {
  wake_timer.setSingleShot(true);
  QObject::connect(&wake_timer, &QTimer::timeout, &wake_timer, [this] { device().update(); });
  pump_timer.setTimerType(Qt::CoarseTimer);
  QObject::connect(&pump_timer, &QTimer::timeout, &pump_timer, [this] { pump(); });
  depth_changed.connect([this](double) {
    const auto period = pump_period();
    if (pump_timer.isActive() && pump_timer.intervalAsDuration() != period) pump_timer.setInterval(period);
  });
}

base::Result<void> WindowTablet::start() {
  auto started = TabletControl::start();
  if (started) pump_timer.start(pump_period());
  return started;
}

}  // namespace nazori::ui
