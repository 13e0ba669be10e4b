// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "disturbance.h"
#include "guidance.h"
#include "guidance_plan.h"
#include "nazori/haptics/haptic_scene.h"
#include "nazori/haptics/soft_contact.h"
#include "nazori/haptics/stroke_constraint.h"
#include "nazori/haptics/stroke_index.h"
#include "nazori/haptics/surface_contact.h"
#include "nazori/haptics/tablet_surface.h"

namespace nazori::haptics {

/// A HapticScene converted into the data a tick needs: coefficients in SI, within the limits of one device,
/// and the index of the strokes. Made and freed by the thread that passes the scene.
struct ServoScene {
  /// @param before  the previous scene, null for the first: guidance may continue from it.
  ServoScene(std::shared_ptr<const HapticScene> scene, const DeviceDescription& device, std::uint64_t number,
             const ServoScene* before);

  std::shared_ptr<const HapticScene> scene;
  std::uint64_t generation;
  TabletSurface surface;
  SoftTipTable soft;
  const SoftTip* soft_tip = nullptr;  ///< of `scene`, to compare it
  /// Friction of each zone of the surface; the first is of the material alone.
  std::vector<Friction> frictions;
  double stiffness_n_m = 0;
  double damping_n_s_m = 0;
  double popthrough_n = 0;  ///< 0: off
  Texture texture = Texture::none;
  double roughness = 0;
  double tip_radius_m = 0;
  StrokeIndex strokes;  ///< empty while snapping is off
  StrokeConstraint::Settings snap;
  std::uint64_t lesson = 0;  ///< another number: another lesson
  std::int32_t first_stroke = 1;
  GuidancePlan plan;  ///< empty while guidance is off
  Guidance::Settings guide;
  Disturbance disturbance;

  /// Friction at a point of the surface; beyond its edge the material's.
  [[nodiscard]] const Friction& friction_at(const Vec3& p) const noexcept {
    if (zones == nullptr) return frictions[0];
    const double column = std::floor((p.x + half_m) * zones_per_m + 0.5);
    const double row = std::floor((half_m - p.y) * zones_per_m + 0.5);
    const int size = zones->size;
    if (!(column >= 0 && row >= 0 && column < size && row < size)) return frictions[0];
    const std::size_t i =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
    return frictions[zones->zone[i]];
  }
  const FrictionZones* zones = nullptr;  ///< of `scene`; null: the material's friction everywhere
  double half_m = 0;
  double zones_per_m = 0;
};

}  // namespace nazori::haptics
