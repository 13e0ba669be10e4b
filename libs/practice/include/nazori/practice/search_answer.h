// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/query_text.h"
#include "nazori/practice/learner.h"

namespace nazori::practice {

/// A word in the answer to a search.
struct FoundWord {
  std::string text;                   ///< "休日"
  std::string reading;                ///< "きゅうじつ"
  std::vector<std::string> meanings;  ///< without the editors' marks, at most three

  friend bool operator==(const FoundWord&, const FoundWord&) = default;
};

/// One row of the answer to a search: a character, or a word that leads to its first character.
struct SearchRow {
  kanji::Summary character;  ///< to open
  kanji::Reason reason = kanji::Reason::condition;
  std::string text;               ///< the reading or meaning that matches
  std::optional<FoundWord> word;  ///< the row is a word

  friend bool operator==(const SearchRow&, const SearchRow&) = default;
};

/// The answer to a search, best first: characters that match as a whole, words that do, then the rest.
struct SearchAnswer {
  std::vector<SearchRow> rows;
  int characters = 0;  ///< number of rows with characters

  friend bool operator==(const SearchAnswer&, const SearchAnswer&) = default;
};

inline constexpr int kMostFoundWords = 12;

/// Searches characters and words. A word without a character that can be shown is left out, and so are all
/// words where there are conditions besides the text.
/// @param among  only these characters: the members of the lists in the query.
[[nodiscard]] SearchAnswer search_answer(const kanji::KanjiDatabase& database, const kanji::TypedQuery& typed,
                                         const std::optional<std::vector<char32_t>>& among = {});

/// The characters that are in all lists and tags of a query; nothing where it names none.
/// @return as study::CharacterLists::members().
[[nodiscard]] base::Result<std::optional<std::vector<char32_t>>> members_of(const kanji::TypedQuery& typed,
                                                                            Learner& learner);

}  // namespace nazori::practice
