// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace nazori::kanji {

/// The script of a character that has no dictionary entry.
enum class Script : std::uint8_t {
  hiragana,  ///< U+3041..U+309F
  katakana,  ///< U+30A0..U+30FF
  latin,     ///< letters, digits and signs below U+0250, and their full-width forms
  other,     ///< all else, kanji too
};

/// The script by the block of Unicode that the character is in.
[[nodiscard]] Script script_of(char32_t character);

/// A kana with its sound mark (dakuten U+3099, handakuten U+309A) as one code point: か and U+3099 give が.
/// @return 0 where the two cannot be combined.
/// @source The Unicode Standard, canonical compositions with U+3099 and U+309A.
[[nodiscard]] char32_t with_sound_mark(char32_t kana, char32_t mark);

/// The same syllable in the other syllabary: あ gives ア, ア gives あ. ゝ, ヽ and ー are not syllables, and
/// U+30F7..U+30FA (ヷ to ヺ) have no hiragana.
/// @return 0 where there is none.
[[nodiscard]] char32_t in_other_syllabary(char32_t kana);

}  // namespace nazori::kanji
