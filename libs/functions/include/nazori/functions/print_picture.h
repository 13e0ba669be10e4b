// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/plate.h"

namespace nazori::functions {

struct PrintSettings {
  double side_mm = 160;     ///< of the window on paper, 50 to 400
  int dots_per_inch = 300;  ///< 72 to 600
  bool axes = true;         ///< with ticks
};

/// A picture in pure black and white for paper that swells where it is black, and for eyes that need
/// contrast: curves 1.6 mm wide, axes 0.7 mm, ticks, a frame; each curve with its own line style (solid,
/// dashed, dotted, dash and dot), regions hatched; everything less important is interrupted 2 mm beside a
/// curve.
/// @return 1 white, 0 black, one sample per printed dot; Errc::bad_argument for settings out of range.
/// @source BANA guidelines for tactile graphics: lines differ by style, gaps where they cross.
[[nodiscard]] base::Result<surface::HeightMap> print_picture(const Tracing& tracing,
                                                             const PrintSettings& settings = {});

}  // namespace nazori::functions
