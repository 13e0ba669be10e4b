// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "nazori/geometry/frames.h"
#include "nazori/haptics/haptic_device.h"
#include "nazori/surface/smooth_surface.h"

namespace nazori::haptics {

/// The surface's material, in the terms of 2005: each 0..1 of the device's maximum.
struct Material {
  double stiffness = 0.8;
  double damping = 0.0;
  double static_friction = 0.0;   ///< coefficient of the friction cone
  double dynamic_friction = 0.0;  ///< at most static_friction
  double popthrough = 0.0;        ///< 0 off; else the fraction of the device's peak force that pushes through
};

/// A stroke that can hold the stylus: its centre line in metres, z the depth of the groove there (<= 0).
struct StrokePath {
  std::vector<Vec3> points;
};

/// How strokes attract.
struct Snapping {
  bool enabled = false;
  double stiffness = 0.2;  ///< 0..1 of the device's maximum
  /// [m]; 0: the rule of 2005, pull-off force (5 N) / the device's maximum stiffness.
  double snap_distance_m = 0;
  int stroke = 0;  ///< 0 = all, n = only stroke n
  /// [N]; 0: what the spring pulls with at the snap distance. Held to at least that: a stroke does not let go
  /// where it would catch again at once.
  double release_force_n = 0;
};

/// Everything the servo feels, immutable once handed over.
struct HapticScene {
  std::shared_ptr<const surface::SmoothSurface> surface;  ///< may be null: nothing to touch
  geometry::TabletShape shape;
  Material material;
  std::vector<StrokePath> strokes;
  Snapping snapping;
};

}  // namespace nazori::haptics
