// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/model/braille.h"

namespace nazori::model {

/// How English is written in braille.
enum class EnglishBraille : std::uint8_t {
  uncontracted,  ///< letter by letter: braille_cells() of the text in small letters
  contracted,    ///< Unified English Braille with its contractions (grade 2)
};

/// Longest text that english_braille() takes [bytes].
inline constexpr std::size_t kLongestBrailleText = 10'000;

/// English text as cells, without line breaks. Contracted text has capitals, punctuation and brackets, too.
/// @param text  UTF-8.
/// @return nothing where a character has no cells: uncontracted text has those of braille_cells(), contracted
/// text has Latin letters and their punctuation. Errc::not_found where the table of liblouis is missing,
/// Errc::bad_argument for a text longer than kLongestBrailleText. Thread-safe: yes.
/// @source contractions: The Rules of Unified English Braille, 2013, as the table en-ueb-g2.ctb of liblouis.
[[nodiscard]] base::Result<std::optional<std::vector<BrailleCell>>> english_braille(std::string_view text,
                                                                                    EnglishBraille how);

}  // namespace nazori::model
