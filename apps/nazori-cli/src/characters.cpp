// SPDX-License-Identifier: Apache-2.0
#include "characters.h"

#include <utility>

#include "nazori/author/collection.h"

namespace nazori::cli {
namespace {

std::string joined(std::span<const CharacterName> names) {
  std::string text;
  for (const CharacterName& name : names) text += (text.empty() ? "" : ", ") + name.text();
  return text;
}

}  // namespace

base::Result<kanji::KanjiDatabase> open_database(const std::string& path) {
  const author::Collection own(author::Collection::usual_folder());
  if (!path.empty()) return author::open_with_own(path, own);
  auto found = kanji::KanjiDatabase::locate();
  if (!found) return tl::unexpected(std::move(found.error()));
  return author::open_with_own(*found, own);
}

FoundCharacters find_characters(const kanji::KanjiDatabase& database, std::span<const CharacterName> names) {
  FoundCharacters answer;
  for (const CharacterName& name : names) {
    if (auto character = database.find(name.code_point, name.variant)) {
      answer.found.push_back(std::move(*character));
    } else {
      answer.missing.push_back(name);
    }
  }
  return answer;
}

base::Error not_found(std::span<const CharacterName> missing) {
  return {base::Errc::not_found, "not in the database", joined(missing),
          "find characters with: nazori-cli search"};
}

tl::expected<std::vector<kanji::Character>, int> characters_with_strokes(
    Console& console, std::span<const std::string> arguments, const std::string& database) {
  const auto names = kanji::parse_characters(arguments);
  if (!names) return tl::unexpected(console.refuse(names.error()));
  const auto opened = open_database(database);
  if (!opened) return tl::unexpected(console.refuse(opened.error()));
  FoundCharacters characters = find_characters(*opened, *names);
  if (opened->trouble()) return tl::unexpected(console.refuse(*opened->trouble()));
  if (!characters.missing.empty()) return tl::unexpected(console.deny(not_found(characters.missing)));
  std::vector<CharacterName> bare;
  for (const kanji::Character& character : characters.found) {
    if (character.strokes.empty()) bare.push_back(kanji::name_of(character));
  }
  if (!bare.empty()) {
    return tl::unexpected(console.deny({base::Errc::not_found, "has no strokes in the database", joined(bare),
                                        "it is only in the dictionary"}));
  }
  return std::move(characters.found);
}

base::Result<std::optional<author::OwnCharacter>> made_character(const kanji::Character& character) {
  const auto kept = author::kept_form_of(character);
  if (!kept) return std::nullopt;
  auto made = author::Collection(author::Collection::usual_folder()).find(*kept);
  if (!made) return tl::unexpected(std::move(made.error()));
  return *std::move(made);
}

}  // namespace nazori::cli
