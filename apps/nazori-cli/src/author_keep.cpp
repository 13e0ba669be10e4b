// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "author.h"
#include "characters.h"
#include "json_answers.h"
#include "nazori/author/collection.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/character_name.h"
#include "options.h"

namespace nazori::cli {
namespace {

struct AuthorKeepSettings {
  std::vector<std::string> files;
  bool replaces = false;
  bool beside = false;
  bool instead = false;
  std::string database;
  bool json = false;
};

struct AuthorKeptSettings {
  bool json = false;
};

struct AuthorRemoveSettings {
  std::string character;
  bool json = false;
};

author::Collection collection() { return author::Collection(author::Collection::usual_folder()); }

Json kept_to_json(char32_t code_point, const std::string& name, std::size_t strokes,
                  std::optional<char32_t> instead_of) {
  Json one;
  one["character"] = base::encode_utf8(code_point);
  one["code_point"] = kanji::code_point_text(code_point);
  one["name"] = name;
  one["strokes"] = strokes;
  one["instead_of"] = instead_of ? Json(base::encode_utf8(*instead_of)) : Json();
  return one;
}

/// " instead of the published 永"; empty where it stands beside.
std::string instead_text(std::optional<char32_t> instead_of) {
  return instead_of ? fmt::format(" instead of the published {}", base::encode_utf8(*instead_of))
                    : std::string();
}

/// Chooses in whose place a character is used: with --instead in that of the published one of its name.
base::Result<void> choose_place(author::Facts& facts, const AuthorKeepSettings& s) {
  if (s.beside) facts.instead_of.reset();
  if (!s.instead) return {};
  if (!facts.instead_of) {
    const auto letters = base::decode_utf8(facts.name);
    if (!letters || letters->size() != 1)
      return base::fail(base::Errc::bad_argument, "is not the name of one published character", facts.name,
                        "name it as the character that it takes the place of");
    facts.instead_of = letters->front();
  }
  const auto database = open_database(s.database);
  if (!database) return tl::unexpected(database.error());
  if (!database->summary(*facts.instead_of))
    return base::fail(base::Errc::not_found, "not in the database", base::encode_utf8(*facts.instead_of),
                      "keep it without --instead: then it stands beside the others");
  return {};
}

/// The kept character that a file replaces; none: it is a new one.
base::Result<std::optional<char32_t>> place_of(const author::OwnCharacter& character,
                                               const AuthorKeepSettings& s) {
  if (s.beside) return std::optional<char32_t>();
  const auto same = collection().named(character.facts.name);
  if (!same) return tl::unexpected(same.error());
  if (same->empty()) return std::optional<char32_t>();
  if (s.replaces && same->size() == 1) return std::optional(same->front());
  return base::fail(base::Errc::in_use,
                    same->size() == 1 ? "is the name of a character that is kept already"
                                      : "is the name of several characters that are kept already",
                    character.facts.name,
                    same->size() > 1 ? "remove all but one of them, or give --beside"
                    : s.instead      ? "give --replace"
                                     : "give --replace or --beside");
}

int keep(Console& console, const AuthorKeepSettings& s) {
  // All are read before the first is kept, so that a wrong file keeps none.
  std::vector<author::OwnCharacter> characters;
  for (const std::string& file : s.files) {
    auto read = read_author_file(file, std::nullopt);
    if (!read) return console.refuse(read.error());
    // An SVG or a stroke order has no name of its own.
    if (read->character.facts.name.empty())
      read->character.facts.name = std::filesystem::path(file).stem().string();
    if (auto placed = choose_place(read->character.facts, s); !placed)
      return placed.error().code == base::Errc::not_found ? console.deny(placed.error())
                                                          : console.refuse(placed.error());
    characters.push_back(std::move(read->character));
  }
  Json answers = Json::array();
  std::string text;
  for (const author::OwnCharacter& character : characters) {
    const auto place = place_of(character, s);
    if (!place && place.error().code == base::Errc::in_use) return console.deny(place.error());
    if (!place) return console.refuse(place.error());
    const auto kept =
        collection().keep(character, *place, s.beside ? author::SameName::beside : author::SameName::refuse);
    // Another program has kept one of this name meanwhile.
    if (!kept && kept.error().where == character.facts.name) return console.deny(kept.error());
    if (!kept) return console.refuse(kept.error());
    const auto& instead_of = character.facts.instead_of;
    Json one = kept_to_json(*kept, character.facts.name, character.strokes.size(), instead_of);
    one["replaced"] = place->has_value();
    answers.push_back(std::move(one));
    text += fmt::format("{}  {}{}{}\n", kanji::code_point_text(*kept), character.facts.name,
                        place->has_value() ? " (replaced)" : "", instead_text(instead_of));
  }
  console.print(s.json ? to_text(answers) : text);
  return kDone;
}

int show_kept(Console& console, const AuthorKeptSettings& s) {
  const auto content = collection().read();
  if (!content) return console.refuse(content.error());
  for (const base::Error& error : content->unread) console.inform(base::to_line(error));
  Json answers = Json::array();
  std::string text;
  for (const author::KeptCharacter& kept : content->characters) {
    const author::OwnCharacter& character = kept.character;
    Json one = kept_to_json(kept.code_point, character.facts.name, character.strokes.size(), kept.instead_of);
    one["file"] = kept.file.string();
    answers.push_back(std::move(one));
    text += fmt::format("{}  {}  {} stroke{}{}\n", kanji::code_point_text(kept.code_point),
                        character.facts.name, character.strokes.size(),
                        character.strokes.size() == 1 ? "" : "s", instead_text(kept.instead_of));
  }
  if (text.empty() && !s.json)
    text = "No characters of your own are kept. Keep one with: nazori-cli author keep FILE\n";
  console.print(s.json ? to_text(answers) : text);
  return content->unread.empty() ? kDone : kNo;
}

int remove(Console& console, const AuthorRemoveSettings& s) {
  const std::vector<std::string> arguments{s.character};
  std::vector<char32_t> found;
  const auto names = kanji::parse_characters(arguments);
  if (names && names->size() == 1 && kanji::is_own(names->front().code_point)) {
    found = {names->front().code_point};
  } else {
    auto named = collection().named(s.character);
    if (!named) return console.refuse(named.error());
    found = *std::move(named);
  }
  if (found.empty())
    return console.deny({base::Errc::not_found, "is not kept", s.character,
                         "show what is kept with: nazori-cli author kept"});
  if (found.size() > 1)
    return console.refuse({base::Errc::bad_argument, "is the name of several characters", s.character,
                           "give the code point, as in U+F1A2B"});
  if (auto removed = collection().remove(found.front()); !removed) {
    return removed.error().code == base::Errc::not_found ? console.deny(removed.error())
                                                         : console.refuse(removed.error());
  }
  if (s.json) {
    Json answer;
    answer["version"] = 1;
    answer["code_point"] = kanji::code_point_text(found.front());
    console.print(to_text(answer));
  } else {
    console.print(fmt::format("{} is no longer among your characters.\n", s.character));
  }
  return kDone;
}

}  // namespace

void add_author_keep(CLI::App& author, Action& chosen) {
  {
    auto s = std::make_shared<AuthorKeepSettings>();
    CLI::App* verb = author.add_subcommand(
        "keep", "Add characters to yours: lists, search, study and worksheets have them");
    verb->add_option("files", s->files,
                     "Files .nazori, .svg or .str with strokes; without a name of its own, a "
                     "character is called as its file")
        ->required()
        ->type_name("FILE");
    CLI::Option* const replaces =
        verb->add_flag("--replace", s->replaces,
                       "Replace the kept character of the same name; what was studied of it stays");
    CLI::Option* const beside =
        verb->add_flag("--beside", s->beside,
                       "Keep it beside a character of the same name, a kept or a published one")
            ->excludes(replaces);
    verb->add_flag("--instead", s->instead,
                   "Use this form instead of the published character of its name: lists, search, study and "
                   "worksheets have its strokes then, with the same study history")
        ->excludes(beside);
    verb->add_flag("--json", s->json, "Print JSON (see docs/command-line.md)");
    add_database_option(*verb, s->database);
    verb->footer(
        "Kept characters get code points U+F0000 to U+FFFFD, which name them in other\ncommands.\n\n"
        "Examples:\n  nazori-cli author keep sign.nazori\n  nazori-cli author keep sign.nazori --replace\n"
        "  nazori-cli author keep corrected.nazori --instead\n"
        "  nazori-cli worksheet --list own --output mine.pdf");
    verb->callback([s, &chosen] { chosen = [s](Console& console) { return keep(console, *s); }; });
  }
  {
    auto s = std::make_shared<AuthorKeptSettings>();
    CLI::App* verb = author.add_subcommand("kept", "Show the characters that you keep");
    verb->add_flag("--json", s->json, "Print JSON (see docs/command-line.md)");
    verb->footer("Exit code 1 where a file is damaged.\n\nExample:\n  nazori-cli author kept --json");
    verb->callback([s, &chosen] { chosen = [s](Console& console) { return show_kept(console, *s); }; });
  }
  auto s = std::make_shared<AuthorRemoveSettings>();
  CLI::App* verb = author.add_subcommand("remove", "Take a character out of those that you keep");
  verb->add_option("character", s->character, "Its name, or its code point such as U+F1A2B")->required();
  verb->add_flag("--json", s->json, "Print JSON (see docs/command-line.md)");
  verb->footer(
      "Its file stays in the folder with the ending .removed, and what was studied of\nit stays, too.\n\n"
      "Example:\n  nazori-cli author remove \"our sign\"");
  verb->callback([s, &chosen] { chosen = [s](Console& console) { return remove(console, *s); }; });
}

}  // namespace nazori::cli
