// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "characters.h"
#include "json_answers.h"
#include "nazori/base/utf8.h"
#include "nazori/exchange/characters.h"
#include "nazori/practice/confusables.h"
#include "nazori/practice/helpful_words.h"
#include "options.h"
#include "text_layout.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

struct InfoSettings {
  std::vector<std::string> characters;
  std::string database;
  bool json = false;
  std::optional<int> words;
};

constexpr int kLabelWidth = 12;

/// "on          キュウ", continued in lines under the first; nothing without items.
std::string field(std::string_view label, std::span<const std::string> items, std::string_view separator,
                  int width) {
  if (items.empty()) return {};
  return pad(label, kLabelWidth) + flow(items, separator, kLabelWidth, width) + "\n";
}

std::string field(std::string_view label, std::string item) {
  const std::vector<std::string> items{std::move(item)};
  return field(label, items, "", std::numeric_limits<int>::max());
}

std::string grade_text(int grade) {
  if (grade <= 6) return fmt::format("grade {}", grade);
  return grade == 8 ? "secondary school (jōyō)" : "for names (jinmeiyō)";
}

std::string headline(const kanji::Character& character) {
  std::vector<std::string> parts{kanji::code_point_text(character.code_point)};
  const std::size_t drawn = character.strokes.size();
  const auto& counts = character.entry.stroke_counts;
  const std::size_t count = drawn > 0 || counts.empty() ? drawn : static_cast<std::size_t>(counts.front());
  parts.push_back(fmt::format("{} stroke{}", count, count == 1 ? "" : "s"));
  if (drawn == 0) {
    parts.emplace_back("no strokes");
  } else if (!counts.empty() && static_cast<std::size_t>(counts.front()) != drawn) {
    parts.push_back(fmt::format("{} in the dictionary", counts.front()));
  }
  if (character.entry.grade) parts.push_back(grade_text(*character.entry.grade));
  return fmt::format("{}  {}\n", kanji::name_of(character).text(), fmt::join(parts, " · "));
}

std::string radical_text(const kanji::Radical& radical) {
  std::string text = fmt::format("{} {}", radical.number, radical.form);
  if (!radical.variant_forms.empty()) text += fmt::format(" ({})", fmt::join(radical.variant_forms, " "));
  text += fmt::format(" \"{}\"", radical.english_name);
  if (!radical.japanese_names.empty()) text += fmt::format("  {}", fmt::join(radical.japanese_names, "・"));
  return text;
}

/// The components that have a name, of the first level where there are any, each with its place.
void collect_parts(const kanji::Component& component, std::vector<std::string>& parts) {
  for (const kanji::Component& child : component.children) {
    if (child.element.empty()) {
      collect_parts(child, parts);
      continue;
    }
    std::string text = child.element;
    if (!child.original.empty() && child.original != child.element) text += "=" + child.original;
    if (!child.position.empty()) text += " " + child.position;
    if (child.part) text += fmt::format(" (piece {})", *child.part);
    parts.push_back(std::move(text));
  }
}

std::string strokes_text(const kanji::Character& character, int width) {
  std::vector<std::string> items;
  for (const kanji::Stroke& stroke : character.strokes) {
    items.push_back(fmt::format("{} {}{}{}", items.size() + 1, stroke.type, stroke.type.empty() ? "" : " ",
                                exchange::name_of(stroke.line.ending)));
  }
  return field("strokes", items, "   ", width);
}

/// Glosses with separators: commas within a sense, semicolons between senses.
std::vector<std::string> punctuated(const kanji::Word& word) {
  std::vector<std::string> glosses = word.glosses;
  for (std::size_t i = 0; i + 1 < glosses.size(); ++i) {
    const bool same_sense = i + 1 < word.senses.size() && word.senses[i] == word.senses[i + 1];
    glosses[i] += same_sense ? "," : ";";
  }
  return glosses;
}

std::string words_text(std::span<const kanji::Word> words, int width) {
  int text_width = 0;
  int reading_width = 0;
  for (const kanji::Word& word : words) {
    text_width = std::max(text_width, display_width(word.text));
    reading_width = std::max(reading_width, display_width(word.reading));
  }
  std::string text;
  for (const kanji::Word& word : words) {
    std::string line = pad(text.empty() ? "words" : "", kLabelWidth) + pad(word.text, text_width + 2) +
                       pad(word.reading, reading_width + 2);
    const int indent = display_width(line);
    text += line + flow(punctuated(word), " ", indent, width) + "\n";
  }
  return text;
}

/// A word as learners read it: its glosses without the marks of the editors.
kanji::Word plain(const practice::HelpfulWord& helpful) {
  kanji::Word word = helpful.word;
  word.glosses = helpful.meanings;
  word.senses.assign(word.glosses.size(), 0);
  for (std::size_t i = 0; i < word.senses.size(); ++i) word.senses[i] = static_cast<int>(i) + 1;
  return word;
}

