// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/base/result.h"
#include "nazori/scan/sheet.h"

namespace nazori::scan {

/// Reads the strip of a page that may lie so in the photograph.
/// @return nullopt where there is no strip; else its content, or Errc::parse or Errc::schema where it cannot
/// be read.
[[nodiscard]] std::optional<base::Result<print::SheetMark>> read_strip(const Photo& photo, const PageMap& map,
                                                                       double width_mm, double height_mm);

}  // namespace nazori::scan
