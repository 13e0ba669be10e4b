// SPDX-License-Identifier: Apache-2.0
#include "database_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "basic_words.h"
#include "learning_order.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/meaning_text.h"
#include "nazori/kanji/romaji.h"
#include "nazori/kanji/schema.h"
#include "nazori/kanji/search_keys.h"
#include "tables.h"

namespace nazori::ingest {
namespace {

using kanji::CharacterKind;
using kanji::KeyFit;
using kanji::ReadingKind;
using kanji::WordRank;

std::int64_t number_of(char32_t c) { return static_cast<std::int64_t>(c); }

SQLite::Database make(const std::filesystem::path& path) {
  SQLite::Database db(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  // The file is discarded when anything fails, and flushed as a whole at the end.
  db.exec(
      "PRAGMA page_size = 4096; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF;"
      "PRAGMA cache_size = -131072;"
      "PRAGMA application_id = " +
      std::to_string(kanji::kSchemaApplicationId) +
      "; PRAGMA user_version = " + std::to_string(kanji::kSchemaVersion) + "; BEGIN");
  db.exec(std::string(kanji::schema_sql()));
  return db;
}

void bind_value(SQLite::Statement& statement, int index, std::int64_t value) { statement.bind(index, value); }
void bind_value(SQLite::Statement& statement, int index, int value) { statement.bind(index, value); }
void bind_value(SQLite::Statement& statement, int index, double value) { statement.bind(index, value); }
void bind_value(SQLite::Statement& statement, int index, const std::string& value) {
  statement.bindNoCopy(index, value);
}
template <class T>
void bind_value(SQLite::Statement& statement, int index, const std::optional<T>& value) {
  if (value) {
    bind_value(statement, index, *value);
  } else {
    statement.bind(index);
  }
}

/// Inserts one row. The values outlive the call, as bindNoCopy requires.
template <class... Values>
void insert(SQLite::Statement& statement, const Values&... values) {
  int index = 0;
  (bind_value(statement, ++index, values), ...);
  statement.exec();
  statement.reset();
}

std::optional<std::string> unless_empty(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

std::string joined(const std::vector<int>& numbers) {
  std::string out;
  for (const int n : numbers) {
    if (!out.empty()) out += ' ';
    out += std::to_string(n);
  }
  return out;
}

using kanji::offer_key;
using Keys = kanji::SearchKeys;

/// Words with which nobody looks for a meaning that goes on with them.
bool is_function_word(std::string_view word) {
  constexpr auto kWords = std::to_array<std::string_view>(
      {"a",  "about", "an", "and", "as",    "at", "be", "by",  "for", "from", "in",
       "is", "it",    "of", "on",  "one's", "or", "s",  "the", "to",  "with"});
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

Keys gloss_keys(const EdictEntry& word) {
  constexpr int kMostWords = 6;
  Keys keys;
  KeyFit fit = KeyFit::whole;
  for (const auto& sense : word.senses) {
    for (const std::string& gloss : sense) {
      std::string phrase = kanji::fold_gloss(gloss);
      offer_key(keys, phrase, fit);
      int words = 1;
      for (std::size_t gap = phrase.find(' '); gap != std::string::npos && words < kMostWords;
           gap = phrase.find(' '), ++words) {
        phrase.erase(0, gap + 1);
        if (!is_function_word(phrase.substr(0, phrase.find(' ')))) offer_key(keys, phrase, KeyFit::name);
      }
      fit = KeyFit::part;
    }
  }
  return keys;
}

}  // namespace

DatabaseWriter::DatabaseWriter(const std::filesystem::path& path)
    : db_(make(path)),
      source_(db_, "INSERT INTO source VALUES(?, ?, ?, ?, ?)"),
      radical_(db_, "INSERT INTO radical VALUES(?, ?, ?, ?)"),
      radical_form_(db_, "INSERT INTO radical_form VALUES(?, ?, ?)"),
      radical_name_(db_, "INSERT INTO radical_name VALUES(?, ?, ?)"),
      form_(db_, "INSERT INTO form VALUES(?, ?, ?)"),
      stroke_(db_, "INSERT INTO stroke VALUES(?, ?, ?, ?, ?, ?, ?)"),
      component_(db_, "INSERT INTO component VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      order_(db_, "INSERT INTO alternative_order VALUES(?, ?, ?, ?)"),
      character_(db_, "INSERT INTO character VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      stroke_count_(db_, "INSERT INTO stroke_count VALUES(?, ?, ?)"),
      reading_(db_, "INSERT INTO reading VALUES(?, ?, ?, ?)"),
      meaning_(db_, "INSERT INTO meaning VALUES(?, ?, ?, ?)"),
      code_(db_, "INSERT INTO code VALUES(?, ?, ?, ?)"),
      word_(db_, "INSERT INTO word VALUES(?, ?, ?, ?, ?, ?)"),
      word_of_(db_, "INSERT INTO word_of VALUES(?, ?)"),
      word_key_(db_, "INSERT INTO word_key VALUES(?, ?)"),
      word_meaning_key_(db_, "INSERT INTO word_meaning_key VALUES(?, ?, ?)"),
      reading_key_(db_, "INSERT INTO reading_key VALUES(?, ?, ?)"),
      meaning_key_(db_, "INSERT INTO meaning_key VALUES(?, ?, ?)"),
      element_of_(db_, "INSERT INTO element_of VALUES(?, ?)") {}

void DatabaseWriter::add_source(const kanji::Source& source) {
  insert(source_, sources_++, source.name, source.version, source.sha256, source.licence);
}

void DatabaseWriter::add_radicals() {
  for (const auto& row : table_rows(radicals_table())) {
    int number = 0;
    std::from_chars(row[0].data(), row[0].data() + row[0].size(), number);
    int strokes = 0;
    std::from_chars(row[3].data(), row[3].data() + row[3].size(), strokes);
    insert(radical_, number, std::string(row[1]), strokes, std::string(row[5]));
    int position = 0;
    for (const std::string_view form : split(row[2], ' ')) {
      if (!form.empty()) insert(radical_form_, number, position++, std::string(form));
    }
    position = 0;
    for (const std::string_view name : split(row[4], ' ')) {
      insert(radical_name_, number, position++, std::string(name));
    }
  }
}

void DatabaseWriter::add_form(const DrawnForm& form) {
  const std::int64_t id = forms_++;
  insert(form_, id, number_of(form.code_point), form.variant);
  int number = 0;
  for (const kanji::Stroke& stroke : form.strokes) {
    std::optional<double> x;
    std::optional<double> y;
    if (const auto& position = stroke.line.number_position) x = position->x, y = position->y;
    insert(stroke_, id, number++, stroke.path, stroke.type, static_cast<int>(stroke.line.ending), x, y);
  }
  int position = 0;
  const auto add_group = [&](const auto& self, const kanji::Component& group, int parent) -> void {
    const int here = position++;
    const int flags = (group.variant ? 1 : 0) | (group.partial ? 2 : 0) | (group.trad_form ? 4 : 0) |
                      (group.radical_form ? 8 : 0);
    insert(component_, id, here, parent, group.first_stroke, static_cast<int>(group.strokes.size()),
           unless_empty(group.element), unless_empty(group.original), unless_empty(group.position),
           unless_empty(group.radical), unless_empty(group.phon), group.part, group.number, flags);
    for (const kanji::Component& child : group.children) self(self, child, here);
  };
  add_group(add_group, form.components, -1);
}

void DatabaseWriter::add_orders(char32_t code_point, std::span<const kanji::AlternativeOrder> orders) {
  int position = 0;
  for (const kanji::AlternativeOrder& order : orders) {
    insert(order_, number_of(code_point), position++, joined(order.order), order.source);
  }
}

void DatabaseWriter::add_entry(char32_t code_point, const kanji::DictionaryEntry& entry) {
  const std::int64_t key = number_of(code_point);
  int position = 0;
  for (const int count : entry.stroke_counts) insert(stroke_count_, key, position++, count);
  position = 0;
  const auto add_readings = [&](const std::vector<std::string>& readings, ReadingKind kind) {
    for (const std::string& text : readings) insert(reading_, key, position++, static_cast<int>(kind), text);
  };
  add_readings(entry.on_readings, ReadingKind::on);
  add_readings(entry.kun_readings, ReadingKind::kun);
  add_readings(entry.nanori, ReadingKind::nanori);
  position = 0;
  for (const auto& [language, text] : entry.meanings) insert(meaning_, key, position++, language, text);
  position = 0;
  for (const auto& [system, value] : entry.codes) insert(code_, key, position++, system, value);
}

void DatabaseWriter::add_character(char32_t code_point, std::int64_t place, const DrawnForm* main,
                                   const kanji::DictionaryEntry* entry) {
  static const kanji::DictionaryEntry nothing;
  const kanji::DictionaryEntry& e = entry == nullptr ? nothing : *entry;
  insert(character_, number_of(code_point), place, static_cast<int>(kind_of(code_point)),
         static_cast<int>(main == nullptr ? 0 : main->strokes.size()),
         e.stroke_counts.empty() ? 0 : e.stroke_counts.front(), e.grade, e.frequency, e.old_jlpt_level,
         e.radical, kanji::first_meaning(e), kanji::first_reading(e));
  if (entry != nullptr) add_entry(code_point, *entry);
  add_keys(code_point, place, main, entry);
}

void DatabaseWriter::add_keys(char32_t code_point, std::int64_t place, const DrawnForm* main,
                              const kanji::DictionaryEntry* entry) {
  Keys readings = entry == nullptr ? Keys() : kanji::reading_keys(*entry);
  const CharacterKind kind = kind_of(code_point);
  if (kind == CharacterKind::hiragana || kind == CharacterKind::katakana) {
    offer_key(readings, kanji::fold_reading(base::encode_utf8(code_point)), KeyFit::whole);
  }
  for (const auto& [key, fit] : readings) insert(reading_key_, key, place, static_cast<int>(fit));
  if (entry != nullptr) {
    for (const auto& [key, fit] : kanji::meaning_keys(*entry))
      insert(meaning_key_, key, place, static_cast<int>(fit));
  }
  if (main != nullptr) {
    for (const std::string& element : kanji::element_keys(code_point, main->components))
      insert(element_of_, element, place);
  }
}

void DatabaseWriter::add_word(const EdictEntry& word) {
  std::string glosses;
  for (const auto& sense : word.senses) {
    if (!glosses.empty()) glosses += '\n';
    for (const std::string& gloss : sense) {
      if (&gloss != &sense.front()) glosses += '/';
      glosses += gloss;
    }
  }
  const std::int64_t id = words_++;
  const WordRank rank = is_basic(word) ? WordRank::basic : word.common ? WordRank::common : WordRank::other;
  insert(word_, id, word.text, unless_empty(word.reading == word.text ? std::string() : word.reading),
         word.parts_of_speech, static_cast<int>(rank), glosses);
  add_word_keys(word, id, rank != WordRank::other);
  const std::u32string text = base::decode_utf8(word.text).value_or(std::u32string());
  const auto is_kana = [](char32_t c) {
    return kind_of(c) == CharacterKind::hiragana || kind_of(c) == CharacterKind::katakana;
  };
  // Kana occur in most words: only common words written in kana alone are good examples.
  const bool shows_kana = word.common && std::all_of(text.begin(), text.end(), is_kana);
  std::set<char32_t> indexed;
  for (const char32_t c : text) {
    if (kind_of(c) == CharacterKind::ideograph || (shows_kana && is_kana(c))) indexed.insert(c);
  }
  for (const char32_t c : indexed) insert(word_of_, number_of(c), id);
}

void DatabaseWriter::add_word_keys(const EdictEntry& word, std::int64_t id, bool is_common) {
  std::set<std::string> keys{kanji::fold_reading(word.reading.empty() ? word.text : word.reading)};
  if (!word.reading.empty()) keys.insert(word.text);
  for (const std::string& key : keys) insert(word_key_, key, id);
  if (!is_common) return;
  for (const auto& [key, fit] : gloss_keys(word)) insert(word_meaning_key_, key, id, static_cast<int>(fit));
}

void DatabaseWriter::finish() { db_.exec("COMMIT"); }

}  // namespace nazori::ingest
