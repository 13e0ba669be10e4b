// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "author.h"
#include "characters.h"
#include "json_answers.h"
#include "nazori/author/check.h"
#include "nazori/base/utf8.h"
#include "options.h"

namespace nazori::cli {
namespace {

using author::Finding;
using author::FindingKind;

struct AuthorCheckSettings {
  std::vector<std::string> files;
  std::optional<int> grid;
  double tip_mm = 1;
  std::string database;
  bool json = false;
};

constexpr double kUnitsPerMm = geometry::kGlyphSide / 100;  // on a tablet of 100 mm

std::string stroke_text(std::optional<std::size_t> stroke) { return std::to_string(stroke.value_or(0) + 1); }

std::string sentence(const Finding& f) {
  const std::string stroke = stroke_text(f.stroke);
  const std::string second = stroke_text(f.second);
  const std::string point = stroke_text(f.point);
  const double mm = f.amount / kUnitsPerMm;
  switch (f.kind) {
    case FindingKind::no_strokes:
      return "there are no strokes";
    case FindingKind::no_name:
      return "the character has no name";
    case FindingKind::number_far:
      return fmt::format("the number of stroke {} is {:.1f} units from its start", stroke, f.amount);
    case FindingKind::numbers_overlap:
      return fmt::format("the numbers of strokes {} and {} cover one another", stroke, second);
    case FindingKind::number_hides_start:
      return fmt::format("the number of stroke {} covers the start of stroke {}", stroke, second);
    case FindingKind::part_empty:
      return fmt::format("the part '{}' has no strokes", f.text);
    case FindingKind::stroke_in_no_part:
      return fmt::format("stroke {} is in no part", stroke);
    case FindingKind::outside:
      return fmt::format("point {} of stroke {} is outside the picture", point, stroke);
    case FindingKind::no_length:
      return fmt::format("stroke {} is only {:.2f} units long", stroke, f.amount);
    case FindingKind::doubled:
      return fmt::format("stroke {} lies on stroke {}", second, stroke);
    case FindingKind::ending_differs:
      return fmt::format("the ending of stroke {} does not agree with its width", stroke);
    case FindingKind::point_off_line:
      return fmt::format("stroke {} turns back at point {}", stroke, point);
    case FindingKind::too_shallow:
      return fmt::format("stroke {} is only {:.2f} of the tablet's depth deep", stroke, f.amount);
    case FindingKind::too_narrow:
      return fmt::format("stroke {} is only {:.1f} mm wide, narrower than the tip", stroke, mm);
    case FindingKind::thin_wall:
      return fmt::format("the wall between strokes {} and {} is {:.1f} mm, thinner than the tip", stroke,
                         second, mm);
    case FindingKind::count_differs:
      return fmt::format("the dictionary counts {:.0f} strokes", f.amount);
    case FindingKind::licence_lost:
      return "the strokes come from KanjiVG, so CC-BY-SA-3.0 and its authors must be named";
    case FindingKind::no_licence:
      return "the licence is not said";
    case FindingKind::svg_view_box:
      return fmt::format("viewBox is '{}', not '0 0 109 109'", f.text);
    case FindingKind::svg_size:
      return fmt::format("width or height is '{}', not 109", f.text);
    case FindingKind::svg_root_id:
      return fmt::format("the group '{}' is not named after the character", f.text);
    case FindingKind::svg_style:
      return fmt::format("the group '{}' has no style", f.text);
    case FindingKind::svg_group_id:
      return fmt::format("the group '{}' is not named after its number", f.text);
    case FindingKind::svg_stroke_id:
      return fmt::format("the path '{}' is not named after its stroke, {}", f.text, stroke);
    case FindingKind::svg_number_count:
      return fmt::format("there are {:.0f} numbers, not one for each stroke", f.amount);
    case FindingKind::svg_number_order:
      return fmt::format("the number '{}' is not in order", f.text);
  }
  return {};
}

Json index_or_null(std::optional<std::size_t> index) { return index ? Json(*index + 1) : Json(); }

Json to_json(const std::string& file, const author::OwnCharacter& character,
             const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& f : findings) {
    Json one;
    one["kind"] = author::name_of(f.kind);
    one["severity"] = author::name_of(f.severity);
    one["stroke"] = index_or_null(f.stroke);
    one["point"] = index_or_null(f.point);
    one["second"] = index_or_null(f.second);
    one["at"] = f.at ? Json::array({f.at->x, f.at->y}) : Json();
    one["amount"] = f.amount;
    one["text"] = f.text;
    one["message"] = sentence(f);
    list.push_back(std::move(one));
  }
  Json answer;
  answer["version"] = 1;
  answer["file"] = file;
  answer["name"] = character.facts.name;
  answer["strokes"] = character.strokes.size();
  answer["findings"] = std::move(list);
  return answer;
}

/// The dictionary's entry for a character, where there is a dictionary and it has one.
std::optional<kanji::DictionaryEntry> entry_of(const std::optional<kanji::KanjiDatabase>& database,
                                               const author::OwnCharacter& character) {
  const auto letters = base::decode_utf8(character.facts.name);
  if (!database || !letters || letters->size() != 1) return std::nullopt;
  const auto found = database->find((*letters)[0]);
  return found ? std::optional(found->entry) : std::nullopt;
}

int run(Console& console, const AuthorCheckSettings& s) {
  std::optional<kanji::KanjiDatabase> database;
  auto opened = open_database(s.database);
  // Without a dictionary everything but the count of strokes can be checked.
  if (opened)
    database = *std::move(opened);
  else if (!s.database.empty() || opened.error().code != base::Errc::not_found)
    return console.refuse(opened.error());
  Json answers = Json::array();
  std::string text;
  bool is_fine = true;
  for (const std::string& file : s.files) {
    const auto read = read_author_file(file, s.grid);
    if (!read) return console.refuse(read.error());
    const auto entry = entry_of(database, read->character);
    std::vector<Finding> findings = author::check(
        read->character, {.tip = s.tip_mm * kUnitsPerMm, .dictionary = entry ? &*entry : nullptr});
    const std::vector<Finding> of_svg = author::check_svg(read->svg);
    findings.insert(findings.end(), of_svg.begin(), of_svg.end());
    is_fine = is_fine && std::ranges::all_of(
                             findings, [](const Finding& f) { return f.severity == author::Severity::note; });
    answers.push_back(to_json(file, read->character, findings));
    text += fmt::format("{}  {} stroke{}: {}\n", file, read->character.strokes.size(),
                        read->character.strokes.size() == 1 ? "" : "s",
                        findings.empty()
                            ? std::string("no findings")
                            : fmt::format("{} finding{}", findings.size(), findings.size() == 1 ? "" : "s"));
    for (const Finding& f : findings)
      text += fmt::format("  {:<8}{}\n", author::name_of(f.severity), sentence(f));
  }
  console.print(s.json ? to_text(answers) : text);
  return is_fine ? kDone : kNo;
}

}  // namespace

void add_author_check(CLI::App& author, Action& chosen) {
  auto s = std::make_shared<AuthorCheckSettings>();
  CLI::App* verb =
      author.add_subcommand("check", "Look characters over: strokes, numbers, grooves and licence");
  verb->add_option("files", s->files, "Files .nazori, .svg, .str, .raw or .png")
      ->required()
      ->type_name("FILE");
  verb->add_option("--grid", s->grid, "Side of the grid of a .str or of a RAW (default: a guess)")
      ->type_name("N")
      ->check(within(2, 8192));
  verb->add_option("--tip-mm", s->tip_mm, "Diameter of the stylus' tip on a tablet of 100 mm")
      ->type_name("MM")
      ->capture_default_str()
      ->check(within(0.1, 10));
  verb->add_flag("--json", s->json, "Print JSON (see docs/command-line.md)");
  add_database_option(*verb, s->database);
  verb->footer(
      "Exit code 1 where there is a warning or an error; notes do not count.\n\n"
      "Examples:\n  nazori-cli author check 永.nazori\n  nazori-cli author check 06c38.svg --json");
  verb->callback([s, &chosen] { chosen = [s](Console& console) { return run(console, *s); }; });
}

}  // namespace nazori::cli
