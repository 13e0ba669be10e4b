// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace nazori::haptics {

/// A tip that bends on a flat sheet at z = 0, as a brush does, instead of a hard one on a carved surface.
/// Immutable once it is in a scene.
struct SoftTip {
  double step_m = 0.001;  ///< between two values of `push_n`, > 0
  /// Push of the sheet [N] at depths 0, step_m, 2 step_m and so on, >= 0. Deeper than the last it stays. The
  /// servo makes it rise and fall no faster than the device can render.
  std::vector<double> push_n;
  double friction = 0.3;     ///< coefficient between tip and sheet, >= 0
  double along_hair = 0;     ///< 0..1: share of it that is missing where the hair trails behind the tip
  double sideways_n_m = 10;  ///< stiffness by which the tip resists before it slips, > 0
  double tow_m = 0.02;       ///< length at which the hair trails, > 0
};

}  // namespace nazori::haptics
