// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "look/palette.h"
#include "nazori/practice/chart.h"

namespace nazori::ui {

/// The colour that a role has in a palette.
[[nodiscard]] QColor colour_of(const practice::Colour& colour, const Colours& colours);

}  // namespace nazori::ui
