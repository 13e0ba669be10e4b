// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/held_brush.h"

#include <algorithm>

namespace nazori::brush {
namespace {

/// The tip touches the paper so long before the first sample of a stroke, where the samples are farther
/// apart.
constexpr double kTouchesBefore_s = 0.5e-3;

PenSample lifted() {
  PenSample pen;
  pen.down = false;
  return pen;
}

}  // namespace

HeldBrush::HeldBrush(const TuftForm& form, const Handling& handling)
    : handling_(handling), tuft_(form), holder_(form, handling), aim_(form), pen_(lifted()) {}

void HeldBrush::set_handling(const Handling& handling) {
  handling_ = handling;
  holder_ = PenToHolder(tuft_.form(), handling);
}

std::span<const geometry::BristleSegment> HeldBrush::move(const PenSample& sample, double wetness) {
  swept_.clear();
  tuft_.set_wetness(wetness);
  const bool was_down = pen_.is_down();
  if (sample.is_down() && !was_down) touch_down(sample);
  HolderPose pose = holder_.next(sample);
  aim_.lead(pose, tuft_);
  // The foot comes back to the pen before the tip leaves the paper, so that the stroke ends there.
  if (pose.depth_m <= 0 && was_down) {
    HolderPose leaves = pose;
    leaves.depth_m = 0;
    leaves.time_s = pen_.time_s + (pose.time_s - pen_.time_s) / 2;
    tuft_.move_to(leaves, swept_);
  }
  tuft_.move_to(pose, swept_);
  pen_ = sample;
  return swept_;
}

/// The brush is above the place where it comes down, wherever it was before, and its tip touches there first.
void HeldBrush::touch_down(const PenSample& sample) {
  PenSample above = sample;
  above.down = false;
  if (above.height_m) above.height_m = handling_.lifted_m;
  above.time_s = std::max(pen_.time_s, sample.time_s - kTouchesBefore_s);
  HolderPose pose = holder_.next(above);
  pose.depth_m = 0;
  tuft_.move_to(pose, swept_);
}

}  // namespace nazori::brush
