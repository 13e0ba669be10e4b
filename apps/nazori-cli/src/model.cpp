// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "characters.h"
#include "json_answers.h"
#include "nazori/practice/solid_model.h"
#include "options.h"
#include "output_files.h"
#include "own_tablet.h"
#include "solid_model.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

constexpr int kModelMapSize = 513;

struct ModelSettings {
  std::vector<std::string> characters;
  std::string database;
  std::string output;
  OwnTablet own;
  bool raised = false;
  bool negative = false;
  bool no_numbers = false;
  bool no_start_dots = false;
  bool no_hole = false;
  std::optional<double> thickness_mm;
  model::TabletPlateSettings plate;
  carving::Brush brush;
  bool json = false;
};

/// The tablets of a plate.
struct Tablets {
  std::string subject;
  std::vector<practice::SolidTablet> all;
};

base::Result<Tablets> own_tablets(const ModelSettings& settings) {
  const auto tablet = own_tablet(settings.own, kModelMapSize, settings.brush);
  if (!tablet) return tl::unexpected(tablet.error());
  if (settings.raised && (*tablet)->lines().empty()) {
    return base::fail(base::Errc::bad_argument, "a height map alone has no lines to raise", "--raised",
                      "also give --strokes");
  }
  Tablets tablets{settings.own.strokes.empty() ? settings.own.height_map : settings.own.strokes, {}};
  tablets.all.push_back({tablet::stroke_lines((*tablet)->lines()), (*tablet)->height_map()});
  return tablets;
}

Tablets tablets_of(const std::vector<kanji::Character>& characters) {
  Tablets tablets;
  for (const kanji::Character& character : characters) {
    tablets.subject += kanji::name_of(character).text();
    tablets.all.push_back({character.lines(), {}});
  }
  return tablets;
}

base::Result<exchange::SolidModel> make(const Tablets& tablets, const ModelSettings& settings,
                                        const OutputPlace& place) {
  practice::SolidSettings solid{settings.raised, settings.negative, settings.thickness_mm, settings.plate};
  solid.plate.hanging_hole = !settings.no_hole;
  solid.plate.strokes.numbers = !settings.no_numbers;
  solid.plate.strokes.start_dots = !settings.no_start_dots;
  const auto plate = practice::tablet_plate(tablets.all, solid, settings.brush);
  if (!plate) return tl::unexpected(plate.error());
  return save_model(*plate, place, tablets.subject);
}

int run(Console& console, const ModelSettings& settings) {
  const bool own = !settings.own.height_map.empty() || !settings.own.strokes.empty();
  if (own == !settings.characters.empty()) {
    return console.refuse({base::Errc::bad_argument, "give either characters or your own tablet", "",
                           "a character such as 休, or --height-map or --strokes"});
  }
  const auto place = output_file({"--output", settings.output, {".stl", ".3mf"}});
  if (!place) return console.refuse(place.error());
  const NamedFile files[] = {{"--height-map", settings.own.height_map, NamedFile::Use::read},
                             {"--strokes", settings.own.strokes, NamedFile::Use::read},
                             {"--output", place->name()}};
  if (auto fine = check_distinct(files, settings.json); !fine) return console.refuse(fine.error());
  base::Result<Tablets> tablets;
  if (own) {
    tablets = own_tablets(settings);
  } else {
    const auto characters = characters_with_strokes(console, settings.characters, settings.database);
    if (!characters) return characters.error();
    tablets = tablets_of(*characters);
  }
  if (!tablets) return console.refuse(tablets.error());
  const auto made = make(*tablets, settings, *place);
  if (!made) return console.refuse(made.error());
  if (auto sent = place->deliver(console); !sent) return console.refuse(sent.error());
  if (!place->is_console())
    console.print(settings.json ? to_text(exchange::to_json(*made)) : model_text(*made));
  return kDone;
}

}  // namespace

void add_model(CLI::App& app, Action& chosen) {
  auto s = std::make_shared<ModelSettings>();
  CLI::App* verb = app.add_subcommand("model", "Make a solid model of a tablet, for a 3D printer");
  verb->add_option("characters", s->characters,
                   "Characters of one plate, such as 休, 休日, 正-HzFst (a variant form) or U+4F11");
  verb->add_option(
          "-o,--output", s->output,
          "Output file: .stl or .3mf (which says that its unit is the millimetre); - is standard output "
          "(STL)")
      ->required()
      ->type_name("FILE");
  verb->add_flag(
      "--raised", s->raised,
      "Raised lines for fingers, with a dot at each start and the stroke order in braille; without it, "
      "grooves for a stylus");
  verb->add_flag("--negative", s->negative, "A mould for casting the tablet");
  verb->add_flag("--vertical", s->plate.vertical, "Several characters below one another");
  verb->add_flag("--no-numbers", s->no_numbers, "No stroke order in braille (--raised)");
  verb->add_flag("--no-start-dots", s->no_start_dots, "No dots where strokes start (--raised)");
  verb->add_flag("--no-hole", s->no_hole, "No hole to hang it up");
  verb->add_flag("--json", s->json, "Print JSON (see docs/command-line.md)");
  const std::string sizes = "Sizes";
  verb->add_option("--size-mm", s->plate.side_mm, "Side of the square of each character")
      ->check(within(10, 500))
      ->capture_default_str()
      ->type_name("MM")
      ->group(sizes);
  verb->add_option("--margin-mm", s->plate.margin_mm, "Margin around the characters")
      ->check(within(0, 100))
      ->capture_default_str()
      ->type_name("MM")
      ->group(sizes);
  verb->add_option("--thickness-mm", s->thickness_mm,
                   "Thickness of the plate (default: 6, with raised lines 3)")
      ->check(within(0.4, 100))
      ->type_name("MM")
      ->group(sizes);
  verb->add_option("--depth-mm", s->plate.depth_mm, "Depth of the deepest groove")
      ->check(within(0.1, 99))
      ->capture_default_str()
      ->type_name("MM")
      ->group(sizes);
  verb->add_option("--line-height-mm", s->plate.strokes.line.height_mm, "Height of raised lines")
      ->check(within(0.2, 10))
      ->capture_default_str()
      ->type_name("MM")
      ->group(sizes);
  verb->add_option("--line-width-mm", s->plate.strokes.line.width_mm,
                   "Width of raised lines at half their height")
      ->check(within(0.4, 10))
      ->capture_default_str()
      ->type_name("MM")
      ->group(sizes);
  const std::string own = "Your own tablet instead of characters";
  verb->add_option("--height-map", s->own.height_map, "A height map: 8-bit RAW or greyscale PNG")
      ->type_name("FILE")
      ->group(own);
  verb->add_option("--strokes", s->own.strokes,
                   "A stroke order file (.str) on the grid of the height map; if given alone, it is carved")
      ->type_name("FILE")
      ->group(own);
  verb->add_option("--map-size", s->own.map_size,
                   "Samples per side of the RAW or of the .str grid (default: from the size of the RAW file, "
                   "otherwise 128)")
      ->check(within(surface::HeightMap::kMinSize, surface::HeightMap::kMaxSize))
      ->type_name("N")
      ->group(own);
  add_brush_options(*verb, s->brush);
  add_database_option(*verb, s->database);
  verb->footer(
      "Examples:\n  nazori-cli model 休 --raised --output 休.3mf\n"
      "  nazori-cli model 休日 --size-mm 60 --output 休日.stl\n"
      "  nazori-cli model 木 --negative --size-mm 80 --output mould.stl");
  verb->callback([s, &chosen] { chosen = [s](Console& console) { return run(console, *s); }; });
}

}  // namespace nazori::cli