/// "ニン 三人": a word for each reading.
std::string uses_text(const std::vector<practice::ReadingUse>& uses, int width) {
  std::vector<std::string> items;
  items.reserve(uses.size());
  for (const auto& use : uses) items.push_back(with_middle_dot(use.reading) + " " + use.word.word.text);
  return field("in words", items, "   ", width);
}

std::string confusables_text(const kanji::KanjiDatabase& database, char32_t character, int width) {
  std::vector<std::string> items;
  for (const char32_t other : practice::confusables_of(database, character)) {
    const auto summary = database.summary(other);
    const std::string meaning = summary ? summary->meaning : std::string();
    items.push_back(base::encode_utf8(other) + (meaning.empty() ? "" : " " + meaning));
  }
  return field("looks like", items, "   ", width);
}

std::vector<std::string> meanings_in(const kanji::DictionaryEntry& entry, std::string_view language) {
  std::vector<std::string> texts;
  for (const kanji::Meaning& meaning : entry.meanings) {
    if (meaning.language == language) texts.push_back(meaning.text);
  }
  return texts;
}

std::string describe(const kanji::Character& character, const std::optional<kanji::Radical>& radical,
                     const std::string& other_words, std::span<const kanji::Word> words, int width) {
  const kanji::DictionaryEntry& entry = character.entry;
  std::string text = headline(character);
  text += field("meanings", meanings_in(entry, "en"), ", ", width);
  text += field("on", entry.on_readings, "  ", width);
  std::vector<std::string> kun;
  for (const std::string& reading : entry.kun_readings) kun.push_back(with_middle_dot(reading));
  text += field("kun", kun, "  ", width);
  text += field("in names", entry.nanori, "  ", width);
  if (radical) text += field("radical", radical_text(*radical));
  std::vector<std::string> parts;
  collect_parts(character.components, parts);
  text += field("parts", parts, "   ", width);
  text += strokes_text(character, width);
  for (const kanji::AlternativeOrder& other : character.alternative_orders) {
    text += field("other order", fmt::format("{}  ({})", fmt::join(other.order, " "), other.source));
  }
  if (character.own_form)
    text += field("form", fmt::format("your own, {}, instead of the published one",
                                      kanji::code_point_text(*character.own_form)));
  text += field("variants", character.variants, "  ", width);
  if (entry.frequency) text += field("frequency", fmt::format("{} in newspapers", *entry.frequency));
  if (entry.old_jlpt_level) text += field("old JLPT", fmt::format("level {}", *entry.old_jlpt_level));
  text += other_words + words_text(words, width);
  return text;
}

int run(Console& console, const InfoSettings& settings) {
  const auto names = kanji::parse_characters(settings.characters);
  if (!names) return console.refuse(names.error());
  const auto database = open_database(settings.database);
  if (!database) return console.refuse(database.error());
  const FoundCharacters characters = find_characters(*database, *names);

  Json document = Json::array();
  bool first = true;
  for (const kanji::Character& character : characters.found) {
    const auto radical = character.entry.radical ? database->radical(*character.entry.radical) : std::nullopt;
    std::vector<kanji::Word> words;
    std::string other_words;
    if (settings.json || settings.words) {
      const int most = settings.words.value_or(std::numeric_limits<int>::max());
      if (most > 0) words = database->words(character.code_point, most);
    } else {
      const auto helpful = practice::words_that_help(*database, character);
      for (const auto& word : practice::choose_words(helpful.words, character.code_point, {}))
        words.push_back(plain(word));
      other_words = confusables_text(*database, character.code_point, text_width()) +
                    uses_text(helpful.uses, text_width());
    }
    if (settings.json) {
      document.push_back(exchange::to_json(character, radical, words));
    } else {
      console.print((first ? "" : "\n") + describe(character, radical, other_words, words, text_width()));
    }
    first = false;
  }
  if (settings.json) console.print(to_text(document));
  if (database->trouble()) return console.refuse(*database->trouble());
  return characters.missing.empty() ? kDone : console.deny(not_found(characters.missing));
}

}  // namespace

void add_info(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<InfoSettings>();
  CLI::App* verb = app.add_subcommand("info", "Show readings, meanings, strokes and words of characters");
  verb->add_option("characters", settings->characters,
                   "Characters, such as 休, 休日, 正-HzFst (a variant form) or U+4F11")
      ->required();
  verb->add_flag("--json", settings->json, "Print JSON with all data (see docs/command-line.md)");
  verb->add_option("--words", settings->words,
                   "Maximum number of words, common ones first (default: six that help; with --json: all)")
      ->check(within(0, 100'000))
      ->type_name("N");
  add_database_option(*verb, settings->database);
  verb->footer("Examples:\n  nazori-cli info 休\n  nazori-cli info 休 木 --json --words 5");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
