// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "nazori/ingest/edict.h"
#include "nazori/ingest/kanjivg.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::ingest {

/// Fills a new kanji.db. Every function may throw SQLite::Exception. Nothing is permanent before finish().
class DatabaseWriter {
 public:
  /// Makes the file, which must not exist, and its tables.
  explicit DatabaseWriter(const std::filesystem::path& path);

  void add_source(const kanji::Source& source);
  void add_radicals();
  /// A form with its strokes and groups. Forms must be sorted by character, the main form first.
  void add_form(const DrawnForm& form);
  void add_orders(char32_t code_point, std::span<const kanji::AlternativeOrder> orders);
  /// A character with its rank in the learning order; `main` if it has strokes, `entry` if the dictionary has
  /// it.
  void add_character(char32_t code_point, std::int64_t place, const DrawnForm* main,
                     const kanji::DictionaryEntry* entry);
  /// The next word; the commonest first.
  void add_word(const EdictEntry& word);
  void finish();

 private:
  void add_entry(char32_t code_point, const kanji::DictionaryEntry& entry);
  void add_word_keys(const EdictEntry& word, std::int64_t id, bool is_common);
  void add_keys(char32_t code_point, std::int64_t place, const DrawnForm* main,
                const kanji::DictionaryEntry* entry);

  SQLite::Database db_;
  SQLite::Statement source_, radical_, radical_form_, radical_name_;
  SQLite::Statement form_, stroke_, component_, order_;
  SQLite::Statement character_, stroke_count_, reading_, meaning_, code_;
  SQLite::Statement word_, word_of_, word_key_, word_meaning_key_, reading_key_, meaning_key_, element_of_;
  std::int64_t forms_ = 0;
  std::int64_t words_ = 0;
  std::int64_t sources_ = 0;
};

}  // namespace nazori::ingest
