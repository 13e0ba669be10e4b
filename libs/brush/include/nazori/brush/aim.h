// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/brush/tuft.h"

namespace nazori::brush {

/// Leads the foot of the holder so that the patch of contact follows the pen, as a writer aims with the ink.
/// The patch is towed behind the foot: it follows a line when the foot is ahead of it along the line's
/// direction. Thread-safe: no.
class Aim {
 public:
  /// Where the foot belongs while the pen is on the paper at `pen`. @param tuft  as it is now.
  [[nodiscard]] geometry::PaperPoint foot(geometry::PaperPoint pen, const Tuft& tuft);
  /// The pen is off the paper: the next stroke starts as the brush points.
  void lift(double points_to_rad);

 private:
  std::optional<geometry::PaperPoint> before_;
  geometry::PaperPoint ahead_{0.7, -0.7};
  double lead_m_ = 0;
};

}  // namespace nazori::brush
