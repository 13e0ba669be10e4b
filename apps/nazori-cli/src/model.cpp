// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "characters.h"
#include "json_answers.h"
#include "nazori/base/file.h"
#include "nazori/model/stand.h"
#include "nazori/practice/solid_model.h"
#include "nazori/practice/touch_file.h"
#include "options.h"
#include "output_files.h"
#include "own_tablet.h"
#include "solid_model.h"
#include "touch_options.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

constexpr int kModelMapSize = 513;

struct ModelSettings {
  std::vector<std::string> characters;
  std::string database;
  std::string output;
  std::string stand;
  OwnTablet own;
  bool raised = false;
  bool negative = false;
  bool no_numbers = false;
  bool no_start_dots = false;
  bool no_hole = false;
  std::optional<double> thickness_mm;
  model::TabletPlateSettings plate;
  carving::Brush brush;
  TouchOptions touch;
  bool json = false;
};

/// The tablets of a plate.
struct Tablets {
  std::string subject;
  std::vector<practice::SolidTablet> all;
  std::vector<practice::TouchLabel> labels;  ///< one for each tablet
};

base::Result<Tablets> own_tablets(const ModelSettings& settings) {
  const auto tablet = own_tablet(settings.own, kModelMapSize, settings.brush);
  if (!tablet) return tl::unexpected(tablet.error());
  if (settings.raised && (*tablet)->lines().empty()) {
    return base::fail(base::Errc::bad_argument, "a height map alone has no lines to raise", "--raised",
                      "also give --strokes");
  }
  Tablets tablets{settings.own.strokes.empty() ? settings.own.height_map : settings.own.strokes, {}, {}};
  tablets.all.push_back({tablet::stroke_lines((*tablet)->lines()), (*tablet)->height_map()});
  tablets.labels.push_back(practice::touch_label(std::filesystem::path(tablets.subject).stem().string(),
                                                 tablets.all.back().strokes.size()));
  return tablets;
}

base::Result<Tablets> tablets_of(const std::vector<kanji::Character>& characters) {
  Tablets tablets;
  for (const kanji::Character& character : characters) {
    tablets.subject += kanji::name_of(character).text();
    tablets.all.push_back({character.lines(), {}});
    const auto made = made_character(character);
    if (!made) return tl::unexpected(made.error());
    if (*made) {
      auto relief = author::carve(**made, kModelMapSize);
      if (!relief) return tl::unexpected(std::move(relief.error()));
      tablets.all.back().relief = *std::move(relief);
    }
    tablets.labels.push_back(practice::touch_label(character));
  }
  return tablets;
}

practice::SolidSettings solid_settings(const ModelSettings& settings) {
  practice::SolidSettings solid{settings.raised, settings.negative, settings.thickness_mm, settings.plate};
  solid.plate.hanging_hole = !settings.no_hole;
  solid.plate.strokes.numbers = !settings.no_numbers;
  solid.plate.strokes.start_dots = !settings.no_start_dots;
  return solid;
}

/// A file for a mill, a laser, swell paper or an embosser, by the name of the output; nothing for a solid.
std::optional<base::Result<practice::TouchFile>> make_touch_file(const Tablets& tablets,
                                                                 const ModelSettings& settings,
                                                                 const OutputPlace& place) {
  const auto kind = practice::touch_kind_of(place.path());
  if (!kind) return std::nullopt;
  const TouchOptions& touch = settings.touch;
  const auto solid = solid_settings(settings);
  if (*kind == practice::TouchKind::mill)
    return practice::mill_file(tablets.all, solid, touch.mill, tablets.subject, settings.brush);
  if (*kind == practice::TouchKind::laser)
    return practice::laser_file(tablets.all, solid, touch.layers, tablets.subject, settings.brush);
  std::vector<practice::LabelledTablet> labelled;
  for (std::size_t i = 0; i < tablets.all.size(); ++i)
    labelled.push_back({tablets.all[i], tablets.labels[i]});
  const bool numbers = !settings.no_numbers;
  const bool start_dots = !settings.no_start_dots;
  if (*kind == practice::TouchKind::embosser) {
    return practice::embosser_file(
        labelled, {touch.paper.embosser, {numbers, start_dots}, !touch.no_label, touch.english()});
  }
  return practice::swell_file(
      labelled,
      {settings.plate.side_mm, touch.paper.paper(), start_dots, numbers, !touch.no_label, touch.english()},
      tablets.subject);
}

/// Writes a file for a machine that prints no solid. @return the answer, in JSON or for people.
base::Result<std::string> save_touch(const base::Result<practice::TouchFile>& made, const Tablets& tablets,
                                     const ModelSettings& settings, const OutputPlace& place) {
  if (!made) return tl::unexpected(made.error());
  if (auto saved = base::write_file(place.path(), made->content); !saved)
    return tl::unexpected(saved.error());
  return settings.json ? to_text(exchange::to_json(answer_of(*made, tablets.subject, place.name())))
                       : touch_text(*made, tablets.subject, place.name());
}

/// Two feet for a plate. @return a line for people.
base::Result<std::string> save_stand(const model::Plate& plate, const Tablets& tablets,
                                     const OutputPlace& place) {
  model::StandSettings stand;
  stand.plate_height_mm = plate.height_mm();
  stand.plate_thickness_mm = plate.thickness_mm();
  practice::Solid solid;
  auto mesh = model::stand_mesh(stand);
  if (!mesh) return tl::unexpected(std::move(mesh.error()));
  solid.mesh = *std::move(mesh);
  if (auto saved = practice::save_solid(solid, place.path(), tablets.subject); !saved)
    return tl::unexpected(std::move(saved.error()));
  return fmt::format("stand  {}  two feet, leaning {:.3g} degrees\n", place.name(), stand.lean_deg);
}

