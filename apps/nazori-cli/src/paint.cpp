// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "brush_script.h"
#include "characters.h"
#include "json_answers.h"
#include "nazori/author/font_model.h"
#include "nazori/base/utf8.h"
#include "nazori/brush/held_brush.h"
#include "nazori/calligraphy/brush_widths.h"
#include "nazori/calligraphy/sheet_export.h"
#include "nazori/calligraphy/teacher_hand.h"
#include "nazori/exchange/tablets.h"
#include "nazori/paint/sheet.h"
#include "nazori/paint/sheet_picture.h"
#include "nazori/surface/colour_picture.h"
#include "options.h"
#include "output_files.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

namespace fs = std::filesystem;

/// Slots of the palette.
constexpr std::size_t kInk = 0, kTeacher = 1;
constexpr int kStepsPerFrame = 2;
/// A recording that rests for longer is most likely a mistake.
constexpr double kLongestWriting_s = 600;

struct PaintSettings {
  std::string script;
  std::string output;
  std::string frames;
  std::string database;
  std::string model_font;
  std::string paper = "hanshi";
  std::string hair = "mixed";
  std::string ink = "sumi";
  int number = 6;
  int cells = paint::Sheet::kLargest;
  double load = 1;
  double strength = 1;
  double size_mm = 85;
  double lean_deg = 0;
  double after_s = 5;
  bool model = false;
  bool json = false;
};

const std::map<std::string, brush::Hair>& hairs() {
  static const std::map<std::string, brush::Hair> all{
      {"goat", brush::Hair::goat}, {"mixed", brush::Hair::mixed}, {"weasel", brush::Hair::weasel}};
  return all;
}

base::Result<paint::Paper> paper_of(const std::string& name) {
  return has_extension(name, ".txt") ? paint::load_paper(name) : paint::find_paper(name);
}

/// Writes samples on a sheet, and a picture of every second step where a folder is given.
class Writing {
 public:
  Writing(paint::Sheet& sheet, const brush::TuftForm& form, std::string frames)
      : sheet_(sheet), form_(form), frames_(std::move(frames)) {}

  /// @return the ink that is left in the brush, 0..1.
  base::Result<double> write(const std::vector<brush::PenSample>& samples, std::size_t slot,
                             const PaintSettings& settings, ProgressDisplay& progress) {
    paint::Concentrations ink{};
    ink[slot] = settings.strength;
    paint::InkLoad load = paint::dipped(form_.holds_m3, settings.load, ink, ink);
    brush::HeldBrush brush(form_);
    double passed_s = samples.empty() ? 0 : samples.front().time_s;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      for (; passed_s + paint::Sheet::kStep_s <= samples[i].time_s; passed_s += paint::Sheet::kStep_s)
        if (auto done = step(); !done) return tl::unexpected(done.error());
      brush::PenSample sample = samples[i];
      sample.lean_rad = settings.lean_deg * std::numbers::pi / 180;
      // The upper end leans to the right and towards the writer, as in a right hand.
      sample.lean_to_rad = -std::numbers::pi / 4;
      const bool was_down = brush.pen().is_down();
      const auto swept = brush.move(sample, load.fullness());
      sheet_.touch(swept, load);
      if (sample.is_down()) {
        if (!was_down) strokes_.emplace_back();
        calligraphy::add_point(strokes_.back(), sample, swept);
      }
      if (!progress.show(static_cast<double>(i) / static_cast<double>(samples.size()), "writing"))
        return base::fail(base::Errc::cancelled, "stopped", settings.script);
    }
    return load.fullness();
  }

  base::Result<void> wait(double seconds) {
    const int steps = static_cast<int>(std::lround(seconds / paint::Sheet::kStep_s));
    for (int i = 0; i < steps; ++i)
      if (auto done = step(); !done) return done;
    return {};
  }

  [[nodiscard]] int frames() const { return saved_; }
  /// All strokes that touched the paper, in their order.
  [[nodiscard]] const std::vector<calligraphy::BrushStroke>& strokes() const { return strokes_; }

 private:
  base::Result<void> step() {
    sheet_.step();
    if (frames_.empty() || ++steps_ % kStepsPerFrame != 0) return {};
    picture_.update(sheet_);
    return surface::save_png(picture_.picture(), fs::path(frames_) / fmt::format("{:05}.png", ++saved_));
  }

  paint::Sheet& sheet_;
  brush::TuftForm form_;
  std::string frames_;
  paint::SheetPicture picture_;
  std::vector<calligraphy::BrushStroke> strokes_;
  int steps_ = 0, saved_ = 0;
};

