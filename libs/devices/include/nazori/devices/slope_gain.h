// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/geometry/point.h"
#include "nazori/haptics/tablet_surface.h"

namespace nazori::devices {

/// Lets the eye feel what the hand cannot: the stylus of a mouse goes slower up a slope and faster down, so
/// it stays in a groove as if held. Over the plateau nothing changes. The stylus never strays farther than
/// kStray_m from the pointer.
/// @source A. Lécuyer, J.-M. Burkhardt, L. Etienne, Feeling bumps and holes without a haptic interface: the
/// perception of pseudo-haptic textures, CHI 2004.
class SlopeGain {
 public:
  static constexpr double kLeast = 0.3, kMost = 3;
  static constexpr double kStray_m = 0.006;

  /// How much faster than the pointer the stylus goes where the surface rises by `slope` along its way.
  [[nodiscard]] static double gain(double slope);

  /// Where the stylus is when the pointer is at `pointer`; the first after reset() is there itself.
  [[nodiscard]] geometry::TabletPoint follow(geometry::TabletPoint pointer,
                                             const haptics::TabletSurface& surface);
  /// The stylus was lifted.
  void reset() { pointer_.reset(); }

 private:
  std::optional<geometry::TabletPoint> pointer_;
  geometry::TabletPoint stylus_{};
};

}  // namespace nazori::devices
