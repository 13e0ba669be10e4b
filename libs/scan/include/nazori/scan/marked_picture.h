// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "nazori/scan/picture.h"
#include "nazori/scan/sheet_reader.h"
#include "nazori/surface/colour_picture.h"

namespace nazori::scan {

/// The photograph with each cell outlined by what was found: green is legible, orange is legible with
/// remarks, red is not legible (with a cross), grey is empty, blue is traced.
[[nodiscard]] surface::ColourPicture marked_picture(const Photo& photo, std::span<const SheetReading> sheets);

}  // namespace nazori::scan
