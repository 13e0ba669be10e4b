// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/geometry/written_stroke.h"

namespace nazori::writing {

/// Where the learner writes: any units, x right, y **down**. Pixels, millimetres or 0..1, it does not matter.
struct WritingFrame {};
using WritingPoint = geometry::Point2<WritingFrame>;
using WrittenPoint = geometry::WrittenPoint<WritingFrame>;
using WrittenStroke = geometry::WrittenStroke<WritingFrame>;

/// The square that was offered for writing.
struct WritingBox {
  WritingPoint corner;  ///< top left
  double side = 1;      ///< > 0
};

/// What was written of one character. Of the points of a stroke all or none have times, and all or none have
/// pressures; lean is not used.
struct WrittenCharacter {
  geometry::WrittenStrokes<WritingFrame> strokes;
  /// Where known: it decides only what the strokes themselves leave open (which bar of 三 is missing).
  std::optional<WritingBox> box;
};

}  // namespace nazori::writing
