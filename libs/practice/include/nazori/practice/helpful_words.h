// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "nazori/kanji/character.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/word_reading.h"

namespace nazori::practice {

/// A word that helps to remember a character.
struct HelpfulWord {
  kanji::Word word;
  std::vector<std::string> meanings;  ///< without the editors' marks, at most three
  /// The readings of its characters; empty where the reading cannot be divided: 今日.
  std::vector<kanji::ReadingPiece> pieces;
  std::vector<char32_t> others;  ///< its other kanji, each once
  double cost = 0;               ///< the smaller the more it helps a learner of whom nothing is known

  friend bool operator==(const HelpfulWord&, const HelpfulWord&) = default;
};

/// A reading of a character, and a word that uses it.
struct ReadingUse {
  std::string reading;  ///< as the dictionary writes it: "ニン", "やす.む"
  std::string sound;    ///< as it sounds in the word: "びと"
  HelpfulWord word;

  friend bool operator==(const ReadingUse&, const ReadingUse&) = default;
};

/// The words of a character: those that help it to be remembered, and one for each reading.
struct CharacterWords {
  std::vector<HelpfulWord> words;  ///< by cost
  std::vector<ReadingUse>
      uses;  ///< in the order of the dictionary; readings that no common word has are left out
};

inline constexpr std::size_t kMostHelpfulWords = 6;

/// Chooses among the words of a character. A word costs less if it is basic or common, short, made of kanji
/// that are taught no later than the character, and has a meaning of the character in its own; it costs more
/// if it is unusual, usually written in kana, or read in a way that the dictionary does not explain.
/// @param database  from which the words and the other kanji are read.
[[nodiscard]] CharacterWords words_that_help(const kanji::KanjiDatabase& database,
                                             const kanji::Character& character);

/// The words for one learner, best first: those whose other kanji the learner knows come before those with
/// unknown ones, and different readings before more of the same.
/// @param knows  may be empty: nothing is known of the learner. @param most  maximum number of words.
[[nodiscard]] std::vector<HelpfulWord> choose_words(const std::vector<HelpfulWord>& words, char32_t character,
                                                    const std::function<bool(char32_t)>& knows,
                                                    std::size_t most = kMostHelpfulWords);

}  // namespace nazori::practice
