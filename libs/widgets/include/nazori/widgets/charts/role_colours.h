// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/practice/chart.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {

/// The colour that a role has in a palette.
[[nodiscard]] QColor colour_of(const practice::Colour& colour, const Colours& colours);

}  // namespace nazori::ui
