// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "palette.h"

namespace nazori::ui {

/// The whole look of the window's widgets: flat surfaces, thin lines, a focus ring of 2 px. Sizes that follow
/// the text are in em, so 12 to 28 points fit alike.
[[nodiscard]] QString style_sheet(const Colours& colours);

}  // namespace nazori::ui
