// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/geometry/frames.h"

namespace nazori::view {

/// The view of the tablet. Angles in radians; the default looks straight down on the tablet.
struct Camera {
  double azimuth = 0;         ///< turn about the tablet's normal, anticlockwise as seen from above
  double tilt = 0;            ///< from straight above (0) to grazing (below pi/2), towards the learner's edge
  double zoom = 1;            ///< 1 fits the tablet into the view; 0.2..20
  geometry::TabletPoint pan;  ///< the point of the plateau in the middle of the view [m]

  static constexpr double kMaxTilt = 1.40;  ///< 80 degrees: the plateau never becomes a line
  static constexpr double kMinZoom = 0.2;
  static constexpr double kMaxZoom = 20.0;
  static constexpr double kRestingTilt = 0.35;  ///< 20 degrees: grooves show their depth, strokes their shape
  static constexpr double kOrbitStep = 0.008;   ///< recommended turn per pixel of a drag [rad]
  static constexpr double kZoomStep = 1.15;     ///< recommended factor per notch of a wheel

  /// The initial view of a window, which "reset" restores (in Style::classic: the default camera, which is
  /// that of the 2005 program).
  [[nodiscard]] static Camera resting() { return {0, kRestingTilt, 1, {}}; }
};

/// The camera with every number inside its limits: azimuth in (-pi, pi], tilt in [0, kMaxTilt], zoom in
/// [kMinZoom, kMaxZoom], pan on the tablet of `shape`. Numbers that are not finite become the default's.
[[nodiscard]] Camera within_limits(const Camera& camera, const geometry::TabletShape& shape = {});

/// Interpolates from `from` (t = 0) to `to` (t = 1), turning the shorter way round and zooming at a constant
/// rate. For animated moves.
[[nodiscard]] Camera between(const Camera& from, const Camera& to, double t);

}  // namespace nazori::view
