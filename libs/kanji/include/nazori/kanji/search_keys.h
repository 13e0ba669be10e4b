// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>

#include "nazori/kanji/character.h"
#include "nazori/kanji/schema.h"

namespace nazori::kanji {

/// By what a character is found: a key and how well it fits. Shared by what writes kanji.db (ingest) and what
/// adds a learner's own characters to it.
using SearchKeys = std::map<std::string, KeyFit>;

/// Adds a key, or improves its fit. An empty key is none.
void offer_key(SearchKeys& keys, std::string key, KeyFit fit);

/// Readings as fold_reading() writes them, kun readings also without their okurigana.
[[nodiscard]] SearchKeys reading_keys(const DictionaryEntry& entry);
/// English meanings as fold_meaning() writes them, each also from each of its later words on.
[[nodiscard]] SearchKeys meaning_keys(const DictionaryEntry& entry);
/// The parts by which a character is found, at any depth, and what they stand for; never itself.
[[nodiscard]] std::set<std::string> element_keys(char32_t character, const Component& components);

/// What stands in a list: the first English meaning, and the first kun or else on reading; empty where there
/// is none.
[[nodiscard]] std::string first_meaning(const DictionaryEntry& entry);
[[nodiscard]] std::string first_reading(const DictionaryEntry& entry);

}  // namespace nazori::kanji
