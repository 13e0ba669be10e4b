// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "nazori/geometry/point.h"

namespace nazori::writing {

/// Where the learner writes: any units, x right, y **down**. Pixels, millimetres or 0..1, it does not matter.
struct InkFrame {};
using InkPoint = geometry::Point2<InkFrame>;

/// One stroke as the pen drew it.
struct InkStroke {
  geometry::Polyline<InkFrame> points;  ///< in writing direction
  std::vector<double> times_s;          ///< of each point, seconds from any zero; or empty
  std::vector<double> pressures;        ///< of each point, 0..1; or empty
};

/// The square that was offered for writing.
struct WritingBox {
  InkPoint corner;  ///< top left
  double side = 1;  ///< > 0
};

/// What was written of one character, in the order it was written.
struct Ink {
  std::vector<InkStroke> strokes;
  /// Where known: it decides only what the strokes themselves leave open (which bar of 三 is missing).
  std::optional<WritingBox> box;
};

}  // namespace nazori::writing
