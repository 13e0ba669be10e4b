// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nazori/brush/pen.h"
#include "nazori/calligraphy/brush_widths.h"
#include "nazori/calligraphy/ruling.h"

namespace nazori::calligraphy {

/// How fast the teacher writes: slowly, so that learners can follow. Speeds are in m/s on the sheet.
struct HandPace {
  double body_m_s = 0.045;
  double bend_m_s = 0.022;   ///< where a stroke starts, and where its line turns sharply
  double sweep_m_s = 0.06;   ///< where a stroke thins out at its end
  double air_m_s = 0.12;     ///< from one stroke to the next
  double least_air_s = 0.4;  ///< however near that is
  double rest_s = 0.16;      ///< pressed at a stop
};

/// The movement of a pen that writes models, stroke by stroke: pressed as hard as the brush needs to be as
/// broad as they are, set down with its tip first, slow at starts and in sharp turns, at rest at stops, fast
/// in sweeps, and lifted in between.
/// @param strokes  in writing order, each with at least one point. @param widths  of the brush.
/// @return samples whose times ascend from 0; the last one is off the paper. Empty for no strokes.
[[nodiscard]] std::vector<brush::PenSample> teacher_hand(std::span<const ModelStroke> strokes,
                                                         const BrushWidths& widths,
                                                         const HandPace& pace = {});

}  // namespace nazori::calligraphy
