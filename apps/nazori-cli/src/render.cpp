// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "characters.h"
#include "json_answers.h"
#include "nazori/exchange/tablets.h"
#include "nazori/kanji/stroke_order.h"
#include "nazori/surface/height_map.h"
#include "nazori/tablet/carved_tablet.h"
#include "options.h"
#include "output_files.h"
#include "own_tablet.h"
#include "tablet_picture.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

struct RenderSettings {
  std::vector<std::string> characters;
  std::string database;
  std::string output;
  std::string height_map;
  std::string strokes;
  std::optional<int> map_size;
  int stroke = 0;
  bool no_strokes = false;
  bool no_arrows = false;
  bool no_numbers = false;
  carving::Brush brush;
  Look look;
  bool json = false;
};

constexpr int kPictureSize = 1024;

base::Result<void> paint(Console& console, TabletPainter& painter, const tablet::CarvedTablet& tablet,
                         const RenderSettings& settings, const std::string& name, const OutputPlace& place) {
  const int strokes = static_cast<int>(tablet.lines().size());
  if (settings.stroke > strokes) {
    return base::fail(
        base::Errc::bad_argument, fmt::format("{} has {} stroke{}", name, strokes, strokes == 1 ? "" : "s"),
        fmt::format("--stroke {}", settings.stroke), fmt::format("give 0..{}, 0 for all", strokes));
  }
  view::Overlay overlay;
  overlay.strokes_visible = !settings.no_strokes;
  overlay.arrows_visible = !settings.no_arrows;
  overlay.numbers_visible = !settings.no_numbers;
  overlay.current_stroke = settings.stroke;
  auto saved = view::save_png(painter.paint(tablet, overlay), place.path());
  return saved ? place.deliver(console) : saved;
}

/// A picture in the answer. @param name  of the character or the file in it.
Json picture_json(const std::string& name, const OutputPlace& place, const RenderSettings& settings) {
  const auto size = parse_picture_size(settings.look.size).value_or(PictureSize{});
  return exchange::to_json(exchange::PaintedPicture{name, place.name(), size.width, size.height});
}

std::string picture_text(const std::string& name, const OutputPlace& place, const RenderSettings& settings) {
  return place.is_console() ? std::string()
                            : fmt::format("{}  {}  {}\n", name, place.name(), settings.look.size);
}

int run_own(Console& console, const RenderSettings& settings) {
  const auto path = output_file({"--output", settings.output, {".png"}});
  if (!path) return console.refuse(path.error());
  const NamedFile files[] = {{"--height-map", settings.height_map, NamedFile::Use::read},
                             {"--strokes", settings.strokes, NamedFile::Use::read},
                             {"--output", path->name()}};
  if (auto fine = check_distinct(files, settings.json); !fine) return console.refuse(fine.error());
  const auto tablet =
      own_tablet({settings.height_map, settings.strokes, settings.map_size}, kPictureSize, settings.brush);
  if (!tablet) return console.refuse(tablet.error());
  auto painter = TabletPainter::create(settings.look);
  if (!painter) return console.refuse(painter.error());
  const std::string name = settings.strokes.empty() ? settings.height_map : settings.strokes;
  if (auto done = paint(console, *painter, **tablet, settings, name, *path); !done)
    return console.refuse(done.error());
  console.print(settings.json ? to_text(Json::array({picture_json(name, *path, settings)}))
                              : picture_text(name, *path, settings));
  return kDone;
}

base::Result<std::shared_ptr<const tablet::CarvedTablet>> tablet_of(const kanji::Character& character,
                                                                    const RenderSettings& settings) {
  const int size = settings.map_size.value_or(kPictureSize);
  const auto made = made_character(character);
  if (!made) return tl::unexpected(made.error());
  return *made ? author::carved_tablet(**made, size)
               : tablet::CarvedTablet::from_lines(tablet::tablet_lines(character.lines()), size,
                                                  settings.brush);
}

