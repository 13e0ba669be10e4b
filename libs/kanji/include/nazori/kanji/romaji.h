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

/// As romaji_to_hiragana(), for text that is still being typed: a last syllable that is not complete gives
/// every syllable it can become. "yas" gives やさ, やし, やす, ...; "kan" gives かん, かな, かに, ...
[[nodiscard]] std::vector<std::string> romaji_beginnings(std::string_view romaji);

/// Katakana, full or half width, as hiragana; all else unchanged. Bytes that are not UTF-8 stay as they are.
[[nodiscard]] std::string to_hiragana(std::string_view text);

/// A reading as it is searched: hiragana without the okurigana dot, hyphens, middle dots and spaces.
[[nodiscard]] std::string fold_reading(std::string_view reading);

}  // namespace nazori::kanji
