// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::author {

/// The strokes of a part as people write them: "1, 2" or "1-3, 7", counted from 1.
/// @param strokes  0-based, ascending, each once. @return empty for none; from three neighbours on a range.
[[nodiscard]] std::string stroke_numbers_text(std::span<const int> strokes);

/// Reads such a text. Numbers and ranges stand in any order, with commas or spaces between them.
/// @param count  strokes of the character.
/// @return 0-based, ascending, each once; empty for an empty text. Errc::bad_argument where there is anything
/// else in the text, a number is not 1..count, or a range goes down.
[[nodiscard]] base::Result<std::vector<int>> parse_stroke_numbers(std::string_view text, std::size_t count);

}  // namespace nazori::author
