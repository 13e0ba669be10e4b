// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace nazori::base {

/// The source of the current time, replaceable in tests. There are two times: calendar time, which may be set
/// and so jump, and steady time, which only goes forward and measures durations. Any thread, unless a derived
/// class says otherwise.
class Clock {
 public:
  using Calendar = std::chrono::sys_time<std::chrono::milliseconds>;
  using Steady = std::chrono::steady_clock::time_point;

  Clock() = default;
  virtual ~Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;

  /// Milliseconds since 1970-01-01 00:00 UTC.
  [[nodiscard]] virtual Calendar calendar() const = 0;
  [[nodiscard]] virtual Steady steady() const = 0;
};

/// The clocks of the system.
class SystemClock final : public Clock {
 public:
  [[nodiscard]] Calendar calendar() const override;
  [[nodiscard]] Steady steady() const override;
};

/// A clock that stands still until a test advances it. Thread: one.
class ManualClock final : public Clock {
 public:
  explicit ManualClock(Calendar start) : calendar_(start) {}
  [[nodiscard]] Calendar calendar() const override { return calendar_; }
  [[nodiscard]] Steady steady() const override { return steady_; }
  /// Turns both times forward.
  void advance(std::chrono::milliseconds by);
  /// Sets the calendar time, as a user may set the computer's clock. The steady time does not change.
  void set_calendar(Calendar time) { calendar_ = time; }

 private:
  Calendar calendar_;
  Steady steady_{};
};

}  // namespace nazori::base
