// SPDX-License-Identifier: Apache-2.0
#include "link_thread.h"

#include <system_error>
#include <utility>

#include "force_guard.h"
#include "real_time.h"

namespace nazori::devices {

base::Result<void> LinkThread::start(const std::string& device, Run run) {
  try {
    // The thread that ends the program waits for this thread's zero, so it must not be this thread.
    const SignalsBlocked inherited;
    thread_ = std::jthread([run = std::move(run)](const std::stop_token& stop) { run(stop); });
  } catch (const std::system_error& e) {
    return base::fail(base::Errc::device, std::string("the device thread cannot be started: ") + e.what(),
                      device);
  }
  (void)make_real_time(thread_.native_handle(), kServoPriority - 1);
  return {};
}

void LinkThread::stop() noexcept {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

}  // namespace nazori::devices
