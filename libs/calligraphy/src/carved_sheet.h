// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "nazori/base/result.h"
#include "nazori/paint/sheet.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::calligraphy {

/// A tablet in which the ink of a sheet is carved: the more ink, the deeper, up to the full depth.
[[nodiscard]] base::Result<std::shared_ptr<const tablet::CarvedTablet>> carved_sheet(
    const paint::Sheet& sheet);

}  // namespace nazori::calligraphy
