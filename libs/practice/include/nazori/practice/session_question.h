// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nazori/kanji/kana.h"
#include "nazori/kanji/kana_sound.h"
#include "nazori/practice/character_library.h"
#include "nazori/practice/study_session.h"

namespace nazori::practice {

/// The question of a session: a word with a gap, else meanings and readings, else the sound of a kana, else a
/// number of strokes. A kana is never asked for by the other syllabary. UTF-8.
struct SessionQuestion {
  char32_t shown = 0;   ///< the character itself; 0 where the learner must know it
  std::string gap;      ///< the word with ◯ for the character; empty: the question has no word
  std::string reading;  ///< of that word; for a kana in romaji, which does not show it
  std::vector<std::string> meanings;            ///< English, of the word or of the character; a few
  std::vector<std::string> readings;            ///< of the character, on'yomi first; a few
  std::optional<kanji::KanaSound> sound;        ///< of a kana
  kanji::Script script = kanji::Script::other;  ///< of the character
  /// Kana that look like it, to be shown beside it; empty while the learner must know it.
  std::vector<char32_t> lookalikes;
  int strokes = 0;  ///< of the character

  friend bool operator==(const SessionQuestion&, const SessionQuestion&) = default;
};

/// The question that asks for a character from memory, without a word.
[[nodiscard]] SessionQuestion question_about(const kanji::Character& character);

/// The present question of `session`. @param sheet  of its character.
[[nodiscard]] SessionQuestion question_of(const StudySession& session, const CharacterSheet& sheet);

}  // namespace nazori::practice
