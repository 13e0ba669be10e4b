// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stroke_picture.h"

namespace nazori::writing {

/// A drawn line without the trembling of the hand: at most 48 points at equal steps, each the mean of the
/// line around it. The ends stay.
/// @param side  of the box around the whole drawing; what trembles less than a fortieth of it is smoothed
/// away
[[nodiscard]] std::vector<float> steady_line(FlatLine line, float side);

}  // namespace nazori::writing
