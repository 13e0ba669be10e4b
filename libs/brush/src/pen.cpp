// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/pen.h"

#include <algorithm>
#include <cmath>

namespace nazori::brush {
namespace {

/// The pressure of a hand that moves with `speed_m_s`.
double pressure_at(double speed_m_s, const Handling& handling) {
  const double slow = std::max(handling.slow_m_s, 1e-6), fast = std::max(handling.fast_m_s, 2e-6);
  if (speed_m_s <= slow) return kSlowPressure;
  if (speed_m_s >= fast) return kFastPressure;
  // Hands tell speeds apart by their ratio.
  const double share = std::log(speed_m_s / slow) / std::log(fast / slow);
  return kSlowPressure + share * (kFastPressure - kSlowPressure);
}

}  // namespace

PenToHolder::PenToHolder(const TuftForm& form, const Handling& handling)
    : hair_m_(form.hair_m), handling_(handling) {}

HolderPose PenToHolder::next(const PenSample& sample) noexcept {
  HolderPose pose;
  pose.time_s = sample.time_s;
  pose.at = sample.at;
  pose.lean_rad = sample.lean_rad;
  pose.lean_to_rad = sample.lean_to_rad;
  pose.twist_rad = sample.twist_rad;
  const double deepest = handling_.full_depth * hair_m_;
  if (sample.height_m) {
    pose.depth_m = -*sample.height_m;
  } else if (!sample.down) {
    pose.depth_m = -handling_.lifted_m;
    guessed_ = 0;
  } else if (sample.pressure) {
    pose.depth_m = deepest * *sample.pressure;
  } else if (!handling_.guess_pressure) {
    pose.depth_m = deepest * handling_.steady_pressure;
  } else {
    if (!before_ || !before_->down) guessed_ = kTouchPressure;
    if (before_ && before_->down) {
      const double seconds = sample.time_s - before_->time_s;
      if (seconds > 0) {
        const double wanted = pressure_at(geometry::distance(before_->at, sample.at) / seconds, handling_);
        guessed_ = wanted + (guessed_ - wanted) * std::exp(-seconds / handling_.settles_s);
      }
    }
    pose.depth_m = deepest * guessed_;
  }
  before_ = sample;
  return pose;
}

}  // namespace nazori::brush
