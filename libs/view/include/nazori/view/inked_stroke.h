// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/geometry/written_stroke.h"

namespace nazori::view {

/// The verdict on a stroke that the learner wrote, for display. Only what should be written otherwise has a
/// colour of its own and a sign next to the stroke's start, so that nothing depends on colour alone.
enum class Verdict : std::uint8_t {
  none,    ///< not judged: plain ink
  right,   ///< plain ink, too
  nearly,  ///< an exclamation mark
  wrong,   ///< a cross
  shown,   ///< not the learner's: the model, as an overlay or a hint
};

/// A written stroke to be drawn on the face of the tablet.
struct InkedStroke {
  geometry::WrittenStroke<geometry::TabletFrame> points;  ///< [m]; times are not used
  Verdict verdict = Verdict::none;
  double opacity = 1;  ///< 0..1
  /// Half of the line's width [m], the same everywhere; absent: that of each point.
  std::optional<double> half_width_m = {};
  std::vector<double> half_widths_m = {};  ///< of each point [m]; empty: ink_half_width_m() of each

  /// Half of the width at point i [m].
  [[nodiscard]] double half_width_at(std::size_t i) const;
};

/// Half of the width of the ink at a point [m]: wider for a stronger press and for a more tilted pen. Without
/// pressure the thinnest; without lean as with an upright pen.
[[nodiscard]] double ink_half_width_m(const geometry::WrittenPoint<geometry::TabletFrame>& point);

/// The stroke as drawn with a brush: it opens where the brush comes down, is thinner where the hand was fast,
/// ends in a point where the hand did not stop, and is wider where the pen was pressed. Pauses of the pen add
/// nothing.
/// @param has_ended  false: it is still being written, so its end is as wide as its middle.
[[nodiscard]] InkedStroke inked(const geometry::WrittenStroke<geometry::TabletFrame>& stroke, Verdict verdict,
                                bool has_ended = true);

}  // namespace nazori::view