/// Writes the model, and the feet that hold it. @return the answer, in JSON or for people.
base::Result<std::string> save(const Tablets& tablets, const ModelSettings& settings,
                               const OutputPlace& place, const std::optional<OutputPlace>& stand) {
  if (const auto touch = make_touch_file(tablets, settings, place))
    return save_touch(*touch, tablets, settings, place);
  const auto plate = practice::tablet_plate(tablets.all, solid_settings(settings), settings.brush);
  if (!plate) return tl::unexpected(plate.error());
  const auto made = save_model(*plate, place, tablets.subject);
  if (!made) return tl::unexpected(made.error());
  std::string answer = settings.json ? to_text(exchange::to_json(*made)) : model_text(*made);
  if (!stand) return answer;
  const auto line = save_stand(plate->plate, tablets, *stand);
  if (!line) return tl::unexpected(line.error());
  return settings.json ? answer : answer + *line;
}

int run(Console& console, const ModelSettings& settings) {
  const bool own = !settings.own.height_map.empty() || !settings.own.strokes.empty();
  if (own == !settings.characters.empty()) {
    return console.refuse({base::Errc::bad_argument, "give either characters or your own tablet", "",
                           "a character such as 休, or --height-map or --strokes"});
  }
  const auto place =
      output_file({"--output", settings.output, {".stl", ".3mf", ".pdf", ".brf", ".svg", ".nc"}});
  if (!place) return console.refuse(place.error());
  if (settings.plate.vertical && settings.plate.columns > 0)
    return console.refuse({base::Errc::bad_argument, "either rows or one column", "--columns",
                           "give --columns 1 for tablets below one another, or only --vertical"});
  std::optional<OutputPlace> stand;
  if (!settings.stand.empty()) {
    auto named = output_file({"--stand", settings.stand, {".stl", ".3mf"}});
    if (!named) return console.refuse(named.error());
    if (named->is_console())
      return console.refuse({base::Errc::bad_argument, "a stand does not go to standard output", "--stand",
                             "give the name of a file"});
    if (!has_extension(place->path(), ".stl") && !has_extension(place->path(), ".3mf"))
      return console.refuse({base::Errc::bad_argument, "paper and cut plates have no stand", "--stand",
                             "give an --output of .stl or .3mf, or leave it out"});
    stand = std::move(*named);
  }
  const NamedFile files[] = {{"--height-map", settings.own.height_map, NamedFile::Use::read},
                             {"--strokes", settings.own.strokes, NamedFile::Use::read},
                             {"--stand", settings.stand},
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
  const auto made = save(*tablets, settings, *place, stand);
  if (!made) return console.refuse(made.error());
  if (auto sent = place->deliver(console); !sent) return console.refuse(sent.error());
  if (!place->is_console()) console.print(*made);
  return kDone;
}

}  // namespace

void add_model(CLI::App& app, Action& chosen) {
  auto s = std::make_shared<ModelSettings>();
  CLI::App* verb = app.add_subcommand("model", "Make a solid model of a tablet, for a 3D printer");
  verb->add_option("characters", s->characters,
                   "Characters of one plate, such as 休, 休日, 正-HzFst (a variant form) or U+4F11");
  verb->add_option("-o,--output", s->output,
                   "Output file, by its name: .stl or .3mf (which says that its unit is the millimetre) for "
                   "a printer; "
                   ".nc (G-code) for a mill; .svg for a laser; .pdf for swell paper; .brf for a braille "
                   "embosser; - is "
                   "standard output (STL)")
      ->required()
      ->type_name("FILE");
  verb->add_flag(
      "--raised", s->raised,
      "Raised lines for fingers, with a dot at each start and the stroke order in braille; without it, "
      "grooves for a stylus");
  verb->add_flag("--negative", s->negative, "A mould for casting the tablet");
  verb->add_flag("--vertical", s->plate.vertical, "Several characters below one another");
  verb->add_option("--columns", s->plate.columns,
                   "Tablets in one row of a plate; others stand in rows below (default: all)")
      ->check(within(1, 50))
      ->type_name("N");
  verb->add_flag("--no-numbers", s->no_numbers, "No stroke order in braille (--raised, paper)");
  verb->add_flag("--no-start-dots", s->no_start_dots, "No mark where strokes start (--raised, paper)");
  verb->add_flag("--no-hole", s->no_hole, "No hole to hang it up");
  verb->add_option("--stand", s->stand, "Two feet that hold the plate, to print beside it: .stl or .3mf")
      ->type_name("FILE");
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
  verb->add_option("--gap-mm", s->plate.gap_mm, "Gap between the squares of several characters")
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
  add_touch_options(*verb, s->touch);
  add_brush_options(*verb, s->brush);
  add_database_option(*verb, s->database);
  verb->footer(
      "Examples:\n  nazori-cli model 休 --raised --output 休.3mf\n"
      "  nazori-cli model 休日 --size-mm 60 --output 休日.stl\n"
      "  nazori-cli model 木 --negative --size-mm 80 --output mould.stl\n"
      "  nazori-cli model 永休日 --columns 2 --gap-mm 10 --size-mm 60 --output tablets.stl\n"
      "  nazori-cli model 休 --output 休.pdf\n"
      "  nazori-cli model 休 --braille contracted --output 休.brf\n"
      "  nazori-cli model 休 --cutter-mm 2 --output 休.nc");
  verb->callback([s, &chosen] { chosen = [s](Console& console) { return run(console, *s); }; });
}

}  // namespace nazori::cli
