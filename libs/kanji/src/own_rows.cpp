// SPDX-License-Identifier: Apache-2.0
#include "own_rows.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "nazori/kanji/schema.h"
#include "nazori/kanji/search_keys.h"

namespace nazori::kanji {
namespace {

/// A statement that adds one row after another.
class RowWriter {
 public:
  RowWriter(SQLite::Database& db, const char* sql) : statement_(db, sql) {}
  template <class... Values>
  void add(const Values&... values) {
    int index = 0;
    (statement_.bind(++index, values), ...);
    statement_.exec();
    statement_.reset();
  }

 private:
  SQLite::Statement statement_;
};

void make_views(SQLite::Database& db) {
  // In memory: the program may not be able to write anywhere.
  db.exec("PRAGMA temp_store = MEMORY");
  constexpr std::array<std::string_view, 6> kTables{"character",   "reading",     "meaning",
                                                    "reading_key", "meaning_key", "element_of"};
  for (const std::string_view table : kTables) {
    // A temporary view is found before a table of the file that has the same name.
    db.exec(fmt::format("CREATE TEMP TABLE own_{0} AS SELECT * FROM main.{0} WHERE false", table));
    // A form that takes the place of a published character brings that one's row with it.
    const std::string_view others =
        table == "character" ? " WHERE code_point NOT IN (SELECT code_point FROM own_character)" : "";
    db.exec(fmt::format("CREATE TEMP VIEW {0} AS SELECT * FROM main.{0}{1} UNION ALL SELECT * FROM own_{0}",
                        table, others));
  }
}

}  // namespace

OwnForms sorted_forms(SQLite::Database& db, std::vector<Character> own) {
  OwnForms forms;
  SQLite::Statement known(db, "SELECT 1 FROM main.character WHERE code_point = ?");
  for (Character& one : own) {
    if (one.own_form) {
      known.bind(1, static_cast<std::int64_t>(one.code_point));
      const bool is_published = known.executeStep();
      known.reset();
      if (is_published) {
        const char32_t place = one.code_point;
        forms.replaced.emplace(place, std::move(one));
        continue;
      }
      one.code_point = *one.own_form;
      one.own_form.reset();
    }
    forms.beside.push_back(std::move(one));
  }
  return forms;
}

void add_own_rows(SQLite::Database& db, const OwnForms& own) {
  std::int64_t place = db.execAndGet("SELECT count(*) FROM main.character").getInt64();
  make_views(db);
  RowWriter characters(db, "INSERT INTO own_character VALUES(?, ?, ?, ?, ?, NULL, NULL, NULL, ?, ?, ?)");
  RowWriter readings(db, "INSERT INTO own_reading VALUES(?, ?, ?, ?)");
  RowWriter meanings(db, "INSERT INTO own_meaning VALUES(?, ?, ?, ?)");
  RowWriter found_readings(db, "INSERT INTO own_reading_key VALUES(?, ?, ?)");
  RowWriter found_meanings(db, "INSERT INTO own_meaning_key VALUES(?, ?, ?)");
  RowWriter elements(db, "INSERT INTO own_element_of VALUES(?, ?)");
  RowWriter replaced(
      db,
      "INSERT INTO own_character SELECT code_point, place, kind, ?, counted, grade, frequency, "
      "old_jlpt, radical, meaning, reading FROM main.character WHERE code_point = ?");
  RowWriter more_elements(
      db,
      "INSERT INTO own_element_of SELECT ?1, place FROM main.character WHERE code_point = "
      "?2 AND NOT EXISTS (SELECT 1 FROM main.element_of e WHERE e.element = ?1 AND "
      "e.place = main.character.place)");
  for (const auto& [code_point, one] : own.replaced) {
    const auto key = static_cast<std::int64_t>(code_point);
    replaced.add(static_cast<int>(one.strokes.size()), key);
    // The published parts stay searchable, too.
    for (const std::string& element : element_keys(code_point, one.components))
      more_elements.add(element, key);
  }
  for (const Character& one : own.beside) {
    const auto key = static_cast<std::int64_t>(one.code_point);
    const auto strokes = static_cast<int>(one.strokes.size());
    const DictionaryEntry& entry = one.entry;
    characters.add(key, place, static_cast<int>(CharacterKind::other), strokes, strokes,
                   entry.radical.value_or(0), first_meaning(entry), first_reading(entry));
    int position = 0;
    const auto add_readings = [&](const std::vector<std::string>& texts, ReadingKind kind) {
      for (const std::string& text : texts) readings.add(key, position++, static_cast<int>(kind), text);
    };
    add_readings(entry.on_readings, ReadingKind::on);
    add_readings(entry.kun_readings, ReadingKind::kun);
    add_readings(entry.nanori, ReadingKind::nanori);
    position = 0;
    for (const auto& [language, text] : entry.meanings) meanings.add(key, position++, language, text);
    for (const auto& [text, fit] : reading_keys(entry))
      found_readings.add(text, place, static_cast<int>(fit));
    for (const auto& [text, fit] : meaning_keys(entry))
      found_meanings.add(text, place, static_cast<int>(fit));
    for (const std::string& element : element_keys(one.code_point, one.components))
      elements.add(element, place);
    ++place;
  }
}

}  // namespace nazori::kanji
