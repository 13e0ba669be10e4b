// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "nazori/geometry/written_stroke.h"

namespace nazori::view {

/// The verdict on a stroke that the learner wrote, for display. Each has a colour, and the first three have a
/// sign next to the stroke's start, so that nothing depends on colour alone.
enum class Verdict : std::uint8_t {
  none,    ///< not judged: plain ink
  right,   ///< a tick
  nearly,  ///< an exclamation mark
  wrong,   ///< a cross
  shown,   ///< not the learner's: the model, as an overlay or a hint
};

/// A written stroke to be drawn on the face of the tablet.
struct InkedStroke {
  geometry::WrittenStroke<geometry::TabletFrame> points;  ///< [m]; times are not used
  Verdict verdict = Verdict::none;
  double opacity = 1;  ///< 0..1
  /// Half of the line's width [m], the same everywhere; absent: ink_half_width_m() of each point.
  std::optional<double> half_width_m = {};
};

/// Half of the width of the ink at a point [m]: wider for a stronger press and for a more tilted pen. Without
/// pressure the thinnest; without lean as with an upright pen.
[[nodiscard]] double ink_half_width_m(const geometry::WrittenPoint<geometry::TabletFrame>& point);

/// The stroke as drawn by a pen; pauses of the pen add nothing.
[[nodiscard]] InkedStroke inked(const geometry::WrittenStroke<geometry::TabletFrame>& stroke,
                                Verdict verdict);

}  // namespace nazori::view
