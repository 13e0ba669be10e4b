// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nazori::kanji {

/// The hiragana that Latin letters may spell, likeliest first; empty where they spell none. Hepburn, Kunrei
/// and what people type ("shi", "si", "tsu", "tu", "kyou", "nn", "n'", "shimbun", "matcha", "xtsu", "-" for
/// ー), in either case. A macron or circumflex is a long vowel; as spelling does not say which, each possible
/// one is given: "kyô" gives きょう, きょお and きょー.
[[nodiscard]] std::vector<std::string> romaji_to_hiragana(std::string_view romaji);

/// As romaji_to_hiragana(), for text that is still being typed: an incomplete last syllable gives every
/// syllable that begins with it. "yas" gives やさ, やし, やす, ...; "kan" gives かん, かな, かに, ...
[[nodiscard]] std::vector<std::string> romaji_beginnings(std::string_view romaji);

/// Katakana, full or half width, as hiragana; everything else, also invalid UTF-8, is unchanged.
[[nodiscard]] std::string to_hiragana(std::string_view text);

/// A reading normalised for searching: hiragana without the okurigana dot, hyphens, middle dots and spaces.
[[nodiscard]] std::string fold_reading(std::string_view reading);

}  // namespace nazori::kanji
