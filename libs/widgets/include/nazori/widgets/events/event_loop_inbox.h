// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "nazori/base/executor.h"

namespace nazori::ui {

/// The inbox of a thread that runs an event loop of Qt: its tasks run as events of that loop.
/// Thread: the one that makes it. base::Inbox says what other threads may call.
class EventLoopInbox {
 public:
  EventLoopInbox();
  ~EventLoopInbox();
  EventLoopInbox(const EventLoopInbox&) = delete;
  EventLoopInbox& operator=(const EventLoopInbox&) = delete;

  [[nodiscard]] base::Inbox& inbox() { return inbox_; }

 private:
  class Bell;
  std::unique_ptr<Bell> bell_;
  base::Inbox inbox_;
};

}  // namespace nazori::ui
