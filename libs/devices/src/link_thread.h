// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <thread>

#include "nazori/base/result.h"

namespace nazori::devices {

/// The thread of a device link: all communication with the device, in place of the servo, which must not
/// wait. It has a lower priority than the servo, whose requests it handles, and runs no signal handlers.
/// Thread rules: all members by one thread (the interface).
class LinkThread {
 public:
  using Run = std::function<void(const std::stop_token&)>;

  LinkThread() = default;
  ~LinkThread() { stop(); }
  LinkThread(const LinkThread&) = delete;
  LinkThread& operator=(const LinkThread&) = delete;

  /// While it does not run. @param device  for the message.  @param run  must not throw.
  /// @return Errc::device where no thread can be started.
  [[nodiscard]] base::Result<void> start(const std::string& device, Run run);
  /// Asks `run` to stop and returns when it has returned. Has no effect when not running.
  void stop() noexcept;
  [[nodiscard]] bool is_running() const noexcept { return thread_.joinable(); }

 private:
  std::jthread thread_;
};

}  // namespace nazori::devices
