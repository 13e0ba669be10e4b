// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/schema.h"
#include "own_rows.h"

namespace nazori::kanji {

/// What searches and lists need to know of every character, in the order of their ranks. All of it is kept in
/// memory: fetching a row for each of thousands of list rows takes longer than the search.
struct RosterEntry {
  char32_t code_point = 0;
  CharacterKind kind = CharacterKind::other;
  int drawn = 0;         ///< strokes of the main form, 0 where nothing is drawn
  int counted = 0;       ///< the dictionary's count, 0 where it has none
  int grade = 0;         ///< 0: none
  int radical = 0;       ///< 0: none
  int old_jlpt = 0;      ///< 0: none
  int frequency = 0;     ///< 0: none
  bool is_made = false;  ///< somebody made its form
  std::string meaning;
  std::string reading;
};

/// A prepared statement that is reset whichever way its use ends.
class Rewound {
 public:
  explicit Rewound(SQLite::Statement& statement) : statement_(statement) {}
  Rewound(const Rewound&) = delete;
  Rewound& operator=(const Rewound&) = delete;
  ~Rewound() { (void)statement_.tryReset(); }
  SQLite::Statement* operator->() { return &statement_; }
  [[nodiscard]] int number(int column) { return statement_.getColumn(column).getInt(); }
  [[nodiscard]] std::optional<int> optional_number(int column) {
    const auto value = statement_.getColumn(column);
    return value.isNull() ? std::nullopt : std::optional(value.getInt());
  }
  [[nodiscard]] std::string text(int column) { return statement_.getColumn(column).getString(); }

 private:
  SQLite::Statement& statement_;
};

struct KanjiDatabase::Inside {
  Inside(SQLite::Database opened, std::string file, OwnForms made);

  /// Runs `work`. If the database fails, returns `otherwise` and stores the error for trouble().
  template <class Answer, class Work>
  Answer answer_or(Answer otherwise, Work work) {
    try {
      return work();
    } catch (const SQLite::Exception& e) {
      note_trouble(e.what());
      return otherwise;
    }
  }
  void note_trouble(const char* what);

  class Conditions;
  /// @param explained  whether the answers say which reading or meaning matches.
  [[nodiscard]] std::vector<Match> find_matches(const Query& query, bool explained);
  [[nodiscard]] std::string matching_reading(char32_t code_point, std::string_view key);
  [[nodiscard]] std::string matching_meaning(char32_t code_point, std::string_view key);
  /// Passes the words with this key to `take`, and whether the key is all of it.
  void offer_words(std::string_view key, bool is_complete, std::int64_t last_common,
                   const std::function<void(std::int64_t, bool)>& take);
  /// -1 where there is none.
  [[nodiscard]] std::int64_t last_common_word();
  [[nodiscard]] std::optional<int> radical_of_form(const std::string& form);
  [[nodiscard]] static Word read_word(Rewound& row);

  [[nodiscard]] const std::vector<RosterEntry>& roster() const { return roster_; }
  /// Rank of a character, or nullopt.
  [[nodiscard]] std::optional<std::size_t> place_of(char32_t code_point) const;
  [[nodiscard]] Summary summary(std::size_t place) const;
  /// The place of the first own character.
  [[nodiscard]] std::size_t first_own() const { return roster_.size() - own.size(); }
  /// nullptr for a character of the file, and for none.
  [[nodiscard]] const Character* find_own(char32_t code_point) const;

  SQLite::Database db;
  std::string name;
  std::vector<Character> own;           ///< in the order of their places, after those of the file
  std::map<char32_t, Character> forms;  ///< that take the place of those of the file
  std::optional<base::Error> trouble;   ///< the first error since it was opened
  SQLite::Statement character, form, variants, strokes, components, orders;
  SQLite::Statement stroke_counts, readings, meanings, codes;
  SQLite::Statement all_characters, words, heard_words, elements;
  SQLite::Statement radical, radical_forms, radical_names, sources;
  SQLite::Statement reading_keys, meaning_keys;
  SQLite::Statement word, words_of_key, words_after_key, words_of_meaning;
  SQLite::Statement codes_of, all_radicals, form_of_radical;

 private:
  void load_roster();
  std::vector<RosterEntry> roster_;
  std::optional<std::int64_t> last_common_word_;
  std::unordered_map<char32_t, std::size_t> places_;
};

}  // namespace nazori::kanji
