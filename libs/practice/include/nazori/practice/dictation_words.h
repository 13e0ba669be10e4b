// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "nazori/kanji/character.h"

namespace nazori::practice {

/// A word to be written whole from memory.
struct DictationWord {
  kanji::Word word;
  std::vector<char32_t> characters;  ///< of its text

  /// A syllable of two kana, such as きゃ, rather than a word.
  bool is_syllable = false;

  /// What is shown: the reading, or for a word in kana alone its romaji.
  [[nodiscard]] std::string prompt() const;
  /// What is read out, in kana.
  [[nodiscard]] const std::string& spoken() const { return word.reading; }
  /// Whether it is written in kana alone.
  [[nodiscard]] bool is_in_kana() const;

  friend bool operator==(const DictationWord&, const DictationWord&) = default;
};

/// A word of a dictation has so many characters.
inline constexpr std::size_t kFewestDictated = 2, kMostDictated = 3;

/// Those of `words`, in their order, that have the character, a meaning, and only characters that can be
/// drawn.
/// @param draws  whether a character has strokes.
[[nodiscard]] std::vector<DictationWord> dictation_words(const std::vector<kanji::Word>& words,
                                                         char32_t character,
                                                         const std::function<bool(char32_t)>& draws);

/// What a kana can be practised in: the syllables of two kana that have it (きゃ), then words of 2 and 3
/// kana. Words that are usually written with kanji are asked for in kana, as beginners write them.
/// @param heard  common words whose reading has the kana, as KanjiDatabase::words_heard_with() gives them.
/// @param draws  whether a character has strokes.
[[nodiscard]] std::vector<DictationWord> kana_words(const std::vector<kanji::Word>& heard, char32_t kana,
                                                    const std::function<bool(char32_t)>& draws);

/// Puts the words first whose other characters the learner knows, and leaves them in their order otherwise.
/// For a kanji only kanji count, for a kana kana too.
/// @param knows  may be empty: nothing is known of the learner.
[[nodiscard]] std::vector<DictationWord> best_known_first(std::vector<DictationWord> words,
                                                          char32_t character,
                                                          const std::function<bool(char32_t)>& knows);

}  // namespace nazori::practice
