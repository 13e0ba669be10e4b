// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>

#include "event_loop_inbox.h"
#include "nazori/base/clock.h"
#include "nazori/devices/tablet_device.h"

namespace nazori::ui {

/// What devices::TabletDevice needs of the event loop of Qt: a base class, so that it is there first.
struct StylusLoop {
  EventLoopInbox event_loop;
  base::SystemClock clock;
  QTimer timer;
};

/// The tablet's device, on the event loop of the thread that makes it. Thread: interface.
class Stylus final : private StylusLoop, public devices::TabletDevice {
 public:
  Stylus();
};

}  // namespace nazori::ui
