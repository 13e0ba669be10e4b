// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "author.h"
#include "characters.h"
#include "json_answers.h"
#include "nazori/author/collection.h"
#include "nazori/base/file.h"
#include "nazori/kanji/own_characters.h"
#include "options.h"
#include "output_files.h"

namespace nazori::cli {
namespace {

using author::CharacterFormat;

struct AuthorConvertSettings {
  std::string source;
  std::string output;
  std::optional<int> grid;
  std::optional<int> size;
  std::string database;
  bool json = false;
};

std::string_view format_name(CharacterFormat format) {
  switch (format) {
    case CharacterFormat::document:
      return "nazori";
    case CharacterFormat::svg:
      return "svg";
    case CharacterFormat::strokes:
      return "str";
    case CharacterFormat::raw:
      return "raw";
    case CharacterFormat::png:
      return "png";
  }
  return "";
}

/// The character of a file, or a copy of one of the database. @return the exit code after an error message.
tl::expected<author::OwnCharacter, int> source_of(Console& console, const AuthorConvertSettings& s) {
  if (author::format_of(s.source)) {
    auto read = read_author_file(s.source, s.grid);
    if (!read) return tl::unexpected(console.refuse(read.error()));
    return std::move(read->character);
  }
  const std::vector<std::string> names{s.source};
  const auto characters = characters_with_strokes(console, names, s.database);
  if (!characters) return tl::unexpected(characters.error());
  if (characters->size() != 1)
    return tl::unexpected(console.refuse(
        {base::Errc::bad_argument, "is more than one character", s.source, "convert them one by one"}));
  const kanji::Character& one = characters->front();
  auto made = made_character(one);
  if (!made) return tl::unexpected(console.refuse(made.error()));
  return *made ? **std::move(made) : author::copy_of(one);
}

int run(Console& console, const AuthorConvertSettings& s) {
  const auto place = output_file({"--output", s.output, author_extensions()});
  if (!place) return console.refuse(place.error());
  const NamedFile files[] = {
      {"source", author::format_of(s.source) ? s.source : std::string(), NamedFile::Use::read},
      {"--output", place->name()}};
  if (auto fine = check_distinct(files, s.json); !fine) return console.refuse(fine.error());
  auto character = source_of(console, s);
  if (!character) return character.error();
  const CharacterFormat format = author::format_of(place->path()).value_or(CharacterFormat::document);
  // The relief of a file keeps its own size, so that nothing is interpolated.
  const int own_size = character->hand.is_untouched() ? author::kMapSize : character->hand.size;
  constexpr int kClassicGrid = 128;
  const int size = s.size.value_or(format == CharacterFormat::strokes ? kClassicGrid : own_size);
  const auto bytes = author::export_character(*character, format, size);
  if (!bytes) return console.refuse(bytes.error());
  if (auto written = base::write_file(place->path(), *bytes); !written)
    return console.refuse(written.error());
  if (auto sent = place->deliver(console); !sent) return console.refuse(sent.error());
  if (place->is_console()) return kDone;
  if (s.json) {
    Json answer;
    answer["version"] = 1;
    answer["source"] = s.source;
    answer["file"] = place->name();
    answer["format"] = format_name(format);
    answer["name"] = character->facts.name;
    answer["strokes"] = character->strokes.size();
    answer["has_relief"] = !character->hand.is_untouched();
    answer["licence"] = character->facts.rights.licence;
    answer["bytes"] = bytes->size();
    console.print(to_text(answer));
    return kDone;
  }
  console.print(fmt::format("{}  {} stroke{}{}, {} bytes\n", place->name(), character->strokes.size(),
                            character->strokes.size() == 1 ? "" : "s",
                            character->hand.is_untouched() ? "" : ", relief by hand", bytes->size()));
  if (character->facts.rights.source == author::kKanjiVgSource)
    console.print("Strokes: KanjiVG, (c) Ulrich Apel, CC BY-SA 3.0; a changed copy keeps this licence.\n");
  return kDone;
}

}  // namespace

std::vector<std::string> author_extensions() { return {".nazori", ".svg", ".str", ".raw", ".png"}; }

base::Result<AuthorFile> read_author_file(const std::string& file, std::optional<int> grid) {
  const auto format = author::format_of(file);
  if (!format)
    return base::fail(base::Errc::bad_argument, "is of a kind that is not known", file,
                      "give a .nazori, .svg, .str, .raw or .png");
  const auto bytes = base::read_file(file, author::kLargestFile);
  if (!bytes) return tl::unexpected(bytes.error());
  auto character = author::import_character(*bytes, *format, grid);
  if (!character) {
    base::Error error = std::move(character).error();
    error.where = error.where.empty() ? file : file + ", " + error.where;
    return tl::unexpected(std::move(error));
  }
  AuthorFile read{*std::move(character), {}};
  if (*format == CharacterFormat::svg) read.svg.assign(bytes->begin(), bytes->end());
  return read;
}

void add_author_convert(CLI::App& author, Action& chosen) {
  auto s = std::make_shared<AuthorConvertSettings>();
  CLI::App* verb = author.add_subcommand(
      "convert", "Write a character in another format, or a copy of one of the database");
  verb->add_option("source", s->source,
                   "A file .nazori, .svg (also of KanjiVG), .str, .raw or .png; or a character such as 永")
      ->required();
  verb->add_option("-o,--output", s->output,
                   "Output file: .nazori, .svg, .str, .raw or .png (16 bits); - is standard output (.nazori)")
      ->required()
      ->type_name("FILE");
  verb->add_option("--grid", s->grid, "Side of the grid of a source .str or .raw (default: a guess)")
      ->type_name("N")
      ->check(within(2, 8192));
  verb->add_option("--size", s->size,
                   "Samples per side of an output .raw or .png (default: those of the source, or 1024), or "
                   "side of the grid of a .str (default: 128)")
      ->type_name("N")
      ->check(within(2, 8192));
  verb->add_flag("--json", s->json, "Print JSON (see docs/command-line.md)");
  add_database_option(*verb, s->database);
  verb->footer(
      "What a format cannot hold is left out: only .nazori has everything.\n\n"
      "Examples:\n  nazori-cli author convert 永 --output 永.nazori\n"
      "  nazori-cli author convert 永.nazori --output 永.svg");
  verb->callback([s, &chosen] { chosen = [s](Console& console) { return run(console, *s); }; });
}

}  // namespace nazori::cli
