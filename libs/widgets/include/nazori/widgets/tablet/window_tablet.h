// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>

#include "nazori/base/clock.h"
#include "nazori/practice/tablet_control.h"
#include "nazori/widgets/events/event_loop_inbox.h"

namespace nazori::ui {

/// The objects of Qt's event loop that practice::TabletControl needs. A base class, so that they are made
/// first.
struct TabletLoop {
  EventLoopInbox event_loop;
  base::SystemClock clock;
  QTimer wake_timer;
  QTimer pump_timer;
};

/// The tablet, on the event loop of the thread that makes it. Thread: interface.
class WindowTablet final : private TabletLoop, public practice::TabletControl {
 public:
  WindowTablet();

  /// As TabletControl::start(); from then on pump() is called as often as it has to be.
  [[nodiscard]] base::Result<void> start();
};

}  // namespace nazori::ui
