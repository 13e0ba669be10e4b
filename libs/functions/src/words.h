// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "nazori/functions/plot.h"

namespace nazori::functions {

/// A number with "minus" as a word: a hyphen is passed over by screen readers.
[[nodiscard]] std::string number_words(double v, Language language);

/// " is less than ", with spaces around it.
[[nodiscard]] std::string comparison_words(Comparison c, Language language);

}  // namespace nazori::functions
