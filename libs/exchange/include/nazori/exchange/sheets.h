// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "nazori/exchange/document.h"

namespace nazori::scan {
struct SheetReading;
}

namespace nazori::exchange {

/// What was read in one photograph (docs/schemas/sheets.json, grade_sheet: one of its items).
[[nodiscard]] Value to_json(const std::string& photo, std::span<const scan::SheetReading> sheets);

}  // namespace nazori::exchange
