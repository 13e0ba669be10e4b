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
#include "nazori/kanji/gloss.h"
#include "nazori/kanji/query_text.h"
#include "options.h"
#include "text_layout.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

struct SearchSettings {
  std::vector<std::string> words;
  std::string database;
  std::string radical;
  std::string parts;
  std::string skip;
  std::string four_corner;
  std::optional<int> jlpt;
  std::optional<int> frequency;
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
  if (const auto found = database.radical_of_form(text)) return *found;
  return base::fail(base::Errc::bad_argument, fmt::format("'{}' is not a radical", text), "--radical",
                    "give a number 1..214 or a form such as 亻");
}

constexpr int kMostWords = 6;

/// Why a character was found, where the line does not say it: its reading or meaning is another one.
std::string reason_text(const kanji::Match& match) {
  if (match.text.empty() || match.text == match.summary.reading || match.text == match.summary.meaning)
    return {};
  if (match.reason == kanji::Reason::meaning) return fmt::format("  ({})", match.text);
  return fmt::format("  ({}{})", with_middle_dot(match.text),
                     match.reason == kanji::Reason::name ? ", in names" : "");
}

std::string word_table(std::span<const kanji::WordMatch> words) {
  int text_width = 0;
  int reading_width = 0;
  for (const auto& match : words) {
    text_width = std::max(text_width, display_width(match.word.text));
    reading_width = std::max(reading_width, display_width(match.word.reading));
  }
  std::string text;
  for (const auto& match : words) {
    text += pad(match.word.text, text_width + 2) + pad(match.word.reading, reading_width + 2) +
            fmt::format("{}\n", fmt::join(kanji::plain_glosses(match.word, 3), "; "));
  }
  return text;
}

std::string table(std::span<const kanji::Match> found) {
  int reading_width = 0;
  for (const kanji::Match& match : found) {
    reading_width = std::max(reading_width, display_width(with_middle_dot(match.summary.reading)));
  }
  std::string text;
  for (const kanji::Match& match : found) {
    const kanji::Summary& one = match.summary;
    std::string line = pad(letter(one.code_point), 4) +
                       fmt::format("{:2} stroke{}  ", one.strokes, one.strokes == 1 ? " " : "s") +
                       pad(one.grade ? fmt::format("grade {}", *one.grade) : "", 10) +
                       pad(with_middle_dot(one.reading), reading_width + 2) + one.meaning +
                       reason_text(match);
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
  query.old_jlpt_level = settings.jlpt;
  query.frequency = settings.frequency;
  query.skip = settings.skip;
  query.four_corner = settings.four_corner;
  for (const char32_t part : base::decode_utf8(settings.parts).value_or(std::u32string()))
    query.parts.push_back(base::encode_utf8(part));
  if (!base::decode_utf8(query.text)) {
    return console.refuse({base::Errc::bad_argument, "is not valid UTF-8", "'" + query.text + "'",
                           "search for a character, kana, romaji or English"});
  }
  kanji::Query nothing;
  nothing.limit = query.limit;
  nothing.text = query.text;
  if (query.text.find_first_not_of(' ') == std::string::npos && query == nothing &&
      settings.radical.empty()) {
    return console.refuse({base::Errc::bad_argument, "nothing to search for", "",
                           "give a word, or a condition such as --strokes"});
  }
  const auto database = open_database(settings.database);
  if (!database) return console.refuse(database.error());
  if (!settings.radical.empty()) {
    const auto radical = find_radical(*database, settings.radical);
    if (!radical) return console.refuse(radical.error());
    query.radical = *radical;
  }

  std::vector<kanji::Match> found = database->matches(query);
  if (database->trouble()) return console.refuse(*database->trouble());
  const std::size_t all = found.size();
  // For a word the best answers are enough; a grade or a radical is listed completely.
  const bool has_text = query.text.find_first_not_of(' ') != std::string::npos;
  const int shown = settings.limit.value_or(has_text ? kShownOfWords : kMost);
  if (all > static_cast<std::size_t>(shown)) found.resize(static_cast<std::size_t>(shown));
  const bool is_text_alone = query == nothing && !settings.json;
  const auto words =
      is_text_alone ? database->search_words(query.text, kMostWords) : std::vector<kanji::WordMatch>();
  if (settings.json) {
    Json document = Json::array();
    for (const kanji::Match& one : found) document.push_back(exchange::to_json(one.summary));
    console.print(to_text(document));
  } else {
    console.print(table(found));
    if (!words.empty()) console.print((found.empty() ? "" : "\n") + word_table(words));
  }
  if (all > found.size() && !settings.limit)
    console.inform(
        fmt::format("{} of {} characters are shown; --limit {} shows all", found.size(), all, all));
  if (!found.empty() || !words.empty()) return kDone;
  return console.deny({base::Errc::not_found, "no matching character",
                       query.text.empty() ? "" : "'" + query.text + "'",
                       "search for a character, kana, romaji or English"});
}

}  // namespace

void add_search(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<SearchSettings>();
  CLI::App* verb = app.add_subcommand("search", "Find characters by reading, meaning, word, parts or code");
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
  verb->add_option("--parts", settings->parts, "Parts that the character has, such as 木亻")
      ->type_name("PARTS");
  verb->add_option("--skip", settings->skip, "Code of the SKIP system or its beginning, such as 1-2-4 or 1-2")
      ->check([](const std::string& text) {
        return kanji::is_skip(text) ? std::string()
                                    : "'" + text + "' is no SKIP code: give one such as 1-2-4";
      })
      ->type_name("CODE");
  verb->add_option("--four-corner", settings->four_corner,
                   "Four-corner code or its beginning, such as 2429.0 or 2429")
      ->check([](const std::string& text) {
        return kanji::is_four_corner(text) ? std::string()
                                           : "'" + text + "' is no four-corner code: give one such as 2429.0";
      })
      ->type_name("CODE");
  verb->add_option("--jlpt", settings->jlpt, "JLPT level of before 2010: 4 (easiest) to 1")
      ->check(within(1, 4))
      ->type_name("N");
  verb->add_option("--frequency", settings->frequency, "One of the N most frequent in newspapers")
      ->check(within(1, kMost))
      ->type_name("N");
  verb->add_option("--limit", settings->limit,
                   "Maximum number of results (default: 100 where a query is given, else all)")
      ->check(within(1, kMost))
      ->type_name("N");
  verb->add_flag("--json", settings->json, "Print JSON (see docs/command-line.md)");
  add_database_option(*verb, settings->database);
  verb->footer(
      "All given conditions must match; the best matches come first.\n\nExamples:\n  nazori-cli search rest\n"
      "  nazori-cli search きゅうじつ\n  nazori-cli search きゅう --grade 1\n  nazori-cli search --parts "
      "木亻\n"
      "  nazori-cli search --radical 亻 --strokes 6 --json");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