base::Result<void> check(const BrushScript& script, const PaintSettings& settings) {
  if (!settings.frames.empty()) {
    std::error_code error;
    if (!fs::is_directory(settings.frames, error))
      return base::fail(base::Errc::bad_argument,
                        fmt::format("the folder {} does not exist", settings.frames), "--frames",
                        "create it first");
  }
  if (settings.model && !script.character)
    return base::fail(base::Errc::bad_argument, "does not say which character it is", settings.script,
                      fmt::format("give \"char\" in handwriting, or omit {}",
                                  settings.model_font.empty() ? "--model" : "--model-font"));
  if (script.samples.empty() && !settings.model)
    return base::fail(base::Errc::bad_argument, "has no strokes", settings.script);
  if (!script.samples.empty() &&
      script.samples.back().time_s - script.samples.front().time_s > kLongestWriting_s)
    return base::fail(base::Errc::bad_argument, fmt::format("takes longer than {} s", kLongestWriting_s),
                      settings.script, "give a part of it");
  return {};
}

/// Area that has pigment, of whatever age [mm^2].
double painted_mm2(const paint::Sheet& sheet) {
  constexpr paint::Amount kVisible = paint::kOne / 50;
  long cells = 0;
  for (int row = 0; row < sheet.size(); ++row) {
    for (int column = 0; column < sheet.size(); ++column) {
      const paint::Cell cell = sheet.at(column, row);
      paint::TotalAmount pigment = cell.covered;
      for (std::size_t k = 0; k < paint::kSlots; ++k)
        pigment += paint::TotalAmount{cell.moving[k]} + cell.fixed[k];
      if (pigment >= kVisible) ++cells;
    }
  }
  return static_cast<double>(cells) * sheet.cell_m() * sheet.cell_m() * 1e6;
}

/// As the extension says: strokes, a page, or a picture.
base::Result<void> save(const paint::Sheet& sheet, std::span<const calligraphy::BrushStroke> strokes,
                        const std::string& script, const fs::path& path) {
  if (has_extension(path.string(), ".svg")) return calligraphy::save_svg(strokes, path);
  if (has_extension(path.string(), ".pdf"))
    return calligraphy::save_pdf(sheet, fs::path(script).stem().string(), path);
  paint::SheetPicture picture;
  picture.update(sheet);
  return surface::save_png(picture.picture(), path);
}

