// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace nazori::writing {

/// Another form in which a letter or digit is commonly written by hand, beside the one that KanjiVG draws.
struct HandwrittenForm {
  char32_t character = 0;
  std::string_view strokes;  ///< SVG path data of the strokes, glyph frame, separated by '|'
};

/// Written for this project.
[[nodiscard]] std::span<const HandwrittenForm> handwritten_forms();

}  // namespace nazori::writing
