// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace nazori::kanji {

/// What a search text is written in, which decides where it is looked for.
struct SearchText {
  std::u32string typed;   ///< without blanks around it
  std::u32string narrow;  ///< the same with full-width letters and digits as plain ones
  bool is_kana = false;   ///< also with okurigana dot and hyphens; an empty text is kana and Latin
  bool is_latin = false;
};

/// @return an empty text for invalid UTF-8.
[[nodiscard]] SearchText search_text_of(std::string_view text);

[[nodiscard]] bool is_searched_kana(char32_t c);

/// Greater than every text that begins with `key`: no text contains the byte FF.
[[nodiscard]] std::string after_all_that_begin_with(std::string_view key);

}  // namespace nazori::kanji
