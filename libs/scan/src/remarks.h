// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/scan/sheet_reader.h"

namespace nazori::scan {

/// What could be better in a character, in the order of CellFlaw and of its strokes.
[[nodiscard]] std::vector<CellRemark> remarks_on(const writing::InkShape& shape);

/// Whether ink and a character have so much in common that it can be this one.
[[nodiscard]] bool is_alike(const writing::InkShape& shape);

}  // namespace nazori::scan
