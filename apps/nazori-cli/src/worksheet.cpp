// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/worksheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "characters.h"
#include "json_answers.h"
#include "named.h"
#include "nazori/author/collection.h"
#include "nazori/base/file.h"
#include "nazori/base/utf8.h"
#include "nazori/exchange/tablets.h"
#include "nazori/practice/worksheet_choice.h"
#include "options.h"
#include "output_files.h"
#include "study_session.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

constexpr std::size_t kMostTextBytes = 4U << 20U;

struct WorksheetSettings {
  std::vector<std::string> characters;
  std::vector<int> grades;
  std::string list;
  bool due = false;
  bool hardest = false;
  std::string text;
  std::string output;
  std::string layout = "practice";
  std::string paper = "a4";
  std::string guide = "十";
  std::string language = "en";
  std::string title;
  bool no_steps = false;
  bool no_numbers = false;
  bool no_arrows = false;
  bool no_facts = false;
  bool no_name_line = false;
  print::SheetSettings sheet;
  StudyOptions study;
};

kanji::List grade_list(int grade) {
  return static_cast<kanji::List>(static_cast<int>(kanji::List::grade_1) + grade - 1);
}

/// Reads the text of --text. It is printed as it is for manuscript paper.
base::Result<std::string> unicode_text(const std::string& file) {
  const auto bytes = base::read_file(file, kMostTextBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  std::string text(bytes->begin(), bytes->end());
  if (!base::decode_utf8(text))
    return base::fail(base::Errc::parse, "is not UTF-8 text", file, "save it as UTF-8");
  return text;
}

/// What is chosen by the learner's study: a list, what is due today, what was forgotten most.
base::Result<std::vector<char32_t>> from_study(const WorksheetSettings& s) {
  auto session = StudySession::open(s.study, study::Access::read);
  if (!session) return tl::unexpected(std::move(session.error()));
  std::vector<char32_t> all;
  if (!s.list.empty()) {
    auto members = session->lists().members(s.list, session->learner());
    if (!members) return members;
    all = *std::move(members);
  }
  if (s.due || s.hardest) {
    const auto plan = session->plan();
    if (!plan) return tl::unexpected(plan.error());
    if (s.due) {
      for (const study::StudyTask& task : plan->now) all.push_back(task.character);
    }
    if (s.hardest) all.insert(all.end(), plan->leeches.begin(), plan->leeches.end());
  }
  return all;
}

/// Every character once, in the order in which they were chosen.
base::Result<std::vector<CharacterName>> names_of(const WorksheetSettings& s, const std::string& text,
                                                  const kanji::KanjiDatabase& database) {
  std::vector<CharacterName> names;
  std::set<std::string> seen;
  const auto add = [&](CharacterName name) {
    if (seen.insert(name.text()).second) names.push_back(std::move(name));
  };
  if (!s.characters.empty()) {
    auto typed = kanji::parse_characters(s.characters);
    if (!typed) return typed;
    for (CharacterName& name : *typed) add(std::move(name));
  }
  for (const int grade : s.grades) {
    for (const kanji::Summary& one : database.list(grade_list(grade))) add({one.code_point, {}});
  }
  if (!s.list.empty() || s.due || s.hardest) {
    const auto chosen = from_study(s);
    if (!chosen) return tl::unexpected(chosen.error());
    for (const char32_t one : *chosen) add({one, {}});
  }
  if (s.sheet.layout != print::Layout::manuscript) {
    for (const char32_t one :
         practice::characters_of_text(text, [&](char32_t c) { return database.draws(c); }))
      add({one, {}});
  }
  return names;
}

void complete(WorksheetSettings& s) {
  s.sheet.layout = named(print::kLayoutNames, s.layout, print::Layout::practice);
  s.sheet.paper = named(print::kPaperNames, s.paper, print::Paper::a4);
  s.sheet.guide = named(print::kGuideNames, s.guide, print::Guide::cross);
  s.sheet.language = s.language == "ja" ? print::Language::japanese : print::Language::english;
  s.sheet.title = s.title;
  s.sheet.steps = !s.no_steps;
  s.sheet.numbers = !s.no_numbers;
  s.sheet.arrows = !s.no_arrows;
  s.sheet.facts = !s.no_facts;
  s.sheet.name_line = !s.no_name_line;
}

int run(Console& console, WorksheetSettings s) {
  complete(s);
  const auto place = output_file({"--output", s.output, {".pdf"}});
  if (!place) return console.refuse(place.error());
  const NamedFile files[] = {{"--text", s.text, NamedFile::Use::read}, {"--output", place->name()}};
  if (auto fine = check_distinct(files, s.study.json); !fine) return console.refuse(fine.error());
  std::string text;
  if (!s.text.empty()) {
    auto read = unicode_text(s.text);
    if (!read) return console.refuse(read.error());
    text = *std::move(read);
  }
  s.sheet.text = text;
  const auto database = open_database(s.study.database);
  if (!database) return console.refuse(database.error());
  const auto names = names_of(s, text, *database);
  if (!names) return console.refuse(names.error());
  if (names->empty() && s.sheet.layout != print::Layout::manuscript) {
    return console.refuse({base::Errc::bad_argument, "there is no character to print", "",
                           "name some, or give --grade, --list, --due or --text"});
  }
  const practice::SheetCharacters found =
      practice::sheet_characters(*database, *names, s.sheet, author::Collection::usual_folder());
  if (database->trouble()) return console.refuse(*database->trouble());
  if (!found.missing.empty()) return console.deny(not_found(found.missing));
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  const auto pdf = print::worksheet_pdf(found.found, s.sheet, progress.callback());
  progress.clear();
  if (!pdf) return console.refuse(pdf.error());
  if (auto saved = base::write_file(place->path(), *pdf); !saved) return console.refuse(saved.error());
  if (auto sent = place->deliver(console); !sent) return console.refuse(sent.error());
  if (place->is_console()) return kDone;
  const exchange::PrintedSheet sheet{place->name(), s.layout, found.found.size(), pdf->size()};
  console.print(s.study.json
                    ? to_text(exchange::to_json(sheet))
                    : fmt::format("{}  {}, {} bytes\n", sheet.file,
                                  counted(static_cast<std::int64_t>(sheet.character_count), "character"),
                                  sheet.bytes));
  return kDone;
}

}  // namespace

