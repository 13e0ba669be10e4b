// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/geometry/written_stroke.h"

namespace nazori::writing {

/// The frame of writing: any unit, x right, y **down**. Pixels, millimetres or 0..1 are equally good.
struct WritingFrame {};
using WritingPoint = geometry::Point2<WritingFrame>;
using WrittenPoint = geometry::WrittenPoint<WritingFrame>;
using WrittenStroke = geometry::WrittenStroke<WritingFrame>;

/// The square in which the learner writes.
struct WritingBox {
  WritingPoint corner;  ///< top left
  double side = 1;      ///< > 0
};

/// The written strokes of one character. All points of a stroke have times or none, and all have pressures or
/// none; lean is not used.
struct WrittenCharacter {
  geometry::WrittenStrokes<WritingFrame> strokes;
  /// If known: used only where the strokes themselves are ambiguous (which bar of 三 is missing).
  std::optional<WritingBox> box;
};

}  // namespace nazori::writing
