// SPDX-License-Identifier: Apache-2.0
#include "nazori/carving/carve.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "characters.h"
#include "json_answers.h"
#include "nazori/exchange/tablets.h"
#include "nazori/kanji/centre_lines.h"
#include "nazori/kanji/stroke_order.h"
#include "nazori/surface/height_map.h"
#include "options.h"
#include "output_files.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

struct CarveSettings {
  std::vector<std::string> characters;
  std::string database;
  std::string output;
  std::string strokes;
  int size = 128;
  std::optional<int> bits;
  carving::Brush brush;
  bool json = false;
};

/// Where one character goes.
struct Target {
  OutputPlace map;
  std::optional<OutputPlace> strokes;
};

base::Result<std::vector<Target>> targets_of(const CarveSettings& settings,
                                             std::span<const CharacterName> names) {
  auto maps = output_files({"--output", settings.output, {".png", ".raw"}}, names);
  if (!maps) return tl::unexpected(maps.error());
  if (settings.bits == 16 && has_extension(maps->front().path(), ".raw")) {
    return base::fail(base::Errc::bad_argument, "a RAW file has 8 bits per sample", "--bits 16",
                      "write a .png, or omit --bits");
  }
  std::vector<Target> targets;
  std::vector<NamedFile> named;
  for (OutputPlace& map : *maps) {
    named.push_back({"--output", map.name()});
    targets.push_back({std::move(map), std::nullopt});
  }
  if (!settings.strokes.empty()) {
    auto files = output_files({"--strokes", settings.strokes, {".str"}}, names);
    if (!files) return tl::unexpected(files.error());
    for (std::size_t i = 0; i < targets.size(); ++i) {
      named.push_back({"--strokes", (*files)[i].name()});
      targets[i].strokes = std::move((*files)[i]);
    }
  }
  if (auto fine = check_distinct(named, settings.json); !fine) return tl::unexpected(std::move(fine.error()));
  return targets;
}

base::Result<surface::HeightMap> relief_of(const kanji::Character& character, const CarveSettings& settings) {
  const auto made = made_character(character);
  if (!made) return tl::unexpected(made.error());
  return *made ? author::carve(**made, settings.size)
               : carving::carve(character.lines(), settings.size, settings.brush);
}

base::Result<void> carve_one(Console& console, const kanji::Character& character, const Target& target,
                             const CarveSettings& settings) {
  const auto map = relief_of(character, settings);
  if (!map) return tl::unexpected(map.error());
  const auto depth = settings.bits == 8 ? surface::PngDepth::bits_8 : surface::PngDepth::bits_16;
  auto saved = has_extension(target.map.path(), ".raw") ? surface::save_raw(*map, target.map.path())
                                                        : surface::save_png(*map, target.map.path(), depth);
  if (saved) saved = target.map.deliver(console);
  if (saved && target.strokes) {
    saved = kanji::StrokeOrder::from_lines(kanji::centre_lines(character.lines()), settings.size)
                .save(target.strokes->path());
    if (saved) saved = target.strokes->deliver(console);
  }
  return saved;
}

std::string carved_text(const kanji::Character& character, const Target& target,
                        const CarveSettings& settings) {
  // Nothing else may go to standard output together with a file.
  if (target.map.is_console() || (target.strokes && target.strokes->is_console())) return {};
  const std::string name = kanji::name_of(character).text();
  std::string text = fmt::format("{}  {}  {} x {}\n", name, target.map.name(), settings.size, settings.size);
  if (target.strokes)
    text += fmt::format("{}  {}  {} strokes\n", name, target.strokes->name(), character.strokes.size());
  return text;
}

int run(Console& console, const CarveSettings& settings) {
  const auto names = kanji::parse_characters(settings.characters);
  if (!names) return console.refuse(names.error());
  const auto targets = targets_of(settings, *names);
  if (!targets) return console.refuse(targets.error());
  const auto characters = characters_with_strokes(console, settings.characters, settings.database);
  if (!characters) return characters.error();

  Json document = Json::array();
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  for (std::size_t i = 0; i < characters->size(); ++i) {
    const std::string name = kanji::name_of((*characters)[i]).text();
    if (!progress.show(static_cast<double>(i) / static_cast<double>(characters->size()), "carving " + name)) {
      return console.refuse({base::Errc::cancelled, "stopped", name, ""});
    }
    const Target& target = (*targets)[i];
    if (auto done = carve_one(console, (*characters)[i], target, settings); !done)
      return console.refuse(done.error());
    if (settings.json) {
      exchange::CarvedFiles files{target.map.name(), std::nullopt, settings.size};
      if (target.strokes) files.strokes = target.strokes->name();
      document.push_back(exchange::to_json((*characters)[i], files));
    } else {
      console.print(carved_text((*characters)[i], target, settings));
    }
  }
  if (settings.json) console.print(to_text(document));
  return kDone;
}

}  // namespace

void add_carve(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<CarveSettings>();
  CLI::App* verb = app.add_subcommand("carve", "Carve characters into height maps");
  verb->add_option("characters", settings->characters,
                   "Characters, such as 休, 休日, 正-HzFst (a variant form) or U+4F11")
      ->required();
  verb->add_option(
          "-o,--output", settings->output,
          "Output file: .png (greyscale, white is the plateau) or .raw (8 bits, no header). For several "
          "characters: a folder, or a name with {} for the character; - is standard output (PNG)")
      ->required()
      ->type_name("FILE");
  verb->add_option("--size", settings->size, "Samples per side of the map")
      ->check(within(surface::HeightMap::kMinSize, surface::HeightMap::kMaxSize))
      ->capture_default_str()
      ->type_name("N");
  verb->add_option("--bits", settings->bits, "Bits per sample of a PNG: 8 or 16 (default: 16)")
      ->check(CLI::IsMember({8, 16}))
      ->type_name("N");
  verb->add_option("--strokes", settings->strokes, "Also write the stroke order on the same grid (.str)")
      ->type_name("FILE");
  verb->add_flag("--json", settings->json, "Print JSON (see docs/command-line.md)");
  add_brush_options(*verb, settings->brush);
  add_database_option(*verb, settings->database);
  verb->footer(
      "Examples:\n  nazori-cli carve 休 --size 128 --output 休.raw --strokes 休.str\n"
      "  nazori-cli carve 休 木 人 --size 1024 --output 'maps/{}.png' --cross-section v");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
