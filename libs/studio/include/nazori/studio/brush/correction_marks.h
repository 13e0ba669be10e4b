// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "nazori/calligraphy/advice.h"
#include "nazori/studio/brush/brush_cursor.h"

class QPainter;

namespace nazori::ui {

/// Draws corrections in vermilion over a sheet, as a teacher does with another brush.
void paint_marks(QPainter& painter, std::span<const calligraphy::CorrectionMark> marks,
                 const SheetPlace& place);

}  // namespace nazori::ui
