// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/geometry/point.h"
#include "nazori/haptics/tablet_surface.h"

namespace nazori::devices {

/// Pseudo-haptic feedback for a mouse: the displayed stylus moves slower up a slope and faster down, so it
/// tends to stay in a groove. On the plateau nothing changes. The stylus is never farther than kStray_m from
/// the pointer.
/// @source A. Lécuyer, J.-M. Burkhardt, L. Etienne, Feeling bumps and holes without a haptic interface: the
/// perception of pseudo-haptic textures, CHI 2004.
class SlopeGain {
 public:
  static constexpr double kLeast = 0.3, kMost = 3;
  static constexpr double kStray_m = 0.006;

  /// Ratio of the stylus's speed to the pointer's where the surface rises by `slope` in the direction of
  /// motion.
  [[nodiscard]] static double gain(double slope);

  /// The position of the stylus when the pointer is at `pointer`; after reset() the first one is `pointer`
  /// itself.
  [[nodiscard]] geometry::TabletPoint follow(geometry::TabletPoint pointer,
                                             const haptics::TabletSurface& surface);
  /// The stylus was lifted.
  void reset() { pointer_.reset(); }

 private:
  std::optional<geometry::TabletPoint> pointer_;
  geometry::TabletPoint stylus_{};
};

}  // namespace nazori::devices
