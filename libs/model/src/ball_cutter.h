// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/model/plate.h"

namespace nazori::model {

/// A ball above a plate. Thread-safe: yes.
class BallCutter {
 public:
  BallCutter(const Plate& plate, double radius_mm);
  /// How low the lowest point of the ball can go at a place without touching what must stay [mm above the
  /// upper face]; never above 0 over a plate without raised parts. Beyond the plate there is nothing to
  /// touch, but it is never lower than at the face.
  [[nodiscard]] double lowest_tip(PlatePoint at) const;

 private:
  int columns_;
  int rows_;
  double step_mm_;
  double radius_mm_;
  std::vector<float> heights_;  ///< above the upper face, with twice as many samples as the plate
};

}  // namespace nazori::model