base::Result<exchange::PaintedSheet> paint_sheet(const BrushScript& script,
                                                 const std::vector<brush::PenSample>& model,
                                                 const PaintSettings& settings, const OutputPlace& place,
                                                 ProgressDisplay& progress) {
  const auto form = brush::tuft_form(settings.number, hairs().at(settings.hair));
  if (!form) return tl::unexpected(form.error());
  const auto paper = paper_of(settings.paper);
  if (!paper) return tl::unexpected(paper.error());
  const auto ink = paint::find_pigment(settings.ink);
  if (!ink) return tl::unexpected(ink.error());
  const auto teacher = paint::find_pigment("vermilion");
  if (!teacher) return tl::unexpected(teacher.error());
  auto sheet = paint::Sheet::create(settings.cells, *paper, {*ink, *teacher, *ink});
  if (!sheet) return tl::unexpected(sheet.error());

  Writing writing(*sheet, *form, settings.frames);
  if (!model.empty()) {
    if (auto done = writing.write(model, kTeacher, settings, progress); !done)
      return tl::unexpected(done.error());
    sheet->dry_now();
  }
  const std::size_t of_model = writing.strokes().size();
  const auto left = writing.write(script.samples, kInk, settings, progress);
  if (!left) return tl::unexpected(left.error());
  if (auto done = writing.wait(settings.after_s); !done) return tl::unexpected(done.error());
  const std::span<const calligraphy::BrushStroke> strokes = writing.strokes();
  if (auto saved =
          save(*sheet, strokes.subspan(script.samples.empty() ? 0 : of_model), settings.script, place.path());
      !saved)
    return tl::unexpected(saved.error());

  exchange::PaintedSheet painted;
  painted.script = settings.script;
  painted.file = place.name();
  painted.paper = settings.paper;
  painted.brush = settings.hair;
  painted.size = sheet->size();
  painted.samples = script.samples.size();
  painted.seconds = script.samples.empty() ? 0 : script.samples.back().time_s - script.samples.front().time_s;
  painted.painted_mm2 = painted_mm2(*sheet);
  painted.ink_left = *left;
  painted.frames = writing.frames();
  return painted;
}

/// The model as a hand writes it, and the font that it is from; empty: printed lines.
struct WrittenModel {
  std::vector<brush::PenSample> samples;
  std::string font;
};

base::Result<WrittenModel> written_model(Console& console, const kanji::Character& character,
                                         const PaintSettings& settings) {
  const auto form = brush::tuft_form(settings.number, hairs().at(settings.hair));
  if (!form) return tl::unexpected(form.error());
  const calligraphy::RuledSquare square{{}, settings.size_mm * 1e-3};
  const auto write = [&form](const std::vector<calligraphy::ModelStroke>& strokes) {
    return calligraphy::teacher_hand(strokes, calligraphy::BrushWidths(*form));
  };
  if (!settings.model_font.empty()) {
    const auto found = author::font_model(character.code_point, character.lines(), settings.model_font);
    if (found)
      return WrittenModel{write(calligraphy::model_strokes(author::grooves_of(found->strokes), square)),
                          settings.model_font};
    if (found.error().code != base::Errc::not_found) return tl::unexpected(found.error());
    console.inform(base::to_line(found.error()) + ": the model has printed lines");
  }
  return WrittenModel{write(calligraphy::model_strokes(character.lines(), square)), {}};
}

int run(Console& console, const PaintSettings& settings) {
  const auto place = output_file({"--output", settings.output, {".png", ".svg", ".pdf"}});
  if (!place) return console.refuse(place.error());
  const NamedFile files[] = {{"script", settings.script, NamedFile::Use::read}, {"--output", place->name()}};
  if (auto fine = check_distinct(files, settings.json); !fine) return console.refuse(fine.error());
  const auto script = read_brush_script(settings.script, settings.size_mm * 1e-3);
  if (!script) return console.refuse(script.error());
  if (auto fine = check(*script, settings); !fine) return console.refuse(fine.error());
  WrittenModel model;
  if (settings.model) {
    const std::string name = base::encode_utf8(*script->character);
    const auto characters = characters_with_strokes(console, std::vector{name}, settings.database);
    if (!characters) return characters.error();
    auto made = written_model(console, characters->front(), settings);
    if (!made) return console.refuse(made.error());
    model = std::move(*made);
  }
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  auto painted = paint_sheet(*script, model.samples, settings, *place, progress);
  progress.clear();
  if (!painted) return console.refuse(painted.error());
  painted->model_font = model.font;
  if (auto sent = place->deliver(console); !sent) return console.refuse(sent.error());
  if (place->is_console()) return kDone;
  console.print(settings.json
                    ? to_text(exchange::to_json(*painted))
                    : fmt::format("{}  {} on {}, {:.1f} s, {:.0f} mm² painted\n", painted->file,
                                  painted->script, painted->paper, painted->seconds, painted->painted_mm2));
  return kDone;
}

}  // namespace

