// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/base/result.h"
#include "nazori/model/mesh.h"
#include "nazori/model/plate.h"

namespace nazori::model {

/// A pair of feet that hold a plate leaning back, as an easel does.
struct StandSettings {
  double plate_height_mm = 100;   ///< of the plate that leans in the feet, 20..600
  double plate_thickness_mm = 6;  ///< 0.4..100
  double clearance_mm = 0.4;      ///< what the slot is wider than the plate, 0..2
  double lean_deg = 20;           ///< from upright, 5..45
  double width_mm = 10;           ///< of each foot, 3..50
};

/// The side view of a foot, counter-clockwise: x to the back, y up, standing on y = 0. A slot that is open at
/// the top holds the plate; the foot reaches so far back that the middle of the plate lies over it.
/// @return Errc::bad_argument for a setting out of range.
[[nodiscard]] base::Result<PlateLine> stand_outline(const StandSettings& settings = {});

/// Two feet lying on their side next to each other: printed flat, without supports. @return as
/// stand_outline().
[[nodiscard]] base::Result<Mesh> stand_mesh(const StandSettings& settings = {});

}  // namespace nazori::model
