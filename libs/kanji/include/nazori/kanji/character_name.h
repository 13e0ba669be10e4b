// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/character.h"

namespace nazori::kanji {

/// A character as people name it in a command or in a list of characters.
struct CharacterName {
  char32_t code_point = 0;
  std::string variant;  ///< suffix of a variant form, usually empty

  /// "休", "休-Kaisho"; "U+F1A2B" for a character that somebody made, which no font has.
  [[nodiscard]] std::string text() const;
  /// text() as the name of a file; "U+002F" for characters that a file name cannot contain.
  [[nodiscard]] std::string file_name() const;

  friend bool operator==(const CharacterName&, const CharacterName&) = default;
};

/// "U+4F11".
[[nodiscard]] std::string code_point_text(char32_t code_point);

/// Reads arguments that name characters: each is one or several characters ("休", "休日"), one with the
/// suffix of a variant form ("休-Kaisho"), or a code point ("U+4F11"). Kana may have their sound mark as a
/// combining character; variation selectors and spaces are ignored. Each character appears once in the
/// result.
/// @return Errc::bad_argument for text that is not UTF-8 and for an argument without any character.
[[nodiscard]] base::Result<std::vector<CharacterName>> parse_characters(
    std::span<const std::string> arguments);

/// The name of a character of the database.
[[nodiscard]] CharacterName name_of(const Character& character);

}  // namespace nazori::kanji
