// SPDX-License-Identifier: Apache-2.0
#include "own_rows.h"

#include <array>
#include <cstdint>
#include <string>

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
  constexpr std::array kTables{"character", "reading", "meaning", "reading_key", "meaning_key", "element_of"};
  for (const char* const name : kTables) {
    const std::string table(name);
    // A temporary view is found before a table of the file that has the same name.
    db.exec("CREATE TEMP TABLE own_" + table + " AS SELECT * FROM main." + table + " WHERE false");
    db.exec("CREATE TEMP VIEW " + table + " AS SELECT * FROM main." + table +
            " UNION ALL SELECT * FROM own_" + table);
  }
}

}  // namespace

void add_own_rows(SQLite::Database& db, std::span<const Character> own) {
  std::int64_t place = db.execAndGet("SELECT count(*) FROM main.character").getInt64();
  make_views(db);
  RowWriter characters(db, "INSERT INTO own_character VALUES(?, ?, ?, ?, ?, NULL, NULL, NULL, ?, ?, ?)");
  RowWriter readings(db, "INSERT INTO own_reading VALUES(?, ?, ?, ?)");
  RowWriter meanings(db, "INSERT INTO own_meaning VALUES(?, ?, ?, ?)");
  RowWriter found_readings(db, "INSERT INTO own_reading_key VALUES(?, ?, ?)");
  RowWriter found_meanings(db, "INSERT INTO own_meaning_key VALUES(?, ?, ?)");
  RowWriter elements(db, "INSERT INTO own_element_of VALUES(?, ?)");
  for (const Character& one : own) {
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
