// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace nazori::writing {

/// Which characters are searched.
enum class Among : std::uint8_t {
  all,
  kana,     ///< hiragana and katakana, small ones and marks such as ー and ゝ, too
  kanji,    ///< also the parts of kanji that Unicode lists apart, and 々 and 〇
  letters,  ///< A-Z, a-z and the digits 0-9
};

[[nodiscard]] bool is_among(char32_t character, Among among);

}  // namespace nazori::writing
