// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/study/learner_store.h"

namespace nazori::study {

/// The data of a character that determine the learning order.
struct CharacterFacts {
  char32_t character = 0;
  std::optional<int> grade;           ///< 1..6, 8, 9, 10
  std::optional<int> frequency;       ///< rank in newspapers
  std::optional<int> old_jlpt_level;  ///< 4 (easiest) .. 1, the levels before 2010
  int strokes = 0;
  std::vector<char32_t> components;  ///< characters it is composed of, at any depth

  friend bool operator==(const CharacterFacts&, const CharacterFacts&) = default;
};

/// A built-in list: its id and its English name for people.
struct ReadyList {
  std::string id;    ///< "grade-1", "old-jlpt-4", ...
  std::string name;  ///< "grade 1", "old JLPT level 4 (before 2010)"
};

/// The built-in lists: grade-1 .. grade-6, secondary, jinmeiyou, hiragana, katakana, old-jlpt-4 ..
/// old-jlpt-1, own (characters that people made).
[[nodiscard]] std::span<const ReadyList> ready_lists();

/// The lists that can be chosen.
struct ListIds {
  std::vector<std::string> ids;       ///< built-in ones, then "list:NAME" and "tag:NAME"
  std::optional<base::Error> unread;  ///< why the learner's own lists or tags are missing

  /// All of them, the chosen ones first and in their order. A chosen list that no longer exists is left out,
  /// but not while lists are missing.
  [[nodiscard]] std::vector<std::string> chosen_first(const std::vector<std::string>& chosen) const;
};
[[nodiscard]] ListIds list_ids(const LearnerStore& learner);

/// Characters and lists of the kanji database, read when they are first needed. Thread-safe: no.
class CharacterLists {
 public:
  /// @param database  must live as long as this.
  explicit CharacterLists(const kanji::KanjiDatabase& database) : database_(&database) {}

  /// The members of a list, in its own order: "grade-1", "list:NAME" for one of the learner's own lists,
  /// "tag:NAME" for the characters with a tag.
  /// @return Errc::not_found; else as LearnerStore::lists().
  [[nodiscard]] base::Result<std::vector<char32_t>> members(std::string_view id, const LearnerStore& learner);

  /// Facts of a character; nullptr where the database has no strokes of it. Valid as long as this object.
  [[nodiscard]] const CharacterFacts* facts(char32_t character);

  /// Every character of the chosen lists once, in learning order. Lists that do not exist are ignored.
  /// @return as LearnerStore::lists().
  [[nodiscard]] base::Result<std::vector<char32_t>> in_learning_order(const Settings& settings,
                                                                      const LearnerStore& learner);

 private:
  [[nodiscard]] const std::vector<char32_t>& ready(std::string_view id);
  const kanji::KanjiDatabase* database_;
  std::map<std::string, std::vector<char32_t>, std::less<>> ready_;
  std::map<char32_t, CharacterFacts> facts_;
};

/// Sorts characters. Equal ones keep their order; a character for which a fact is unknown comes last. In
/// every order but NewOrder::own kana come before kanji and by kanji::teaching_rank(), the syllabary of the
/// first one before the other.
[[nodiscard]] std::vector<char32_t> sort_for_learning(
    std::vector<char32_t> characters, NewOrder order,
    const std::function<const CharacterFacts*(char32_t)>& facts);

/// Reads a list from text: characters in any number to a line, with or without blanks and commas between
/// them; text after a # is a comment. Repeated characters count once.
/// @param known  whether a character can be studied.
/// @return Errc::parse with the line for anything else and for a text without characters.
[[nodiscard]] base::Result<std::vector<char32_t>> parse_list(std::string_view text,
                                                             const std::function<bool(char32_t)>& known);

}  // namespace nazori::study
