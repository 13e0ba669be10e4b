// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace nazori::devices {

/// When each tick of RtThread was due. That thread skips the whole periods that have passed when a tick ends,
/// so a tick that is five periods late is reported as five periods late.
class DueTimes {
 public:
  /// @param period_s  > 0.
  explicit DueTimes(double period_s) : period_s_(period_s) {}

  /// How late a tick begins. @param begin_s  since the start of the thread.
  [[nodiscard]] double lateness_s(double begin_s) const noexcept {
    return std::max(begin_s - due_ * period_s_, 0.0);
  }

  /// The tick has ended: the next one is due a period later, or at the last period that has begun by now.
  void ended(double end_s) noexcept {
    due_ += 1;
    const double behind = end_s / period_s_ - due_;
    if (behind >= 1) due_ += std::floor(behind);
  }

 private:
  double period_s_;
  double due_ = 0;  // periods since the start
};

}  // namespace nazori::devices
