// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "sfnt.h"

namespace nazori::author {

/// One glyph as it stands in a font.
struct FontShape {
  char32_t code_point = 0;
  FontBox box;
  std::size_t points = 0;
  std::size_t contours = 0;  ///< 0: blank
};

/// All tables of a font of own characters but those of the outlines, glyf and loca.
/// @param shapes  the first is the glyph for what is missing; the others are in the order of their code
/// points. @param family  UTF-8.
[[nodiscard]] std::vector<FontTable> font_tables(std::span<const FontShape> shapes, std::string_view family);

}  // namespace nazori::author
