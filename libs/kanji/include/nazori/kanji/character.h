// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nazori/kanji/stroke.h"

namespace nazori::kanji {

/// A node of KanjiVG's group tree: a component of a character, or a nameless grouping of strokes. Texts are
/// as published, empty where the attribute is absent.
struct Component {
  std::string element;        ///< kvg:element, "亻"
  std::string original;       ///< kvg:original, "人"
  std::string position;       ///< kvg:position, "left"
  std::string radical;        ///< kvg:radical, "general", "tradit", "nelson", "jis"
  std::string phon;           ///< kvg:phon, the part that gives the sound
  std::optional<int> part;    ///< kvg:part, where an element is written in several pieces
  std::optional<int> number;  ///< kvg:number, which of several copies of a split element
  bool variant = false;
  bool partial = false;
  bool trad_form = false;
  bool radical_form = false;
  int first_stroke = 0;             ///< 0-based index of the first stroke inside, in writing order
  std::vector<int> strokes;         ///< 0-based indices of all strokes inside, children's too, ascending
  std::vector<Component> children;  ///< in the order of the source

  friend bool operator==(const Component&, const Component&) = default;
};

/// Another accepted order of the same strokes.
struct AlternativeOrder {
  std::vector<int> order;  ///< 1-based stroke numbers of the main form in the order they are written
  std::string source;      ///< where it is attested: "KanjiVG variant HzFst", "Tebiki 1958 list"

  friend bool operator==(const AlternativeOrder&, const AlternativeOrder&) = default;
};

/// A meaning in one language.
struct Meaning {
  std::string language;  ///< ISO 639-1: "en", "fr", "es", "pt"
  std::string text;

  friend bool operator==(const Meaning&, const Meaning&) = default;
};

/// A code of a dictionary or a query system: type as KANJIDIC2 names it ("skip", "four_corner", "deroo",
/// "nelson_c", ...).
struct Code {
  std::string system;
  std::string value;

  friend bool operator==(const Code&, const Code&) = default;
};

/// One of the 214 classical radicals.
struct Radical {
  int number = 0;                           ///< 1..214
  std::string form;                         ///< "人"
  std::vector<std::string> variant_forms;   ///< "亻", "𠆢"
  std::vector<std::string> japanese_names;  ///< "ひと", "にんべん"; the commonest first
  std::string english_name;                 ///< "person"
  int strokes = 0;                          ///< of the classical form

  friend bool operator==(const Radical&, const Radical&) = default;
};

/// The dictionary entry of a character in KANJIDIC2. Empty lists and nullopt where it has no information.
struct DictionaryEntry {
  std::vector<std::string> on_readings;   ///< katakana: "キュウ"
  std::vector<std::string> kun_readings;  ///< hiragana, okurigana after the dot: "やす.む"
  std::vector<std::string> nanori;        ///< readings in names
  std::vector<Meaning> meanings;          ///< English first
  std::optional<int> grade;               ///< 1..6 kyouiku, 8 other jouyou, 9 and 10 jinmeiyou
  std::optional<int> frequency;           ///< rank 1..2501 in newspapers
  std::optional<int> old_jlpt_level;      ///< 4 (easiest) .. 1, the levels before 2010
  std::vector<int> stroke_counts;  ///< the accepted count first, then counts sometimes given by mistake
  std::optional<int> radical;      ///< classical radical number
  std::vector<Code> codes;

  friend bool operator==(const DictionaryEntry&, const DictionaryEntry&) = default;
};

/// A character of the database: its strokes (KanjiVG) and what the dictionary says (KANJIDIC2). Characters
/// that only the dictionary knows have no strokes; kana, letters and digits have no dictionary entry.
struct Character {
  char32_t code_point = 0;
  std::string variant;          ///< suffix of KanjiVG's file ("Kaisho", "HzFst"), empty for the main form
  std::vector<Stroke> strokes;  ///< in writing order
  Component components;         ///< root of the group tree
  std::vector<AlternativeOrder> alternative_orders;
  std::vector<std::string>
      variants;  ///< suffixes of the variant files of the same character (main form only)
  DictionaryEntry entry;
  /// The own character whose strokes and parts these are, where somebody's form takes the place of the
  /// published one (main form only).
  std::optional<char32_t> own_form;

  /// Only the lines of the strokes, for carving and drawing.
  [[nodiscard]] std::vector<StrokeLine> lines() const;
};

/// A word of EDICT.
struct Word {
  std::string text;                  ///< "休日"
  std::string reading;               ///< "きゅうじつ"; equal to text for words written in kana
  std::vector<std::string> glosses;  ///< English
  std::vector<int> senses;           ///< for each gloss the number of its sense, from 1, ascending
  std::string parts_of_speech;       ///< EDICT's marks, "n,adj-no"
  bool common = false;               ///< marked (P), or basic
  bool basic = false;                ///< taught first: our own table of basic words

  friend bool operator==(const Word&, const Word&) = default;
};

}  // namespace nazori::kanji
