// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "console.h"
#include "nazori/author/own_character.h"
#include "nazori/base/result.h"
#include "nazori/kanji/character_name.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::cli {

using kanji::CharacterName;

/// Opens the database at `path`, or the one that KanjiDatabase::locate() finds where `path` is empty, with
/// the learner's own characters. Those that are damaged are left out: `nazori-cli author kept` names them.
[[nodiscard]] base::Result<kanji::KanjiDatabase> open_database(const std::string& path);

/// A character in text for people: itself, or the code point of one that somebody made, which no font has.
[[nodiscard]] inline std::string letter(char32_t character) { return CharacterName{character, {}}.text(); }

/// The characters that the database has.
struct FoundCharacters {
  std::vector<kanji::Character> found;
  std::vector<CharacterName> missing;
};
[[nodiscard]] FoundCharacters find_characters(const kanji::KanjiDatabase& database,
                                              std::span<const CharacterName> names);

/// One message for all that were not found.
[[nodiscard]] base::Error not_found(std::span<const CharacterName> missing);

/// The characters named by arguments, each with strokes to carve.
/// @return the characters, or the exit code after an error message.
[[nodiscard]] tl::expected<std::vector<kanji::Character>, int> characters_with_strokes(
    Console& console, std::span<const std::string> arguments, const std::string& database);

/// What somebody made of a character, with its own widths, relief and rights; none for a published form.
/// @return the errors of author::Collection::find().
[[nodiscard]] base::Result<std::optional<author::OwnCharacter>> made_character(
    const kanji::Character& character);

}  // namespace nazori::cli
