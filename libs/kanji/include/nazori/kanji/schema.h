// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace nazori::kanji {

/// The layout of kanji.db, shared by its writer (ingest) and its reader (KanjiDatabase). A file of another
/// version is refused, never converted: it has to be rebuilt from its sources.

/// PRAGMA application_id of a kanji.db: "NZKD".
inline constexpr std::int32_t kSchemaApplicationId = 0x4E5A4B44;
/// PRAGMA user_version; goes up with every change of the layout or of what a column means.
inline constexpr std::int32_t kSchemaVersion = 2;

/// The CREATE statements, in SQL. They describe each table and column.
[[nodiscard]] std::string_view schema_sql();

/// Values of character.kind.
enum class CharacterKind : std::uint8_t {
  ideograph = 0,  ///< kanji and the parts of kanji that Unicode lists apart
  hiragana = 1,   ///< letters; marks such as ゝ are `other`
  katakana = 2,   ///< letters and the long vowel mark ー
  latin = 3,      ///< A-Z, a-z and the digits 0-9
  other = 4,      ///< punctuation and marks
};

/// Values of reading.kind.
enum class ReadingKind : std::uint8_t { on = 0, kun = 1, nanori = 2 };

/// Values of word.common.
enum class WordRank : std::uint8_t {
  other = 0,
  common = 1,  ///< EDICT's priority mark (P)
  basic = 2,   ///< taught first: our own table of basic words
};

/// Values of the column fit of reading_key, meaning_key and word_meaning_key: how well a key matches, best
/// first. Of a word, `whole` is its first gloss and `part` another one.
enum class KeyFit : std::uint8_t {
  whole = 0,  ///< a whole reading; the whole of the first English meaning
  part = 1,   ///< a reading without its okurigana; the whole of another English meaning
  name = 2,   ///< a reading in names; a meaning from its second or a later word on
};

}  // namespace nazori::kanji
