// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "nazori/kanji/character.h"

namespace nazori::kanji {

/// The conditions of a search. An answer meets all that are set.
struct Query {
  /// A character or several, a reading in kana (with or without the okurigana dot), romaji (Hepburn or
  /// Kunrei, "kyuu", "kyû"), or the beginning of an English word of a meaning. Text that contains kanji finds
  /// each of these kanji, in the order of the text. Empty: no condition.
  std::string text;
  std::optional<int> grade;
  std::optional<int> strokes;         ///< as drawn, or as the dictionary counts them: they differ for a few
  std::optional<int> most_strokes;    ///< with `strokes`: from so many to so many
  std::optional<int> radical;         ///< classical number 1..214
  std::string radical_form;           ///< the same by any form of it, "亻"; empty: no condition
  std::optional<int> old_jlpt_level;  ///< 4 (easiest) .. 1, the levels before 2010
  std::optional<int> frequency;       ///< one of the so many most frequent in newspapers
  std::string skip;                   ///< code of the SKIP system or its beginning: "1-2-4", "1-2-"
  std::string four_corner;            ///< four-corner code or its beginning: "2429.0", "2429"
  std::vector<std::string> parts;     ///< all of these are parts of the character, or it is one of them
  std::optional<std::vector<char32_t>> among;  ///< only these characters
  bool drawn_only = true;  ///< only characters that have strokes; false: the whole dictionary
  int limit = 500;         ///< maximum number of answers, >= 1

  friend bool operator==(const Query&, const Query&) = default;
};

/// One row of a list of characters.
struct Summary {
  char32_t code_point = 0;
  std::string meaning;  ///< first English meaning, empty for kana and letters
  std::string reading;  ///< first kun or on reading
  int strokes = 0;      ///< number of strokes in the main form; the dictionary's where it is not drawn
  std::optional<int> grade;

  friend bool operator==(const Summary&, const Summary&) = default;
};

/// Why a character is an answer to the text of a query.
enum class Reason : std::uint8_t {
  condition,  ///< there was no text: it meets the other conditions
  itself,     ///< it was typed
  reading,
  name,  ///< a reading in names
  meaning,
};

/// An answer, and why it is one.
struct Match {
  Summary summary;
  Reason reason = Reason::condition;
  std::string text;    ///< the reading ("やす.む") or meaning that matches, as the dictionary writes it
  bool whole = false;  ///< the query is the whole of it, or the reading without its okurigana

  friend bool operator==(const Match&, const Match&) = default;
};

/// A word that matches a text.
struct WordMatch {
  Word word;
  bool by_meaning = false;  ///< by a gloss, else by its text or reading
  bool whole = false;       ///< the text is all of it

  friend bool operator==(const WordMatch&, const WordMatch&) = default;
};

/// A part in a table of parts, and the characters that have it.
struct PartUse {
  std::string element;  ///< "木"
  int strokes = 0;
  std::vector<char32_t> characters;  ///< commonest first

  friend bool operator==(const PartUse&, const PartUse&) = default;
};

}  // namespace nazori::kanji
