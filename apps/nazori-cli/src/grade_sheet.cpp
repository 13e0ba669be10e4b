// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "characters.h"
#include "json_answers.h"
#include "nazori/exchange/sheets.h"
#include "nazori/scan/marked_picture.h"
#include "nazori/scan/sheet_reader.h"
#include "options.h"
#include "output_files.h"
#include "study_session.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

struct GradeSheetSettings {
  std::vector<std::string> photos;
  std::string output;
  std::string database;
  bool json = false;
};

std::string line_of(std::size_t number, const scan::CellReading& cell) {
  std::string line = fmt::format("{:>5}  {}  ", number, letter(cell.box.character));
  if (cell.state == scan::CellState::illegible) {
    line += "not legible as this character";
    if (cell.looks_like) line += fmt::format(", looks like {}", letter(*cell.looks_like));
    return line + "\n";
  }
  line += "legible";
  for (std::size_t i = 0; i < cell.remarks.size(); ++i)
    line += (i == 0 ? ": " : ", ") + scan::explain(cell.remarks[i]);
  return line + "\n";
}

std::string text_of(const std::string& photo, const scan::SheetReading& sheet) {
  std::array<std::int64_t, scan::kCellStates.size()> count{};
  for (const scan::CellReading& cell : sheet.cells) ++count[static_cast<std::size_t>(cell.state)];
  const auto of = [&](scan::CellState state) { return count[static_cast<std::size_t>(state)]; };
  std::string text =
      fmt::format("{}  {}, page {}: {}, {} legible, {} not legible, {} empty", photo,
                  sheet.mark.layout == print::Layout::quiz ? "quiz" : "practice sheet", sheet.mark.page,
                  counted(static_cast<std::int64_t>(sheet.cells.size()) - of(scan::CellState::traced),
                          "cell to write in", "cells to write in"),
                  of(scan::CellState::legible), of(scan::CellState::illegible), of(scan::CellState::empty));
  if (of(scan::CellState::traced) > 0)
    text += fmt::format(", {} to trace (not judged)", of(scan::CellState::traced));
  text += '\n';
  for (std::size_t i = 0; i < sheet.cells.size(); ++i) {
    const scan::CellState state = sheet.cells[i].state;
    if (state == scan::CellState::legible || state == scan::CellState::illegible)
      text += line_of(i + 1, sheet.cells[i]);
  }
  return text;
}

int run(Console& console, const GradeSheetSettings& s) {
  std::optional<OutputPlace> place;
  if (!s.output.empty()) {
    if (s.photos.size() > 1)
      return console.refuse(
          {base::Errc::bad_argument, "is for one photograph", "--output", "give the photographs one by one"});
    auto named = output_file({"--output", s.output, {".png"}});
    if (!named) return console.refuse(named.error());
    place = *std::move(named);
  }
  const NamedFile files[] = {{"photos", s.photos.front(), NamedFile::Use::read},
                             {"--output", place ? place->name() : std::string()}};
  if (auto fine = check_distinct(files, s.json); !fine) return console.refuse(fine.error());
  const auto database = open_database(s.database);
  if (!database) return console.refuse(database.error());
  auto reader = scan::SheetReader::make(*database);
  if (!reader) return console.refuse(reader.error());
  Json answers = Json::array();
  std::string text;
  for (const std::string& name : s.photos) {
    const auto photo = scan::load_photo(name);
    if (!photo) return console.refuse(photo.error());
    auto sheets = reader->read(*photo);
    if (!sheets) {
      base::Error error = std::move(sheets.error());
      if (error.where.empty()) error.where = name;
      return console.refuse(error);
    }
    answers.push_back(exchange::to_json(name, *sheets));
    for (const scan::SheetReading& sheet : *sheets) text += text_of(name, sheet);
    if (!place) continue;
    const auto picture = scan::marked_picture(*photo, *sheets);
    if (auto saved = surface::save_png(picture, place->path()); !saved) return console.refuse(saved.error());
    if (auto sent = place->deliver(console); !sent) return console.refuse(sent.error());
    if (place->is_console()) return kDone;
  }
  text += "Stroke order and direction cannot be seen in a photograph.\n";
  console.print(s.json ? to_text(answers) : text);
  return kDone;
}

}  // namespace

void add_grade_sheet(CLI::App& app, Action& chosen) {
  auto s = std::make_shared<GradeSheetSettings>();
  CLI::App* verb =
      app.add_subcommand("grade-sheet", "Read printed worksheets back from photographs or scans");
  verb->add_option("photos", s->photos, "PNG or JPEG pictures of practice sheets and quizzes of Nazori")
      ->required()
      ->type_name("FILE");
  verb->add_option("-o,--output", s->output,
                   "Output .png: the photograph with what was found in each cell; - is standard output")
      ->type_name("FILE");
  verb->add_flag("--json", s->json, "Print JSON (see docs/command-line.md)");
  add_database_option(*verb, s->database);
  verb->footer(
      "Shape and place of each character are judged; order and direction of strokes cannot be\n"
      "seen. Cells that show the character in grey are not judged.\n\n"
      "Examples:\n  nazori-cli grade-sheet photo.jpg --output marked.png\n"
      "  nazori-cli grade-sheet scan-1.png scan-2.png --json");
  verb->callback([s, &chosen] { chosen = [s](Console& console) { return run(console, *s); }; });
}

}  // namespace nazori::cli
