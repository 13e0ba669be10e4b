// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "nazori/haptics/soft_contact.h"

namespace nazori::haptics {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A tip that pushes more and more, then less: 0, 0.1, 0.4, 0.3, 0.5 N at 0 to 20 mm.
inline SoftTip brush() {
  SoftTip tip;
  tip.step_m = 0.005;
  tip.push_n = {0, 0.1, 0.4, 0.3, 0.5};
  tip.friction = 0.3;
  tip.along_hair = 0.4;
  tip.sideways_n_m = 20;
  tip.tow_m = 0.01;
  return tip;
}
inline SoftTipTable table(const SoftTip& tip = brush()) { return {tip, 500, 3.3}; }

inline double sideways(const Vec3& force) { return std::hypot(force.x, force.y); }

}  // namespace nazori::haptics
