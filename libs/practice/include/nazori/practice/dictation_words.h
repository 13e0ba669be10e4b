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

  /// What is read out or shown: the reading, or for a word in kana alone the word in the other syllabary.
  [[nodiscard]] std::string prompt() const;
};

/// A word of a dictation has so many characters.
inline constexpr std::size_t kFewestDictated = 2, kMostDictated = 3;

/// Those of `words`, in their order, that have the character, a meaning, and only characters that can be
/// drawn.
/// @param draws  whether a character has strokes.
[[nodiscard]] std::vector<DictationWord> dictation_words(const std::vector<kanji::Word>& words,
                                                         char32_t character,
                                                         const std::function<bool(char32_t)>& draws);

/// Puts the words first whose other kanji the learner knows, and leaves them in their order otherwise.
/// @param knows  may be empty: nothing is known of the learner.
[[nodiscard]] std::vector<DictationWord> best_known_first(std::vector<DictationWord> words,
                                                          char32_t character,
                                                          const std::function<bool(char32_t)>& knows);

}  // namespace nazori::practice
