// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/practice/tablet_control.h"
#include "nazori/writing/written_character.h"

namespace nazori::cli {

/// Writes strokes on a tablet as a pen would: the strokes of a request, sample by sample.
class PractisedHand {
 public:
  /// @param tablet  outlives this.
  explicit PractisedHand(practice::TabletControl& tablet) : tablet_(tablet) {}

  /// Writes one stroke and lifts the pen at its end. @param stroke  in `box`, x right, y down; its times [s]
  /// and pressures are used where it has them.
  void write(const std::vector<writing::WrittenPoint>& stroke, const writing::WritingBox& box);

 private:
  void sample(geometry::TabletPoint at, bool touching, double pressure);

  practice::TabletControl& tablet_;
  double time_s_ = 0;
};

}  // namespace nazori::cli
