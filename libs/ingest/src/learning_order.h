// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

#include "nazori/ingest/edict.h"
#include "nazori/kanji/character.h"
#include "nazori/kanji/schema.h"

namespace nazori::ingest {

[[nodiscard]] kanji::CharacterKind kind_of(char32_t code_point);

/// All characters in learning order: hiragana and katakana as in the table of fifty sounds, then voiced,
/// half-voiced and small ones; digits and letters; drawn kanji by newspaper frequency, those without one by
/// grade, then by code point; other drawn marks; characters only in the dictionary, in the same order.
[[nodiscard]] std::vector<char32_t> learning_order(
    const std::set<char32_t>& drawn, const std::map<char32_t, kanji::DictionaryEntry>& dictionary);

/// How early a learner should see a word; the smaller the earlier. First come the basic words of our own
/// table. EDICT only marks common words with (P), so among these: words in ordinary use before archaic, rare
/// and irregular ones, then shorter before longer ones, where hiragana count half, then those whose kanji are
/// together the more frequent in newspapers.
struct WordPlace {
  bool advanced = false;  ///< not a basic word
  bool uncommon = false;
  bool unusual = false;            ///< marked archaic, obsolete, obscure, rare or irregular
  std::int32_t length = 0;         ///< 1 for each hiragana, 2 for each other character
  std::int32_t frequency_sum = 0;  ///< of the ranks of its kanji; 2,502 for all else but hiragana
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 that <=> is compared with for a pointer
  friend auto operator<=>(const WordPlace&, const WordPlace&) = default;
};
[[nodiscard]] WordPlace place_of_word(const EdictEntry& word,
                                      const std::map<char32_t, kanji::DictionaryEntry>& dictionary);

}  // namespace nazori::ingest
