// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nazori::kanji {

/// How a kana sounds, in Latin letters, so that a learner can be asked for it.
struct KanaSound {
  std::string romaji;  ///< Hepburn: "shi", "ji" for じ and for ぢ; of a small kana that of the full-size one;
                       ///< "-" for ー
  std::string
      typed;  ///< where others sound the same, how this one is typed: "di" for ぢ, "wo" for を; else empty
  bool is_small = false;  ///< っ, ゃ, ぁ

  friend bool operator==(const KanaSound&, const KanaSound&) = default;
};

/// The sound of a hiragana or katakana; nothing for marks and other characters.
[[nodiscard]] std::optional<KanaSound> kana_sound(char32_t kana);

/// Hepburn of a word in kana, letter by letter, so that the spelling can be told from it: "gakkou" for
/// がっこう, "kya" for きゃ, "kon'ya" for こんや; ー lengthens: "kōhī" for コーヒー. Other characters are
/// unchanged.
[[nodiscard]] std::string romaji_of(std::string_view kana);

/// The rank of a kana in the order in which kana are taught, the same for both syllabaries: the table of
/// fifty sounds row by row, ん, ー, then っ ゃ ゅ ょ, so that きゃ can be written early, then the voiced
/// rows, the small vowels, and kana that hardly occur (ゐ, ゔ). nullopt for other characters.
[[nodiscard]] std::optional<int> teaching_rank(char32_t kana);

/// Kana of the same syllabary that beginners mistake for this one, nearest first: め for ぬ, ツ for シ; of a
/// voiced one the other marks on the same kana. Empty for most other characters.
[[nodiscard]] std::vector<char32_t> similar_kana(char32_t kana);

/// The syllables of two kana in which this one occurs, in teaching order: きゃ, きゅ and きょ for き; きゃ,
/// しゃ,
/// ... for ゃ. UTF-8, in its syllabary; empty where there are none.
[[nodiscard]] std::vector<std::string> combinations_with(char32_t kana);

}  // namespace nazori::kanji
