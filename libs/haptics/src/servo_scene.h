// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "nazori/haptics/haptic_scene.h"
#include "nazori/haptics/stroke_constraint.h"
#include "nazori/haptics/stroke_index.h"
#include "nazori/haptics/surface_contact.h"
#include "nazori/haptics/tablet_surface.h"

namespace nazori::haptics {

/// A HapticScene turned into what a tick needs: coefficients in SI, within the limits of one device, and the
/// index of the strokes. Made and freed by the thread that hands the scene over.
struct ServoScene {
  ServoScene(std::shared_ptr<const HapticScene> scene, const DeviceDescription& device, std::uint64_t number);

  std::shared_ptr<const HapticScene> scene;
  std::uint64_t generation;
  TabletSurface surface;
  Friction friction;
  double stiffness_n_m = 0;
  double damping_n_s_m = 0;
  double popthrough_n = 0;  ///< 0: off
  StrokeIndex strokes;      ///< empty while snapping is off
  StrokeConstraint::Settings snap;
};

}  // namespace nazori::haptics
