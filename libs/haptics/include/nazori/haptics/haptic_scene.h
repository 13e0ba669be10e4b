// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "nazori/geometry/frames.h"
#include "nazori/haptics/friction_zones.h"
#include "nazori/haptics/haptic_device.h"
#include "nazori/haptics/soft_tip.h"
#include "nazori/surface/smooth_surface.h"

namespace nazori::haptics {

/// What a surface feels like to a tip that slides over it: a tilt of the contact force, not a height.
enum class Texture : std::uint8_t {
  none,
  paper,  ///< fine, the same in all directions
  wood,   ///< grain along x: rough across it, smooth along it
  stone,  ///< coarse with fine grit, the same in all directions
};

/// The surface's material, in the units of the 2005 program: each 0..1 of the device's maximum.
struct Material {
  double stiffness = 0.8;
  double damping = 0.0;
  double static_friction = 0.0;   ///< coefficient of the friction cone
  double dynamic_friction = 0.0;  ///< at most static_friction
  double popthrough =
      0.0;  ///< 0 off; else the fraction of the device's peak force at which the tip breaks through
  Texture texture = Texture::none;
  double roughness = 0.5;  ///< 0..1, of the texture: at 1 the force tilts by at most 27 degrees
};

/// A stroke that can attract the stylus: its centre line in metres, z the depth of the groove there (<= 0).
struct StrokePath {
  std::vector<Vec3> points;
};

/// How strokes attract.
struct Snapping {
  bool enabled = false;
  double stiffness = 0.2;  ///< 0..1 of the device's maximum
  /// [m]; 0: the rule of the 2005 program, pull-off force (5 N) / the device's maximum stiffness.
  double snap_distance_m = 0;
  int stroke = 0;  ///< 0 = all, n = only stroke n
  /// [N]; 0: the spring's force at the snap distance. At least that force: a stroke must not release the
  /// stylus where it would capture it again at once.
  double release_force_n = 0;
};

/// What guidance does.
enum class GuidingMode : std::uint8_t {
  off,      ///< no order, no direction
  lesson,   ///< only the stroke to be written attracts, from its start in its direction; the learner moves
  lead,     ///< the force leads the stylus along the strokes as a teacher would, and waits for the learner
  disturb,  ///< nothing helps; a slow random force disturbs the writing, for advanced learners
};

/// How the learner is guided through the strokes in their order. In lesson and lead mode only guidance
/// attracts the stylus to a stroke: Snapping has no effect.
///
/// A scene with the same strokes, mode, first stroke and attempt as the previous scene continues where that
/// one was, so strength may change in the middle of a stroke. Any other scene restarts the guidance.
struct Guiding {
  GuidingMode mode = GuidingMode::off;
  /// 0..1, scales every force of guidance, also the disturbance. 0: no help, only events.
  double strength = 1;
  int stroke =
      1;  ///< first stroke to be written, from 1; nothing is to be written if there is no such stroke
  std::uint32_t attempt = 0;   ///< another number restarts the guidance
  double cap_n = 0.8;          ///< largest force of guidance at strength 1, 0..1 N
  double speed_m_s = 0.04;     ///< the teacher's speed on a straight line, 0.005..0.2
  double disturbance_n = 0.4;  ///< largest force of disturb mode at strength 1, 0..1 N
  std::uint64_t seed = 1;      ///< of the disturbance: same seed, same force
};

/// Everything that the servo computes forces from; immutable once it is passed to the servo.
struct HapticScene {
  /// May be null: nothing to touch. For a ball: surface::surface_for_ball of the tablet's map.
  std::shared_ptr<const surface::SmoothSurface> surface;
  geometry::TabletShape shape;
  Material material;
  /// May be null: the material's friction everywhere. Zones of another size than the surface have no effect.
  std::shared_ptr<const FrictionZones> friction_zones;
  std::vector<StrokePath> strokes;
  Snapping snapping;
  Guiding guiding;
  /// Not null: the tip bends on a flat sheet at z = 0, and there is no surface; of the material only texture
  /// and roughness have an effect.
  std::shared_ptr<const SoftTip> soft_tip;
  /// Radius of the ball that `surface` is made for, 0..surface::kLargestBall_m [m]; 0: the tip is a point.
  /// Positions of the device and of the proxy are those of the ball's lowest point. Friction zones and
  /// texture are felt where the ball touches, and strokes lie no deeper than its lowest point comes.
  double tip_radius_m = 0;
};

}  // namespace nazori::haptics
