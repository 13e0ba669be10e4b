// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "nazori/widgets/look/palette.h"

namespace nazori::ui {

/// The whole look of the window's widgets, resources/window.qss, in these colours: flat surfaces, thin lines,
/// a focus ring of 2 px. No size of text is set, so 12 to 28 points fit alike.
[[nodiscard]] QString style_sheet(const Colours& colours);

}  // namespace nazori::ui
