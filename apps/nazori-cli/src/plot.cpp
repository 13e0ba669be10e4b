// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "json_answers.h"
#include "nazori/base/file.h"
#include "nazori/exchange/plots.h"
#include "nazori/functions/braille.h"
#include "nazori/functions/data_points.h"
#include "nazori/functions/plate.h"
#include "nazori/functions/points.h"
#include "nazori/functions/print_picture.h"
#include "nazori/functions/sound.h"
#include "nazori/functions/tablet_curves.h"
#include "nazori/functions/value_table.h"
#include "nazori/practice/touch_plot.h"
#include "nazori/surface/height_map.h"
#include "options.h"
#include "output_files.h"
#include "solid_model.h"
#include "touch_options.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLargePlot = 1000;
constexpr double kLargePlot_ms = 400;

struct PlotSettings {
  std::string expression;
  std::vector<double> window;
  std::vector<double> heights;
  std::string axes = "on";
  std::string output;
  std::string mask;
  std::string print;
  std::string sound;
  std::string model;
  double model_side_mm = 120;
  PaperOptions paper;
  std::string language = "en";
  std::string speech = "verbose";
  std::vector<std::string> values;
  std::string data;
  std::string braille;
  std::vector<double> table;
  bool points = false;
  bool decimal_comma = false;
  bool json = false;
  functions::PlateSettings plate;
};

struct Files {
  std::optional<OutputPlace> output;
  std::optional<OutputPlace> mask;
  std::optional<OutputPlace> print;
  std::optional<OutputPlace> sound;
  std::optional<OutputPlace> model;
};

base::Result<Files> files_of(const PlotSettings& s) {
  Files files;
  std::vector<NamedFile> named;
  const auto check = [&named](std::optional<OutputPlace>& to, const std::string& option,
                              const std::string& text,
                              std::vector<std::string> extensions) -> base::Result<void> {
    if (text.empty()) return {};
    auto file = output_file({option, text, std::move(extensions)});
    if (!file) return tl::unexpected(std::move(file.error()));
    named.push_back({option, file->name()});
    to = std::move(*file);
    return {};
  };
  if (auto r = check(files.output, "--output", s.output, {".png", ".raw"}); !r)
    return tl::unexpected(r.error());
  if (auto r = check(files.mask, "--mask", s.mask, {".png"}); !r) return tl::unexpected(r.error());
  if (auto r = check(files.print, "--print", s.print, {".png"}); !r) return tl::unexpected(r.error());
  if (auto r = check(files.sound, "--sound", s.sound, {".wav"}); !r) return tl::unexpected(r.error());
  if (auto r = check(files.model, "--model", s.model, {".stl", ".3mf", ".pdf", ".brf"}); !r)
    return tl::unexpected(r.error());
  if (auto fine = check_distinct(named, s.json); !fine) return tl::unexpected(std::move(fine.error()));
  return files;
}

