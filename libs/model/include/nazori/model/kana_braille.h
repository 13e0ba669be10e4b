// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "nazori/model/braille.h"

namespace nazori::model {

/// Kana as Japanese braille of six dots, hiragana and katakana alike, with digits, ー and blanks. Every kana
/// is written as it stands.
/// @param text  UTF-8. @return nothing where a character has no cells here (kanji, small vowels).
/// @source the table of kana in Japanese braille as in Unicode's and Wikipedia's "Japanese Braille".
[[nodiscard]] std::optional<std::vector<BrailleCell>> kana_braille(std::string_view text);

/// A reading as KANJIDIC2 gives it ("キュウ", "やす.む", "-ど"), as Japanese braille spells it: an う that
/// makes a long vowel is written ー. An う after the dot is an ending of its own and stays.
[[nodiscard]] std::optional<std::vector<BrailleCell>> reading_braille(std::string_view reading);

}  // namespace nazori::model
