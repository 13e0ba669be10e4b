// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "nazori/brush/tuft.h"

namespace nazori::brush {

/// Leads the foot of the holder so that the patch of contact follows the pen, as a writer aims with the ink.
/// The patch is towed behind the foot: it follows a line when the foot is ahead of it along the line's
/// direction, by as much as the hair is bent. Thread-safe: no.
class Aim {
 public:
  /// @cost some milliseconds: finds out how far this tuft bends under each depth.
  explicit Aim(const TuftForm& form);

  /// Moves the foot of a pose from the pen to where it belongs. Off the paper it stays at the pen, and the
  /// next stroke starts as the brush points then. @param pose  that is to be taken next, in metres on the
  /// sheet.
  /// @param tuft  as it is now, before that.
  void lead(HolderPose& pose, const Tuft& tuft);

 private:
  static constexpr std::size_t kSteps = 12;
  [[nodiscard]] double usual_reach_m(double depth_m) const;
  [[nodiscard]] geometry::PaperPoint foot(geometry::PaperPoint pen, double depth_m, const Tuft& tuft);

  double step_m_;                             ///< of depth
  std::array<double, kSteps + 1> reach_m_{};  ///< of a tuft that is drawn at a depth
  std::optional<geometry::PaperPoint> before_;
  double ahead_rad_ = 0;  ///< from the ink to the foot, from x to y
  double depth_m_ = 0;    ///< of the pose before
};

}  // namespace nazori::brush
