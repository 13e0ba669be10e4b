// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "nazori/functions/plot.h"

namespace nazori::functions {

/// Four significant digits, "minus" in words for listeners; an exact name comes first.
[[nodiscard]] std::string spoken(double v, const std::string& name, Language language,
                                 SpeechStyle style = SpeechStyle::verbose);

}  // namespace nazori::functions
