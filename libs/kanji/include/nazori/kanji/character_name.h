// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/character.h"

namespace nazori::kanji {

/// A character as people name it: in a command, in a list of characters.
struct CharacterName {
  char32_t code_point = 0;
  std::string variant;  ///< suffix of a variant form, mostly empty

  /// "休", "休-Kaisho".
  [[nodiscard]] std::string text() const;
  /// text() as the name of a file; "U+002F" for what cannot stand in one.
  [[nodiscard]] std::string file_name() const;

  friend bool operator==(const CharacterName&, const CharacterName&) = default;
};

/// "U+4F11".
[[nodiscard]] std::string code_point_text(char32_t code_point);

/// Reads arguments that name characters: each is one or several characters ("休", "休日"), one with the
/// suffix of a variant form ("休-Kaisho"), or a code point ("U+4F11"). Kana may have their sound mark as a
/// combining character; selectors of a glyph's variation and spaces are passed over. Each character counts
/// once.
/// @return Errc::bad_argument for text that is not UTF-8 and for an argument without any character.
[[nodiscard]] base::Result<std::vector<CharacterName>> parse_characters(
    std::span<const std::string> arguments);

/// The name of a character of the database.
[[nodiscard]] CharacterName name_of(const Character& character);

}  // namespace nazori::kanji
