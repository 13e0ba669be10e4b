// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <string_view>

#include "nazori/base/progress.h"

namespace nazori::functions {

/// Divides a caller's Progress among the parts of an operation and records a request to stop.
class WorkProgress {
 public:
  /// @param most_milliseconds  time after which report() requests a stop; 0: never.
  explicit WorkProgress(const base::Progress& caller, double most_milliseconds = 0)
      : caller_(caller), most_(most_milliseconds) {}

  /// The work that follows is the part from `low` to `high` of the whole.
  void begin_part(double low, double high, std::string_view step) {
    low_ = low;
    high_ = high;
    step_ = step;
    (void)report(0);
  }
  /// @param done  of the present part, 0 to 1. @return false when the work must stop.
  bool report(double done) {
    if (!stopped_ && caller_) {
      last_ = std::max(last_, low_ + (high_ - low_) * std::clamp(done, 0.0, 1.0));
      stopped_ = !caller_(last_, step_);
    }
    return !stopped_ && is_in_time();
  }
  /// The same without a progress value; cheap enough for every box.
  bool is_in_time() {
    if (most_ > 0 && !late_ && ++asked_ % kEvery == 0)
      late_ = std::chrono::duration<double, std::milli>(Clock::now() - start_).count() > most_;
    return !late_;
  }
  /// Whether it was stopped, by the caller or by the time limit.
  [[nodiscard]] bool is_stopped() const { return stopped_ || late_; }
  [[nodiscard]] bool is_late() const { return late_ && !stopped_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr unsigned kEvery = 16;

  const base::Progress& caller_;
  double most_;
  Clock::time_point start_ = Clock::now();
  unsigned asked_ = 0;
  double low_ = 0;
  double high_ = 1;
  double last_ = 0;
  std::string_view step_;
  bool stopped_ = false;
  bool late_ = false;
};

}  // namespace nazori::functions