void add_paint(CLI::App& app, Action& chosen) {
  auto s = std::make_shared<PaintSettings>();
  CLI::App* verb = app.add_subcommand("paint", "Write a recorded motion with brush and ink, as a picture");
  verb->add_option("script", s->script,
                   "A trajectory (.csv, as record export writes) or handwriting (.json, one object as for "
                   "grade)")
      ->required();
  verb->add_option(
          "-o,--output", s->output,
          "Output .png (picture), .svg (strokes) or .pdf (page at real size); - is a .png on standard "
          "output")
      ->required()
      ->type_name("FILE");
  verb->add_option("--frames", s->frames, "Also write 30 pictures per second to this folder: 00001.png, ...")
      ->type_name("FOLDER");
  verb->add_flag("--model", s->model,
                 "First write the model of the character that handwriting names, in vermilion");
  verb->add_option("--model-font", s->model_font,
                   "The same, as an installed brush font writes it; printed lines where it lacks the "
                   "character or has other strokes")
      ->type_name("FAMILY");
  verb->add_flag("--json", s->json, "Print JSON (see docs/command-line.md)");
  const std::string tools = "Brush, ink and paper";
  verb->add_option("--paper", s->paper,
                   "hanshi, gasenshi, gasenshi-slow, board, water, or a file of parameters (.txt)")
      ->capture_default_str()
      ->type_name("KIND")
      ->group(tools);
  verb->add_option("--brush", s->hair, "Hair of the brush: goat, mixed or weasel")
      ->check(CLI::IsMember(hairs()))
      ->capture_default_str()
      ->type_name("KIND")
      ->group(tools);
  verb->add_option("--number", s->number, "Size of the brush, 1 is the thickest")
      ->check(within(brush::kThickestBrush, brush::kThinnestBrush))
      ->capture_default_str()
      ->type_name("N")
      ->group(tools);
  verb->add_option("--ink", s->ink, "Pigment, such as sumi, sumi-blue, sumi-brown or vermilion")
      ->capture_default_str()
      ->type_name("NAME")
      ->group(tools);
  verb->add_option("--load", s->load, "How full the brush is")
      ->check(within(0, 1))
      ->capture_default_str()
      ->type_name("FRACTION")
      ->group(tools);
  verb->add_option("--strength", s->strength, "Pigment in the ink; 1 is undiluted")
      ->check(within(0, 4))
      ->capture_default_str()
      ->type_name("FRACTION")
      ->group(tools);
  verb->add_option("--lean", s->lean_deg, "Lean of the holder to the lower right")
      ->check(within(0, 60))
      ->capture_default_str()
      ->type_name("DEG")
      ->group(tools);
  const std::string sheet = "Sheet";
  verb->add_option("--size-mm", s->size_mm, "Side of the square of handwriting, on a sheet of 102.4 mm")
      ->check(within(10, 102))
      ->capture_default_str()
      ->type_name("MM")
      ->group(sheet);
  verb->add_option("--cells", s->cells, "Pixels per side of the sheet")
      ->check(CLI::IsMember({128, 256, 512, 1024}))
      ->capture_default_str()
      ->type_name("N")
      ->group(sheet);
  verb->add_option("--after", s->after_s, "Seconds that pass after the last stroke")
      ->check(within(0, 600))
      ->capture_default_str()
      ->type_name("SECONDS")
      ->group(sheet);
  add_database_option(*verb, s->database);
  verb->footer(
      "Examples:\n  nazori-cli paint session.csv --output session.png --paper gasenshi\n"
      "  nazori-cli paint writing.json --output writing.png --brush goat --model\n"
      "  nazori-cli paint writing.json --output writing.png --model-font KouzanBrushFont");
  verb->callback([s, &chosen] {
    s->model = s->model || !s->model_font.empty();
    chosen = [s](Console& console) { return run(console, *s); };
  });
}

}  // namespace nazori::cli