int run_characters(Console& console, const RenderSettings& settings) {
  const auto names = kanji::parse_characters(settings.characters);
  if (!names) return console.refuse(names.error());
  const auto paths = output_files({"--output", settings.output, {".png"}}, *names);
  if (!paths) return console.refuse(paths.error());
  std::vector<NamedFile> files;
  for (const OutputPlace& place : *paths) files.push_back({"--output", place.name()});
  if (auto fine = check_distinct(files, settings.json); !fine) return console.refuse(fine.error());
  const auto characters = characters_with_strokes(console, settings.characters, settings.database);
  if (!characters) return characters.error();
  auto painter = TabletPainter::create(settings.look);
  if (!painter) return console.refuse(painter.error());

  Json document = Json::array();
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  for (std::size_t i = 0; i < characters->size(); ++i) {
    const std::string name = kanji::name_of((*characters)[i]).text();
    if (!progress.show(static_cast<double>(i) / static_cast<double>(characters->size()), "drawing " + name)) {
      return console.refuse({base::Errc::cancelled, "stopped", name, ""});
    }
    const auto tablet = tablet_of((*characters)[i], settings);
    if (!tablet) return console.refuse(tablet.error());
    if (auto done = paint(console, *painter, **tablet, settings, name, (*paths)[i]); !done)
      return console.refuse(done.error());
    if (settings.json) {
      document.push_back(picture_json(name, (*paths)[i], settings));
    } else {
      console.print(picture_text(name, (*paths)[i], settings));
    }
  }
  if (settings.json) console.print(to_text(document));
  return kDone;
}

int run(Console& console, const RenderSettings& settings) {
  const bool own = !settings.height_map.empty() || !settings.strokes.empty();
  if (own && !settings.characters.empty()) {
    return console.refuse({base::Errc::bad_argument, "give either a character or your own file, not both",
                           settings.height_map.empty() ? "--strokes" : "--height-map",
                           "omit the character or the file"});
  }
  if (!own && settings.characters.empty()) {
    return console.refuse({base::Errc::bad_argument, "nothing to draw", "",
                           "give a character such as 休, or --height-map or --strokes"});
  }
  return own ? run_own(console, settings) : run_characters(console, settings);
}

}  // namespace

void add_render(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<RenderSettings>();
  CLI::App* verb = app.add_subcommand("render", "Draw pictures of carved tablets (no display needed)");
  verb->add_option("characters", settings->characters,
                   "Characters, such as 休, 休日, 正-HzFst (a variant form) or U+4F11");
  verb->add_option("-o,--output", settings->output,
                   "Output .png. For several characters: a folder, or a name with {} for the character; - is "
                   "standard output")
      ->required()
      ->type_name("FILE");
  verb->add_option("--stroke", settings->stroke, "Draw only this stroke (0: all)")
      ->check(within(0, kanji::StrokeOrder::kMaxStrokes))
      ->capture_default_str()
      ->type_name("N");
  verb->add_flag("--no-strokes", settings->no_strokes, "Draw the tablet without strokes");
  verb->add_flag("--no-arrows", settings->no_arrows, "Draw no arrowheads");
  verb->add_flag("--no-numbers", settings->no_numbers, "Draw no stroke numbers");
  verb->add_flag("--json", settings->json, "Print JSON (see docs/command-line.md)");
  const std::string own = "Your own tablet instead of a character";
  verb->add_option("--height-map", settings->height_map, "A height map: 8-bit RAW or greyscale PNG")
      ->type_name("FILE")
      ->group(own);
  verb->add_option("--strokes", settings->strokes,
                   "A stroke order file (.str) on the grid of the height map; if given alone, it is carved")
      ->type_name("FILE")
      ->group(own);
  verb->add_option("--map-size", settings->map_size,
                   "Samples per side of the RAW or of the .str grid (default: from the size of the RAW file, "
                   "otherwise 128); for a character, of the carved map (default: 1024)")
      ->check(within(surface::HeightMap::kMinSize, surface::HeightMap::kMaxSize))
      ->type_name("N")
      ->group(own);
  add_look_options(*verb, settings->look);
  add_brush_options(*verb, settings->brush);
  add_database_option(*verb, settings->database);
  verb->footer(
      "Examples:\n  nazori-cli render 休 --output 休.png --tilt 30\n"
      "  nazori-cli render 休 木 --output 'pictures/{}.png' --style classic --size 600x600\n"
      "  nazori-cli render --height-map 0018.raw --map-size 128 --strokes 0018.str --output 0018.png");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
