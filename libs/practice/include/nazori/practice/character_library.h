// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nazori/base/executor.h"
#include "nazori/base/signal.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/part_picker.h"
#include "nazori/practice/character_source.h"
#include "nazori/practice/confusables.h"
#include "nazori/practice/dictation_words.h"
#include "nazori/practice/helpful_words.h"
#include "nazori/practice/search_answer.h"

namespace nazori::practice {

/// A part of a character, and the character that a click on it opens.
struct Part {
  std::string element;  ///< as drawn in the character, "亻"
  /// The character to open: the part itself, or what it stands for (人); 0 where neither can be shown.
  char32_t target = 0;
  std::string original;  ///< the character it is a form of, "人"; empty if none
  std::string meaning;   ///< first English meaning of the target
};

/// All that is shown about one character.
struct CharacterSheet {
  kanji::Character character;
  std::optional<kanji::Radical> radical;
  std::vector<Part> parts;
  std::vector<kanji::Word> words;
  CharacterWords helpful;
  /// Characters that are easily confused with it, as they are drawn.
  std::vector<kanji::Character> confusables;
  std::vector<DictationWord> dictation;  ///< those that can be asked for in a dictation, commonest first
};

/// What characters can be looked up by in tables.
struct CharacterTables {
  static constexpr int kFewestUses = 15;  ///< of a part in the table
  kanji::PartPicker picker;
  std::vector<kanji::Radical> radicals;
};

/// The characters of a list. Immutable, so that threads may share it.
using Summaries = std::shared_ptr<const std::vector<kanji::Summary>>;

/// Reads the kanji database on a separate thread. Requests return at once, answers come as signals. Of
/// several requests of one kind only the newest is answered. Thread: the owner of the inbox.
class CharacterLibrary {
 public:
  /// Maximum number of words in a sheet.
  static constexpr int kMaxWords = 60;

  /// Opens the database on the other thread; `opened` or `failed` follows.
  /// @param inbox  outlives this. @param source  own characters that change are noticed at the next request.
  CharacterLibrary(base::Inbox& inbox, CharacterSource source);
  ~CharacterLibrary();
  CharacterLibrary(const CharacterLibrary&) = delete;
  CharacterLibrary& operator=(const CharacterLibrary&) = delete;

  /// Asks for all characters of a list; `listed` follows.
  void request_list(kanji::List which);
  /// Searches with a line as kanji::read_query() reads it; `found` follows.
  /// @param among  only these characters: practice::members_of() its lists.
  void request_search(const std::string& typed, std::optional<std::vector<char32_t>> among = {});
  /// Asks for the table of parts and the radicals, which are read once; `tables_ready` follows.
  void request_tables();
  /// Asks for what a drill of confusable characters needs; `drill_ready` follows.
  void request_drill(std::vector<char32_t> characters);
  /// Asks for a character; `sheet_ready` or `sheet_missing` follows.
  void request_sheet(char32_t code_point);
  /// Asks for characters with their strokes, one after another; `characters_ready` follows.
  void request_characters(std::vector<char32_t> code_points);

  base::Signal<const std::vector<kanji::Source>&> opened;
  /// The database cannot be opened, or not all of it can be read. The latter is reported once.
  base::Signal<const base::Error&> failed;
  base::Signal<kanji::List, const Summaries&> listed;
  base::Signal<const std::string&, const std::shared_ptr<const SearchAnswer>&> found;
  base::Signal<const std::shared_ptr<const CharacterTables>&> tables_ready;
  base::Signal<const std::vector<ConfusableFacts>&> drill_ready;
  base::Signal<const std::shared_ptr<const CharacterSheet>&> sheet_ready;
  /// What was asked for, in its order; those without strokes are left out.
  base::Signal<const std::vector<kanji::Character>&> characters_ready;
  /// The character has no strokes in the database.
  base::Signal<char32_t> sheet_missing;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::practice
