// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/paint/sheet.h"
#include "nazori/surface/height_map.h"

namespace nazori::paint {

/// How paint becomes a relief. Heights are those of a HeightMap, 0 to 1.
struct ReliefOptions {
  double paper = 0.3;        ///< height of bare paper, 0..1
  double per_filling = 0.1;  ///< what a cell rises for each kOne of pigment, of whatever layer and kind, >= 0
  double tooth = 0.01;       ///< height of the grain of bare paper; it fades under paint, >= 0
  double smooth_m = 0.0003;  ///< paint is level over this distance, 0..0.002
};

/// The sheet with its paint as a height map of as many samples a side as the sheet has cells. More paint is
/// never lower. Height is limited to 1.
[[nodiscard]] surface::HeightMap relief_of(const Sheet& sheet, const ReliefOptions& options = {});

}  // namespace nazori::paint
