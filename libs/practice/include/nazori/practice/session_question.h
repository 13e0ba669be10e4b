// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nazori/practice/character_library.h"
#include "nazori/practice/study_session.h"

namespace nazori::practice {

/// The question of a session: a word with a gap, else meanings and readings, else the kana of the other
/// syllabary, else a number of strokes. UTF-8.
struct SessionQuestion {
  char32_t shown = 0;   ///< the character itself; 0 where the learner must know it
  std::string gap;      ///< the word with ◯ for the character; empty: the question has no word
  std::string reading;  ///< of that word
  std::vector<std::string> meanings;  ///< English, of the word or of the character; a few
  std::vector<std::string> readings;  ///< of the character, on'yomi first; a few
  char32_t other_kana = 0;            ///< where it has no meanings and readings: the kana of the same sound
  int strokes = 0;                    ///< of the character

  friend bool operator==(const SessionQuestion&, const SessionQuestion&) = default;
};

/// The present question of `session`. @param sheet  of its character.
[[nodiscard]] SessionQuestion question_of(const StudySession& session, const CharacterSheet& sheet);

}  // namespace nazori::practice