void add_worksheet(CLI::App& app, Action& chosen) {
  auto s = std::make_shared<WorksheetSettings>();
  CLI::App* verb = app.add_subcommand(
      "worksheet", "Print worksheets, flash cards, manuscript paper and sheets for the brush (PDF)");
  verb->add_option("characters", s->characters,
                   "Characters, such as 休, 休日, 正-HzFst (a variant form) or U+4F11");
  verb->add_option("-o,--output", s->output, "Output .pdf; - is standard output")
      ->required()
      ->type_name("FILE");
  verb->add_flag("--json", s->study.json, "Print JSON (see docs/command-line.md)");
  const std::string which = "Which characters";
  verb->add_option("--grade", s->grades, "Every kanji of a school grade; may be repeated")
      ->check(within(1, 6))
      ->type_name("N")
      ->group(which);
  verb->add_option(
          "--text", s->text,
          "Every kanji of a text file (UTF-8), or its kana if it has none; for manuscript paper, the text "
          "itself")
      ->type_name("FILE")
      ->group(which);
  verb->add_option("--list", s->list,
                   "A list of study: secondary, hiragana, list:NAME, tag:NAME (see: study lists)")
      ->type_name("LIST")
      ->group(which);
  verb->add_flag("--due", s->due, "What the learner reviews today")->group(which);
  verb->add_flag("--hardest", s->hardest, "The learner's difficult characters")->group(which);
  const std::string how = "Layout";
  verb->add_option("--layout", s->layout,
                   "practice (model, order, cells), quiz (words to write), cards (flash cards, two sides), "
                   "manuscript (genkouyoushi) or brush (large characters for the brush)")
      ->check(CLI::IsMember({"practice", "quiz", "cards", "manuscript", "brush"}))
      ->capture_default_str()
      ->type_name("LAYOUT")
      ->group(how);
  verb->add_option("--paper", s->paper, "a4, b5, letter or hanshi (243 x 334 mm)")
      ->check(CLI::IsMember({"a4", "b5", "letter", "hanshi"}))
      ->capture_default_str()
      ->type_name("PAPER")
      ->group(how);
  verb->add_option("--cell-mm", s->sheet.cell_mm, "Side of the cells")
      ->check(within(print::kSmallestCell_mm, print::kLargestCell_mm))
      ->capture_default_str()
      ->type_name("MM")
      ->group(how);
  verb->add_option("--guide", s->guide, "Lines in the cells: 十, 田, 米 or none")
      ->check(CLI::IsMember({"十", "田", "米", "none"}))
      ->capture_default_str()
      ->type_name("GUIDE")
      ->group(how);
  verb->add_option("--rows", s->sheet.rows,
                   "Rows of cells for each character; for the brush, sheets of the same characters")
      ->check(within(0, print::kMostRows))
      ->capture_default_str()
      ->type_name("N")
      ->group(how);
  verb->add_option("--copies", s->sheet.copies,
                   "Cells (for the brush, sheets) that show the character, fainter and fainter")
      ->check(within(0, print::kMostRows))
      ->capture_default_str()
      ->type_name("N")
      ->group(how);
  verb->add_option("--per-sheet", s->sheet.per_sheet, "Characters on a sheet for the brush: 1, 2, 4 or 6")
      ->check(CLI::IsMember(print::kPerSheet))
      ->capture_default_str()
      ->type_name("N")
      ->group(how);
  verb->add_flag("--whole-page", s->sheet.whole_page, "One character a page, filled with cells")->group(how);
  verb->add_flag("--vertical", s->sheet.vertical, "From top to bottom, lines from right to left")->group(how);
  verb->add_flag("--no-steps", s->no_steps, "No boxes that show how the character grows")->group(how);
  verb->add_flag("--no-numbers", s->no_numbers, "No stroke numbers")->group(how);
  verb->add_flag("--no-arrows", s->no_arrows, "No arrows on the strokes")->group(how);
  verb->add_flag("--no-facts", s->no_facts, "No readings, meanings and words")->group(how);
  verb->add_flag("--no-name-line", s->no_name_line, "No lines for name, class and date")->group(how);
  verb->add_flag("--answers", s->sheet.answers, "Answers on the back of each page (quiz)")->group(how);
  verb->add_flag("--booklet", s->sheet.booklet, "Two pages a side, in the order of a folded booklet")
      ->group(how);
  verb->add_option("--title", s->title, "Title at the top of the pages")->type_name("TEXT")->group(how);
  verb->add_option("--language", s->language, "Language of Name, Class and Date: en or ja")
      ->check(CLI::IsMember({"en", "ja"}))
      ->capture_default_str()
      ->type_name("en|ja")
      ->group(how);
  const std::string learner = "Learner";
  verb->add_option("--profile", s->study.profile, "The learner of --list, --due and --hardest")
      ->type_name("NAME")
      ->group(learner);
  verb->add_option("--learners", s->study.learners, "Folder of the learners")
      ->type_name("FOLDER")
      ->group(learner);
  verb->add_option("--now", s->study.now, "Time to assume, such as 2026-03-01T09:00Z")
      ->type_name("TIME")
      ->group(learner);
  add_database_option(*verb, s->study.database);
  verb->footer(
      "Examples:\n  nazori-cli worksheet 休 永 --output 休永.pdf\n"
      "  nazori-cli worksheet --grade 1 --vertical --guide 米 --booklet --output grade-1.pdf\n"
      "  nazori-cli worksheet 永 和 --layout brush --paper hanshi --per-sheet 2 --output brush.pdf\n"
      "  nazori-cli worksheet --text story.txt --layout quiz --answers --output quiz.pdf");
  verb->callback([s, &chosen] { chosen = [s](Console& console) { return run(console, *s); }; });
}

}  // namespace nazori::cli
