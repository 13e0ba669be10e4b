// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>

#include "nazori/base/progress.h"

namespace nazori::functions {

/// Shares one caller's Progress among the parts of a piece of work and remembers a stop.
class WorkProgress {
 public:
  explicit WorkProgress(const base::Progress& caller) : caller_(caller) {}

  /// What follows is the part from `low` to `high` of the whole.
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
    return !stopped_;
  }
  [[nodiscard]] bool is_stopped() const { return stopped_; }

 private:
  const base::Progress& caller_;
  double low_ = 0;
  double high_ = 1;
  double last_ = 0;
  std::string_view step_;
  bool stopped_ = false;
};

}  // namespace nazori::functions
