// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nazori::kanji {

/// How one character of a word is read.
struct ReadingPiece {
  char32_t character = 0;
  std::string reading;  ///< hiragana as the word has it: "びと" of 人 in 村人; of a kana the kana itself
  std::string from;     ///< the dictionary's reading behind it, "ひと"; empty for a kana

  friend bool operator==(const ReadingPiece&, const ReadingPiece&) = default;
};

/// The readings of a character as KANJIDIC2 writes them: "ニン", "やす.む".
using ReadingsOf = std::function<std::vector<std::string>(char32_t)>;

/// Divides the reading of a word among its characters, with the changes of sound that words have: voicing
/// (ひと, びと), っ for a last く, つ, ち or き (がく, がっこう), ぱ for は after っ or ん, and verbs in
/// their continuative form without okurigana (受付 うけつけ). 々 is read as the character before it. Of
/// several ways the one with the fewest changes is taken.
/// @return nullopt where the readings do not make up the word: 今日 read きょう.
[[nodiscard]] std::optional<std::vector<ReadingPiece>> divide_reading(std::string_view word,
                                                                      std::string_view reading,
                                                                      const ReadingsOf& readings_of);

}  // namespace nazori::kanji
