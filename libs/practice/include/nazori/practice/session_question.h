// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "nazori/kanji/kana.h"
#include "nazori/kanji/kana_sound.h"
#include "nazori/practice/character_library.h"
#include "nazori/practice/study_session.h"

namespace nazori::practice {

/// What the learner goes by.
enum class Prompt : std::uint8_t {
  character,  ///< it is shown: the learner is taught
  meaning,    ///< meanings and readings, with a word where one helps
  word,       ///< a word with the character left out, and nothing else
  sound,      ///< of a kana
  strokes,    ///< nothing but their number
};

/// Why a word is part of the question.
enum class WordReason : std::uint8_t {
  asked,  ///< this review asks by a word
  known,  ///< the learner knows its other kanji
  helps,  ///< the most helpful of its words
};

/// A word of the character.
struct QuestionWord {
  std::string text;                   ///< with kGap for the character, unless the character is shown
  std::string reading;                ///< for a kana in romaji, which does not show it
  std::vector<std::string> meanings;  ///< English; a few
  WordReason reason = WordReason::helps;

  friend bool operator==(const QuestionWord&, const QuestionWord&) = default;
};

/// The question of a session. The same session and sheet always give the same question. Until it is answered
/// no part of it contains the character that is asked for, and a kana is never asked for by the other
/// syllabary. UTF-8.
struct SessionQuestion {
  static constexpr const char* kGap = "＿";  ///< in place of the character

  Prompt prompt = Prompt::strokes;
  char32_t shown = 0;                           ///< the character itself; 0 where the learner must know it
  std::vector<std::string> meanings;            ///< English, of the character; a few, best first
  std::vector<std::string> readings;            ///< of the character, on'yomi first; a few
  std::optional<QuestionWord> word;             ///< short, and known if there is such a word
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

/// The question in as little as `room` allows: the first meaning and reading stay.
enum class QuestionRoom : std::uint8_t {
  full,   ///< everything
  lines,  ///< two lines: fewer meanings and readings
  line,   ///< one line: one meaning and one reading, and a word only if it is the question
};
/// How much room there is in a window. @param height_em  of the window, in sizes of its text.
[[nodiscard]] QuestionRoom room_for_question(double height_em);
[[nodiscard]] SessionQuestion shortened(SessionQuestion question, QuestionRoom room);

}  // namespace nazori::practice
