// SPDX-License-Identifier: Apache-2.0
// Mistakes that truly cannot be told from right writing, each with its reason.
#pragma once

#include <cstddef>
#include <vector>

#include "nazori/kanji/character.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::writing::test {

struct Spoilt {
  char32_t character;
  std::size_t stroke;  ///< from 1
};

/// Those that indistinguishable_shortened() names one by one.
std::vector<Spoilt> listed_as_shortened();

/// Stroke `k` drawn backwards.
bool indistinguishable_reversed(const kanji::Character& character, std::size_t k);
/// Stroke `k` left out.
bool indistinguishable_without(const kanji::Character& character, std::size_t k);
/// Strokes `k` and `k + 1` in the other order.
bool indistinguishable_exchanged(const kanji::Character& character, std::size_t k);
/// Only the first third of stroke `k`.
bool indistinguishable_shortened(const kanji::KanjiDatabase& database, const kanji::Character& character,
                                 std::size_t k);

}  // namespace nazori::writing::test
