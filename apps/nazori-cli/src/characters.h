// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "console.h"
#include "nazori/base/result.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::cli {

/// A character as it is named on the command line.
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

/// Opens the database at `path`, or the one that KanjiDatabase::locate() finds where `path` is empty.
[[nodiscard]] base::Result<kanji::KanjiDatabase> open_database(const std::string& path);

/// Which of the characters the database has.
struct FoundCharacters {
  std::vector<kanji::Character> found;
  std::vector<CharacterName> missing;
};
[[nodiscard]] FoundCharacters find_characters(const kanji::KanjiDatabase& database,
                                              std::span<const CharacterName> names);

/// One line for all that were not found.
[[nodiscard]] base::Error not_found(std::span<const CharacterName> missing);

/// The name of a character of the database.
[[nodiscard]] CharacterName name_of(const kanji::Character& character);

/// The characters that arguments name, each with strokes to carve.
/// @return the characters, or the exit code after one line has said what is wrong.
[[nodiscard]] tl::expected<std::vector<kanji::Character>, int> characters_with_strokes(
    Console& console, std::span<const std::string> arguments, const std::string& database);

}  // namespace nazori::cli
