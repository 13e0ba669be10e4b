// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/writing/grade.h"

namespace nazori::writing {

/// 1 to kBestForm for an accepted writing, from how far its strokes deviate and from the advice given.
/// @pre at least one stroke
[[nodiscard]] int form_stars(const Grade& grade);

}  // namespace nazori::writing