/// Puts a=1.5 into the expression.
base::Result<void> set_parameter(PlotSettings& s, const std::string& assignment) {
  const base::Error wrong{base::Errc::bad_argument, "\"" + assignment + "\" sets no parameter", "--set",
                          "give a letter of the expression and a number, such as a=1.5"};
  const std::size_t sign = assignment.find('=');
  if (sign == std::string::npos) return tl::unexpected(wrong);
  const std::string digits = assignment.substr(sign + 1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return tl::unexpected(wrong);
  auto text = functions::with_parameter(s.expression, assignment.substr(0, sign), value, {s.decimal_comma});
  if (!text) return tl::unexpected(wrong);
  s.expression = std::move(*text);
  return {};
}

base::Result<functions::Plot> read(PlotSettings& s) {
  std::vector<functions::DataPoint> data;
  if (!s.data.empty()) {
    auto points = functions::load_data_points(s.data, s.decimal_comma);
    if (!points) return tl::unexpected(std::move(points.error()));
    data = std::move(*points);
  }
  // A text that cannot be read is refused for what is wrong in it, not for what it does not define.
  auto plot = functions::parse(s.expression, {s.decimal_comma}, data);
  if (!plot) return tl::unexpected(plot.error().to_error());
  if (s.values.empty()) return std::move(*plot);
  for (const std::string& assignment : s.values) {
    if (auto done = set_parameter(s, assignment); !done) return tl::unexpected(std::move(done.error()));
  }
  plot = functions::parse(s.expression, {s.decimal_comma}, data);
  if (!plot) return tl::unexpected(plot.error().to_error());
  return std::move(*plot);
}

base::Result<void> save(const Files& files, const functions::Picture& picture, const functions::Plot& plot,
                        const std::vector<functions::PointOfInterest>& points) {
  if (files.output) {
    auto saved =
        has_extension(files.output->path(), ".raw")
            ? surface::save_raw(picture.plate.heights, files.output->path())
            : surface::save_png(picture.plate.heights, files.output->path(), surface::PngDepth::bits_16);
    if (!saved) return saved;
  }
  if (files.mask) {
    auto mask = surface::HeightMap::create(picture.plate.heights.size(), 0.0F);
    if (!mask) return tl::unexpected(mask.error());
    for (std::size_t i = 0; i < picture.plate.mask.size(); ++i)
      mask->samples()[i] = picture.plate.mask[i] != 0 ? 1.0F : 0.0F;
    if (auto saved = surface::save_png(*mask, files.mask->path(), surface::PngDepth::bits_8); !saved)
      return saved;
  }
  if (files.print) {
    const auto print = functions::print_picture(picture.tracing);
    if (!print) return tl::unexpected(print.error());
    if (auto saved = surface::save_png(*print, files.print->path(), surface::PngDepth::bits_8); !saved)
      return saved;
  }
  if (files.sound) {
    const auto sound = functions::sweep(plot, picture.tracing, points);
    if (!sound) return tl::unexpected(sound.error());
    return functions::save_wav(*sound, files.sound->path());
  }
  return {};
}

functions::BrailleCode braille_code(const std::string& name) {
  return name == "nemeth" ? functions::BrailleCode::nemeth : functions::BrailleCode::ueb;
}

/// The plot for fingers: raised lines or a raised surface as a solid, or lines on paper. @return what people
/// should know of it, a line or nothing.
base::Result<std::string> save_for_fingers(const functions::Plot& plot, const functions::Picture& picture,
                                           const PlotSettings& s, const OutputPlace& place) {
  if (const auto kind = practice::touch_kind_of(place.path())) {
    const practice::PlotPaper paper{s.model_side_mm, s.paper.paper(), s.paper.embosser,
                                    braille_code(s.braille)};
    const auto made = practice::plot_touch_file(*kind, plot, picture, paper);
    if (!made) return tl::unexpected(made.error());
    if (auto saved = base::write_file(place.path(), made->content); !saved)
      return tl::unexpected(std::move(saved.error()));
    return close_lines_text(*made);
  }
  const auto plate = practice::plot_plate(plot, picture, s.model_side_mm);
  if (!plate) return tl::unexpected(plate.error());
  const auto made = save_model(*plate, place, functions::canonical(plot));
  if (!made) return tl::unexpected(made.error());
  return {};
}

/// The file that goes to standard output, if any.
const OutputPlace* console_file(const Files& files) {
  for (const auto* place : {&files.output, &files.mask, &files.print, &files.sound, &files.model}) {
    if (*place && (*place)->is_console()) return &**place;
  }
  return nullptr;
}

/// x and y of each row, and "undefined".
base::Result<std::string> table_text(const functions::Plot& plot, const PlotSettings& s) {
  std::string text;
  for (const functions::Statement& statement : plot.statements) {
    const auto rows = functions::value_table(statement, {s.table[0], s.table[1], s.table[2]});
    if (!rows) return tl::unexpected(rows.error());
    text += functions::canonical(statement) + "\n";
    const auto shown = [](double v) {
      return std::isfinite(v) ? fmt::format("{:.10g}", v + 0.0) : std::string("undefined");
    };
    for (const functions::ValueRow& row : *rows)
      text += fmt::format("  {}\t{}\n", shown(row.x), shown(row.y));
  }
  return text;
}

/// What was typed, without the data of a file.
std::string typed_text(functions::Plot plot) {
  std::erase_if(plot.statements, [](const functions::Statement& s) { return s.is_data; });
  return functions::canonical(plot);
}

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

int run(Console& console, PlotSettings s) {
  const auto plot = read(s);
  if (!plot) return console.refuse(plot.error());
  functions::Window window;
  if (!s.window.empty()) window = {s.window[0], s.window[1], s.window[2], s.window[3]};
  if (auto good = window.check(); !good) {
    base::Error error = good.error();
    error.where = "--window";
    return console.refuse(error);
  }
  if (!s.heights.empty()) s.plate.heights = functions::HeightRange{s.heights[0], s.heights[1]};
  if (s.axes == "off") s.plate.layers = functions::Layers::none();
  const auto files = files_of(s);
  if (!files) return console.refuse(files.error());
  if (plot->is_surface() && files->sound)
    return console.refuse({base::Errc::bad_argument, "a surface has no sound", "--sound", "give a curve"});
  if (plot->is_surface() && files->print)
    return console.refuse(
        {base::Errc::bad_argument, "a surface has no lines to print", "--print", "give a curve"});
  if (plot->is_surface() && files->model && practice::touch_kind_of(files->model->path()))
    return console.refuse({base::Errc::bad_argument, "a surface has no lines for paper", "--model",
                           "give a curve, or a file .stl or .3mf"});

  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  const auto language = s.language == "ja" ? functions::Language::japanese : functions::Language::english;
  const auto style = s.speech == "brief"        ? functions::SpeechStyle::brief
                     : s.speech == "superbrief" ? functions::SpeechStyle::superbrief
                                                : functions::SpeechStyle::verbose;
  exchange::PlotTimings timings;
  const auto start = Clock::now();
  // A page of formulas must be answered, too, if not to the last detail: the summary says what is missing.
  const bool large = functions::part_count(*plot) > kLargePlot;
  const auto picture =
      functions::draw(*plot, window, s.plate, progress.callback(), large ? kLargePlot_ms : 0);
  timings.draw_ms = ms_since(start);
  progress.clear();
  if (!picture) return console.refuse(picture.error());
  const auto before = Clock::now();
  const auto points = functions::points_of_interest(*plot, picture->tracing);
  timings.points_ms = ms_since(before);
  if (auto saved = save(*files, *picture, *plot, points); !saved) return console.refuse(saved.error());
  std::string for_fingers;
  if (files->model) {
    auto saved = save_for_fingers(*plot, *picture, s, *files->model);
    if (!saved) return console.refuse(saved.error());
    for_fingers = *std::move(saved);
  }
  if (const OutputPlace* const file = console_file(*files)) {
    const auto sent = file->deliver(console);
    return sent ? kDone : console.refuse(sent.error());
  }
  std::string table;
  exchange::Value tables = exchange::Value::array();
  if (!s.table.empty()) {
    auto text = table_text(*plot, s);
    if (!text) {
      base::Error error = text.error();
      if (error.where == "table") error.where = "--table";
      return console.refuse(error);
    }
    table = std::move(*text);
    for (const functions::Statement& statement : plot->statements)
      tables.push_back(
          exchange::to_json(*functions::value_table(statement, {s.table[0], s.table[1], s.table[2]})));
  }
  if (s.json) {
    exchange::Value answer = exchange::to_json(*plot, *picture, points, timings, language, style);
    if (!s.table.empty()) answer["tables"] = std::move(tables);
    console.print(to_text(std::move(answer)));
    return kDone;
  }
  console.print(typed_text(*plot) + "\n" +
                functions::summary(*plot, picture->tracing, points, language, style) + "\n");
  if (!s.braille.empty()) console.print(functions::in_braille(*plot, braille_code(s.braille)) + "\n");
  console.print(for_fingers);
  for (const functions::SyntaxError& q : plot->questions)
    console.print(fmt::format("Column {}: {}\n", q.column, functions::question_words(q, language)));
  console.print(table);
  if (s.points) {
    for (const auto& p : points) console.print("  " + functions::in_words(p, language, style) + "\n");
  }
  return kDone;
}

}  // namespace

