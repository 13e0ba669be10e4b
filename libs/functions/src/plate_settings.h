// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/plate.h"

namespace nazori::functions {

/// Errc::bad_argument with the name of the setting that is out of range.
[[nodiscard]] base::Result<void> check(const PlateSettings& settings);

}  // namespace nazori::functions
