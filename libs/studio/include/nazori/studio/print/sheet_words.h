// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "nazori/scan/sheet_reader.h"

namespace nazori::ui {

/// "Practice sheet, page 1: 24 cells, 20 legible, 1 not legible, 3 empty."
[[nodiscard]] QString sheet_words(const scan::SheetReading& sheet);
/// "Cell 3, 休: too small, stroke 2 is missing." @param number  of the cell, from 1.
[[nodiscard]] QString cell_words(std::size_t number, const scan::CellReading& cell);
/// Whether there is something to say about a cell: ink that is not legible, or remarks.
[[nodiscard]] bool needs_care(const scan::CellReading& cell);

}  // namespace nazori::ui
