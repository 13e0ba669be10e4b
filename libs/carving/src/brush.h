// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/carving/carve.h"

namespace nazori::carving {

/// Parts of a stroke over which the brush changes, arc lengths in glyph units.
struct BrushZones {
  double entry_end;     ///< where the press at entry ends
  double ending_start;  ///< the ending begins
  double body_end;      ///< where the brush stops: before a hook, else the end
};

[[nodiscard]] BrushZones zones_of(const Brush& brush, kanji::StrokeEnding ending, double length,
                                  double hook_length);

}  // namespace nazori::carving