void add_plot(CLI::App& app, Action& chosen) {
  auto s = std::make_shared<PlotSettings>();
  CLI::App* verb = app.add_subcommand("plot", "Carve the graph of an expression");
  verb->add_option(
          "expression", s->expression,
          "y = tan(x), x^2 + y^2 = 1, y > x^2, x = cos(t); y = sin(t); 0 <= t <= pi, r = 1 + cos(theta), "
          "z = sin(x)cos(y), y = {x<0: -x, x>=0: x}, y = x^2 {0<=x<=2}, f(x) = a x^2; a = 2; y = f'(x), "
          "y = [1, 2, 3] x, (1, 2), ([1, 2, 3], [2, 4, 5]); y ~ a x + b; several curves separated by ;")
      ->required();
  verb->add_option("--window", s->window, "Visible range of the plane (default: -10,10,-10,10)")
      ->delimiter(',')
      ->expected(4)
      ->type_name("X0,X1,Y0,Y1");
  verb->add_option("--z", s->heights, "Height range of a surface (default: fits its values)")
      ->delimiter(',')
      ->expected(2)
      ->type_name("LOW,HIGH");
  verb->add_option("--size", s->plate.size, "Samples per side of the plot")
      ->check(within(32, 4096))
      ->capture_default_str()
      ->type_name("N");
  verb->add_option("--half-width", s->plate.half_width, "Half the groove width as a fraction of the side")
      ->check(within(0.001, 0.2))
      ->capture_default_str()
      ->type_name("FRACTION");
  verb->add_option("--axes", s->axes, "Axes, ticks and frame: on or off")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str()
      ->type_name("on|off");
  verb->add_flag("--grid", s->plate.layers.grid, "Fine ridges at every tick");
  verb->add_option("-o,--output", s->output,
                   "Output height map: .png (16-bit greyscale, white is the plateau) or .raw (8 bits); - is "
                   "standard output (PNG)")
      ->type_name("FILE");
  verb->add_option("--mask", s->mask, "Mask of what is carved or defined: 8-bit greyscale PNG with 255 and 0")
      ->type_name("FILE");
  verb->add_option("--print", s->print,
                   "Black lines on white for swell paper and low vision, 160 mm at 300 dpi")
      ->type_name("FILE");
  verb->add_option("--sound", s->sound, "Sound of the curves as WAV: pitch is height, left to right is x")
      ->type_name("FILE");
  verb->add_option(
          "--model", s->model,
          "For fingers: raised curves or a raised surface, axes, and ticks in braille: .stl or .3mf for a "
          "printer; curves on paper: .pdf for swell paper, .brf for a braille embosser")
      ->type_name("FILE");
  verb->add_option("--model-size-mm", s->model_side_mm,
                   "Side of the square of the plot in the model or on swell paper")
      ->check(within(40, 400))
      ->capture_default_str()
      ->type_name("MM");
  add_paper_options(*verb, s->paper, "Paper for fingers (--model)");
  verb->add_flag("--decimal-comma", s->decimal_comma,
                 "Read 1,5 as a decimal number in argument lists too: min(1,5; x)");
  verb->add_option("--set", s->values, "Value of a parameter of the expression: --set a=1.5")
      ->allow_extra_args(false)
      ->type_name("LETTER=NUMBER");
  verb->add_option(
          "--data", s->data,
          "Measured points, drawn and fitted by models such as y ~ a x + b: a CSV file with the columns x "
          "and y")
      ->type_name("FILE");
  verb->add_option("--table", s->table, "Table of values of each curve: x (or its parameter) from, to, step")
      ->delimiter(',')
      ->expected(3)
      ->type_name("FROM,TO,STEP");
  verb->add_option("--braille", s->braille,
                   "Expressions in Braille, too: nemeth or ueb; on paper for fingers (default there: ueb)")
      ->check(CLI::IsMember({"nemeth", "ueb"}))
      ->type_name("nemeth|ueb");
  verb->add_flag("--points", s->points, "List the points of interest");
  verb->add_flag("--json", s->json, "Answer in JSON (see docs/functions.md)");
  verb->add_option("--language", s->language, "Language of the sentences: en or ja")
      ->check(CLI::IsMember({"en", "ja"}))
      ->capture_default_str()
      ->type_name("en|ja");
  verb->add_option("--speech", s->speech, "How much is said around parts of an expression")
      ->check(CLI::IsMember({"verbose", "brief", "superbrief"}))
      ->capture_default_str()
      ->type_name("verbose|brief|superbrief");
  verb->footer(
      "Examples:\n  nazori-cli plot 'y = tan(x); y = 1' --window=-6,6,-4,4 --output tan.png --points\n"
      "  nazori-cli plot 'r = 1 + cos(theta)' --window=-1,3,-2,2 --sound heart.wav --json\n"
      "  nazori-cli plot 'y ~ a x + b' --data measured.csv\n"
      "  nazori-cli plot '([0, 1, 2], [1, 2, 5]); y ~ a e^(b x)'\n"
      "  nazori-cli plot 'y = integral(sin(t)/t, t, 0, x); area(x^2, 0, 2)' --points");
  verb->callback([s, &chosen] { chosen = [s](Console& console) { return run(console, *s); }; });
}

}  // namespace nazori::cli
