// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "alignment.h"
#include "nazori/kanji/character.h"
#include "stroke_comparer.h"

namespace nazori::writing {

/// The first of the two voicing marks (dakuten) of a kana, among its strokes; the second one follows it.
/// Nothing where the character has none.
[[nodiscard]] std::optional<std::size_t> first_voicing_mark(const kanji::Character& character);

/// Where one voicing mark is there and the other is missing: decides which of the two was drawn, and changes
/// the alignment if it is not the one that was found. The marks are alike, and hands put them up to their own
/// distance from where the model has them. Therefore the mark is compared with the strokes around it and with
/// the writing box.
/// @param first  first_voicing_mark()
/// @param box  writing box to glyph frame
/// @return the mark that is there, as a stroke of the model: it may as well be the missing one. Nothing where
/// not exactly one stroke is missing, or where that is no mark.
[[nodiscard]] std::optional<int> settle_voicing_marks(StrokeComparer& strokes, Alignment& alignment,
                                                      std::size_t first, const std::optional<Affine>& box);

}  // namespace nazori::writing
