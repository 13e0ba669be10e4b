// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "nazori/functions/plot.h"

namespace nazori::functions {

/// The region of an area: min(f, g) <= y <= max(f, g) and a <= x <= b.
[[nodiscard]] Statement area_statement(Area area, int column);
/// The integral of |f - g|, as an expression.
[[nodiscard]] Expression area_integral(const Area& area);
/// "area(x^2, 0, 2)".
[[nodiscard]] std::string area_text(const Area& area);
/// "the area between y equals x squared and the x axis, for x from 0 to 2".
[[nodiscard]] std::string area_in_words(const Area& area, Language language, SpeechStyle style);

}  // namespace nazori::functions
