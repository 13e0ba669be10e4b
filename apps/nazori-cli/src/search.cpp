// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "characters.h"
#include "json_answers.h"
#include "nazori/base/utf8.h"
#include "nazori/exchange/characters.h"
#include "options.h"
#include "text_layout.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

struct SearchSettings {
  std::vector<std::string> words;
  std::string database;
  std::string radical;
  std::optional<int> grade;
  std::optional<int> strokes;
  std::optional<int> limit;
  bool json = false;
};

constexpr int kMost = 100'000;
constexpr int kShownOfWords = 100;

/// A radical by its number or by any of its forms.
base::Result<int> find_radical(const kanji::KanjiDatabase& database, const std::string& text) {
  constexpr int kRadicals = 214;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && number >= 1 && number <= kRadicals)
    return number;
  for (number = 1; number <= kRadicals; ++number) {
    const auto radical = database.radical(number);
    if (!radical) continue;
    const auto& forms = radical->variant_forms;
    if (radical->form == text || std::find(forms.begin(), forms.end(), text) != forms.end()) return number;
  }
  return base::fail(base::Errc::bad_argument, fmt::format("'{}' is not a radical", text), "--radical",
                    "give a number 1..214 or a form such as 亻");
}

std::string table(std::span<const kanji::Summary> found) {
  int reading_width = 0;
  for (const kanji::Summary& one : found) {
    reading_width = std::max(reading_width, display_width(with_middle_dot(one.reading)));
  }
  std::string text;
  for (const kanji::Summary& one : found) {
    std::string line = pad(base::encode_utf8(one.code_point), 4) +
                       fmt::format("{:2} stroke{}  ", one.strokes, one.strokes == 1 ? " " : "s") +
                       pad(one.grade ? fmt::format("grade {}", *one.grade) : "", 10) +
                       pad(with_middle_dot(one.reading), reading_width + 2) + one.meaning;
    while (line.back() == ' ') line.pop_back();
    text += line + "\n";
  }
  return text;
}

int run(Console& console, const SearchSettings& settings) {
  kanji::Query query;
  query.text = fmt::format("{}", fmt::join(settings.words, " "));
  query.grade = settings.grade;
  query.strokes = settings.strokes;
  query.limit = kMost;
  if (!base::decode_utf8(query.text)) {
    return console.refuse({base::Errc::bad_argument, "is not valid UTF-8", "'" + query.text + "'",
                           "search for a character, kana, romaji or English"});
  }
  if (query.text.find_first_not_of(' ') == std::string::npos && !query.grade && !query.strokes &&
      settings.radical.empty()) {
    return console.refuse({base::Errc::bad_argument, "nothing to search for", "",
                           "give a word, or --grade, --strokes or --radical"});
  }
  const auto database = open_database(settings.database);
  if (!database) return console.refuse(database.error());
  if (!settings.radical.empty()) {
    const auto radical = find_radical(*database, settings.radical);
    if (!radical) return console.refuse(radical.error());
    query.radical = *radical;
  }

  std::vector<kanji::Summary> found = database->search(query);
  if (database->trouble()) return console.refuse(*database->trouble());
  const std::size_t all = found.size();
  // For a word the best answers are enough; a grade or a radical is listed completely.
  const bool has_text = query.text.find_first_not_of(' ') != std::string::npos;
  const int shown = settings.limit.value_or(has_text ? kShownOfWords : kMost);
  if (all > static_cast<std::size_t>(shown)) found.resize(static_cast<std::size_t>(shown));
  if (settings.json) {
    Json document = Json::array();
    for (const kanji::Summary& one : found) document.push_back(exchange::to_json(one));
    console.print(to_text(document));
  } else {
    console.print(table(found));
  }
  if (all > found.size() && !settings.limit)
    console.inform(
        fmt::format("{} of {} characters are shown; --limit {} shows all", found.size(), all, all));
  if (!found.empty()) return kDone;
  return console.deny({base::Errc::not_found, "no matching character",
                       query.text.empty() ? "" : "'" + query.text + "'",
                       "search for a character, kana, romaji or English"});
}

}  // namespace

void add_search(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<SearchSettings>();
  CLI::App* verb =
      app.add_subcommand("search", "Find characters by reading, meaning, grade, strokes or radical");
  verb->add_option("query", settings->words, "A character, a reading in kana or romaji, or an English word");
  verb->add_option("--grade", settings->grade,
                   "School grade: 1..6, 8 for secondary school, 9 and 10 for names")
      ->check(within(1, 10))
      ->type_name("N");
  verb->add_option("--strokes", settings->strokes, "Number of strokes")
      ->check(within(1, 100))
      ->type_name("N");
  verb->add_option("--radical", settings->radical,
                   "Classical radical: its number 1..214 or a form such as 亻")
      ->type_name("N|FORM");
  verb->add_option("--limit", settings->limit,
                   "Maximum number of results (default: 100 where a query is given, else all)")
      ->check(within(1, kMost))
      ->type_name("N");
  verb->add_flag("--json", settings->json, "Print JSON (see docs/command-line.md)");
  add_database_option(*verb, settings->database);
  verb->footer(
      "All given conditions must match; the best matches come first.\n\nExamples:\n  nazori-cli search rest\n"
      "  nazori-cli search きゅう --grade 1\n  nazori-cli search --radical 亻 --strokes 6 --json");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
