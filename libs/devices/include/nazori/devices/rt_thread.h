// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "nazori/base/result.h"

namespace nazori::devices {

/// The timing of a clock thread.
struct ClockStatus {
  bool running = false;
  bool real_time = false;     ///< scheduled before all ordinary threads
  bool stack_locked = false;  ///< its stack is locked in memory
  std::string message;        ///< one sentence for people when it is not real-time, else empty
  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;   ///< periods that passed without a tick
  double max_lateness_s = 0;  ///< latest wake-up after its due time
};

/// The clock thread for devices that have none of their own: calls a function at a fixed rate against
/// absolute times of the monotonic clock, so lateness does not add up. Scheduled SCHED_FIFO where the system
/// allows it. A missed period is counted and skipped, never made up for in a burst. Before the first call the
/// thread's stack is in memory; while it runs, the program's memory is not paged out where the system's
/// memlock limit allows that (docs/devices.md, Keeping time). Thread rules: all members by one thread (the
/// interface); the function runs on the clock thread.
class RtThread {
 public:
  /// @param now_s  seconds since start(), read just before the call.
  using Tick = std::function<void(double now_s)>;

  RtThread();
  ~RtThread();
  RtThread(const RtThread&) = delete;
  RtThread& operator=(const RtThread&) = delete;

  /// @param period_s  1e-5..1. @param tick  must not throw or wait.
  /// @return Errc::bad_argument for the period, Errc::device when it is running or no thread can be made.
  [[nodiscard]] base::Result<void> start(double period_s, Tick tick);
  /// Returns after the last tick has returned. Has no effect when not running; must not be called from the
  /// tick.
  void stop() noexcept;
  [[nodiscard]] ClockStatus status() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::devices
