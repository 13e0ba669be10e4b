// SPDX-License-Identifier: Apache-2.0
#include "nazori/carving/carve.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "characters.h"
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
};

/// Where one character goes.
struct Target {
  std::filesystem::path map;
  std::filesystem::path strokes;  ///< empty: not asked for
};

base::Result<std::vector<Target>> targets_of(const CarveSettings& settings,
                                             std::span<const CharacterName> names) {
  const auto maps = output_files({"--output", settings.output, {".png", ".raw"}}, names);
  if (!maps) return tl::unexpected(maps.error());
  if (settings.bits == 16 && has_extension(maps->front(), ".raw")) {
    return base::fail(base::Errc::bad_argument, "a RAW has 8 bits a sample", "--bits 16",
                      "write a .png, or leave --bits out");
  }
  std::vector<Target> targets;
  for (const auto& map : *maps) targets.push_back({map, {}});
  if (!settings.strokes.empty()) {
    const auto files = output_files({"--strokes", settings.strokes, {".str"}}, names);
    if (!files) return tl::unexpected(files.error());
    for (std::size_t i = 0; i < targets.size(); ++i) targets[i].strokes = (*files)[i];
  }
  return targets;
}

base::Result<void> carve_one(const kanji::Character& character, const Target& target,
                             const CarveSettings& settings) {
  const std::vector<kanji::StrokeLine> lines = character.lines();
  const auto map = carving::carve(lines, settings.size, settings.brush);
  if (!map) return tl::unexpected(map.error());
  const auto depth = settings.bits == 8 ? surface::PngDepth::bits_8 : surface::PngDepth::bits_16;
  auto saved = has_extension(target.map, ".raw") ? surface::save_raw(*map, target.map)
                                                 : surface::save_png(*map, target.map, depth);
  if (saved && !target.strokes.empty()) {
    saved = kanji::StrokeOrder::from_lines(lines, settings.size).save(target.strokes);
  }
  return saved;
}

int run(Console& console, const CarveSettings& settings) {
  const auto names = parse_characters(settings.characters);
  if (!names) return console.refuse(names.error());
  const auto targets = targets_of(settings, *names);
  if (!targets) return console.refuse(targets.error());
  const auto characters = characters_with_strokes(console, settings.characters, settings.database);
  if (!characters) return characters.error();

  ProgressDisplay progress(ProgressDisplay::Plain::silent);
  for (std::size_t i = 0; i < characters->size(); ++i) {
    const std::string name = name_of((*characters)[i]).text();
    if (!progress.show(static_cast<double>(i) / static_cast<double>(characters->size()), "carving " + name)) {
      return console.fail({base::Errc::cancelled, "stopped", name, ""});
    }
    const Target& target = (*targets)[i];
    if (auto done = carve_one((*characters)[i], target, settings); !done) return console.fail(done.error());
    console.print(fmt::format("{}  {}  {} x {}\n", name, target.map.string(), settings.size, settings.size));
    if (!target.strokes.empty()) {
      console.print(fmt::format("{}  {}  {} strokes\n", name, target.strokes.string(),
                                (*characters)[i].strokes.size()));
    }
  }
  return kDone;
}

}  // namespace

void add_carve(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<CarveSettings>();
  CLI::App* verb = app.add_subcommand("carve", "Carve characters into height maps");
  verb->add_option("characters", settings->characters,
                   "Characters: 休, 休日, 正-HzFst (a variant form) or U+4F11")
      ->required();
  verb->add_option(
          "-o,--output", settings->output,
          "Where to write: .png (greyscale, white the plateau) or .raw (8 bits, no header); for several "
          "characters a folder or a name with {} for the character")
      ->required()
      ->type_name("FILE");
  verb->add_option("--size", settings->size, "Side of the map in samples")
      ->check(within(surface::HeightMap::kMinSize, surface::HeightMap::kMaxSize))
      ->capture_default_str()
      ->type_name("N");
  verb->add_option("--bits", settings->bits, "Bits a sample of a PNG: 8 or 16 (default: 16)")
      ->check(CLI::IsMember({8, 16}))
      ->type_name("N");
  verb->add_option("--strokes", settings->strokes, "Also write the stroke order on the same grid (.str)")
      ->type_name("FILE");
  add_brush_options(*verb, settings->brush);
  add_database_option(*verb, settings->database);
  verb->footer(
      "Examples:\n  nazori-cli carve 休 --size 128 --output 休.raw --strokes 休.str\n"
      "  nazori-cli carve 休 木 人 --size 1024 --output 'maps/{}.png' --cross-section v");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
