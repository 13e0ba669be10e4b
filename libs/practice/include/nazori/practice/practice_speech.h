// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nazori/base/signal.h"
#include "nazori/practice/character_practice.h"
#include "nazori/practice/study_session.h"

namespace nazori::practice {

/// How a character is read out, in kana: a kana itself; of a kanji the first on'yomi, a pause, and the first
/// kun'yomi that stands alone. Empty for others.
[[nodiscard]] std::string reading_to_speak(const CharacterSheet& sheet);

/// Decides what is spoken during practice, and when: a kana when the session comes to it, because it is asked
/// for by its sound; the word of a dictation when it is asked for; and after the answer the reading that was
/// asked for. It makes no sound itself. Thread: that of the practice.
class PracticeSpeech {
 public:
  /// Why something is spoken.
  enum class Cause : std::uint8_t {
    wanted,    ///< the learner asked for it
    question,  ///< it is part of the question
    answer,    ///< the answer was given
  };

  /// @param practice, session  outlive this.
  PracticeSpeech(CharacterPractice& practice, const StudySession& session);
  PracticeSpeech(const PracticeSpeech&) = delete;
  PracticeSpeech& operator=(const PracticeSpeech&) = delete;

  /// The learner wants to hear what is practised: the word that is asked for, else the character's reading.
  /// @return false where there is nothing to speak.
  bool speak();
  /// What speak() would speak now; empty: nothing.
  [[nodiscard]] std::string reading() const;

  /// These kana are to be spoken.
  base::Signal<const std::string&, Cause> wanted;

 private:
  void follow(const PracticeStage& stage, const StageFeedback& what);
  void say(Cause cause);
  /// Whether the session is at a kana.
  [[nodiscard]] bool asks_kana() const;

  CharacterPractice& practice_;
  const StudySession& session_;
  std::vector<base::Connection> connections_;
};

}  // namespace nazori::practice
