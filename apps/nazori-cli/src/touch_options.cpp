// SPDX-License-Identifier: Apache-2.0
#include "touch_options.h"

#include <fmt/format.h>

#include <cmath>

#include "named.h"
#include "nazori/model/laser.h"
#include "options.h"
#include "solid_model.h"

namespace nazori::cli {
namespace {

std::string kind_of(practice::TouchKind kind) {
  switch (kind) {
    case practice::TouchKind::mill:
      return "mill";
    case practice::TouchKind::laser:
      return "laser";
    case practice::TouchKind::swell_paper:
      return "swell-paper";
    case practice::TouchKind::embosser:
      break;
  }
  return "embosser";
}

}  // namespace

void add_touch_options(CLI::App& verb, TouchOptions& o) {
  const std::string mill = "Mill (.nc)";
  const auto number = [&](const std::string& name, double& value, const std::string& what, double low,
                          double high, const std::string& unit) {
    verb.add_option(name, value, what)
        ->check(within(low, high))
        ->capture_default_str()
        ->type_name(unit)
        ->group(mill);
  };
  number("--cutter-mm", o.mill.cutter_mm, "Diameter of the ball cutter", 0.2, 20, "MM");
  number("--step-over-mm", o.mill.step_over_mm, "Distance of neighbouring lines of the last pass", 0.02, 5,
         "MM");
  number("--pass-depth-mm", o.mill.pass_depth_mm, "Depth of one pass", 0.05, 50, "MM");
  number("--safe-mm", o.mill.safe_mm, "Height of rapid moves above the plate", 1, 100, "MM");
  number("--feed", o.mill.feed_mm_min, "Speed along a groove", 10, 20'000, "MM/MIN");
  number("--plunge", o.mill.plunge_mm_min, "Speed straight down", 10, 20'000, "MM/MIN");
  number("--spindle-rpm", o.mill.spindle_rpm, "Speed of the spindle", 0, 60'000, "RPM");
  verb.add_option("--layers", o.layers, "Steps of depth")
      ->check(within(model::kFewestLayers, model::kMostLayers))
      ->capture_default_str()
      ->type_name("N")
      ->group("Laser (.svg)");
  const std::string paper = "Swell paper (.pdf) and embosser (.brf)";
  add_paper_options(verb, o.paper, paper);
  verb.add_option("--braille", o.braille,
                  "English of the meanings: uncontracted, or contracted (Unified English Braille, grade 2)")
      ->check(CLI::IsMember({"uncontracted", "contracted"}))
      ->capture_default_str()
      ->type_name("HOW")
      ->group(paper);
  verb.add_flag("--no-label", o.no_label, "No meaning, number of strokes and readings in braille")
      ->group(paper);
}

void add_paper_options(CLI::App& verb, PaperOptions& o, const std::string& group) {
  verb.add_option("--paper", o.swell, "Swell paper: a4, b5 or letter")
      ->check(CLI::IsMember({"a4", "b5", "letter"}))
      ->capture_default_str()
      ->type_name("PAPER")
      ->group(group);
  verb.add_option("--columns-braille", o.embosser.columns, "Cells in a line of the embosser")
      ->check(within(12, 100))
      ->capture_default_str()
      ->type_name("N")
      ->group(group);
  verb.add_option("--lines-braille", o.embosser.lines, "Lines on a page of the embosser")
      ->check(within(12, 100))
      ->capture_default_str()
      ->type_name("N")
      ->group(group);
}

print::Paper PaperOptions::paper() const { return named(print::kPaperNames, swell, print::Paper::a4); }

model::EnglishBraille TouchOptions::english() const {
  return braille == "contracted" ? model::EnglishBraille::contracted : model::EnglishBraille::uncontracted;
}

exchange::MadeTouchFile answer_of(const practice::TouchFile& made, const std::string& subject,
                                  const std::string& file) {
  exchange::MadeTouchFile answer{subject,
                                 file,
                                 kind_of(made.kind),
                                 made.width_mm,
                                 made.height_mm,
                                 made.pages,
                                 made.without_number,
                                 made.closest_mm,
                                 {}};
  if (made.kind == practice::TouchKind::mill)
    answer.milling = {made.path.passes, made.path.deepest_mm, made.path.cut_length_mm, made.path.minutes};
  return answer;
}

std::string touch_text(const practice::TouchFile& made, const std::string& subject, const std::string& file) {
  std::string text = fmt::format("{}  {}  {:.4g} x {:.4g} mm", subject, file, made.width_mm, made.height_mm);
  if (made.pages > 1) text += fmt::format(", {} pages", made.pages);
  if (made.kind == practice::TouchKind::mill) {
    text += fmt::format(", {} passes down to {:.2f} mm, {:.1f} m in about {:.0f} min", made.path.passes,
                        made.path.deepest_mm, made.path.cut_length_mm / 1000, std::ceil(made.path.minutes));
  }
  text += '\n' + without_number_text(made.without_number);
  return text + close_lines_text(made);
}

std::string close_lines_text(const practice::TouchFile& made) {
  if (made.closest_mm <= 0 || made.closest_mm >= practice::kSwellGap_mm) return {};
  return fmt::format(
      "lines run {:.1f} mm apart: fingers tell lines apart from {:.1f} mm, so take {:.2f} times the size\n",
      made.closest_mm, practice::kSwellGap_mm, practice::kSwellGap_mm / made.closest_mm);
}

}  // namespace nazori::cli
