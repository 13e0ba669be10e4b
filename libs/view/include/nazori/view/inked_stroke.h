// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "nazori/geometry/written_stroke.h"

namespace nazori::view {

/// What is said of a stroke that the learner wrote. Each has a colour, and the first three a sign beside the
/// stroke's start, so that nothing hangs on colour alone.
enum class Verdict : std::uint8_t {
  none,    ///< not judged: plain ink
  right,   ///< a tick
  nearly,  ///< an exclamation mark
  wrong,   ///< a cross
  shown,   ///< not the learner's: the model, laid over or given as a hint
};

/// A written stroke as it is drawn on the face of the tablet.
struct InkedStroke {
  geometry::WrittenStroke<geometry::TabletFrame> points;  ///< [m]; times are not used
  Verdict verdict = Verdict::none;
  double opacity = 1;  ///< 0..1
  /// Half of the line's width [m], the same everywhere; absent: ink_half_width_m() of each point.
  std::optional<double> half_width_m = {};
};

/// Half of the width of the ink at a point [m]: more for a firmer press, and for a pen that lies flatter.
/// Without pressure the thinnest; without lean as of an upright pen.
[[nodiscard]] double ink_half_width_m(const geometry::WrittenPoint<geometry::TabletFrame>& point);

/// The stroke as a pen draws it: the pen at rest draws nothing.
[[nodiscard]] InkedStroke inked(const geometry::WrittenStroke<geometry::TabletFrame>& stroke,
                                Verdict verdict);

}  // namespace nazori::view
