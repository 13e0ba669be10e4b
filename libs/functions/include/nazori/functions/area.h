// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "nazori/functions/plot.h"

namespace nazori::functions {

/// How large the area of a statement is. Thread-safe, like all that has no state.
struct AreaValue {
  double integral = 0;                         ///< of first - second from `from` to `to`, with its sign
  double area = 0;                             ///< of the region: never negative
  std::optional<std::string> integral_name{};  ///< exact: "8/3" (see exact_name)
  std::optional<std::string> area_name{};
};

/// @return nothing where the statement is no area, or a curve is not defined and bounded between the ends.
[[nodiscard]] std::optional<AreaValue> area_value(const Statement& statement);

/// The values of all areas of a plot as the end of a sentence: ", area 8 over 3, about 2.667". Empty where
/// there is none.
[[nodiscard]] std::string areas_in_words(const Plot& plot, Language language,
                                         SpeechStyle style = SpeechStyle::verbose);

}  // namespace nazori::functions
