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

namespace nazori::practice {

/// A part of a character, and the character that it leads to.
struct Part {
  std::string element;  ///< as drawn in the character, "亻"
  /// The character to go to: itself, or what it stands for (人); 0 where neither can be shown.
  char32_t target = 0;
  std::string original;  ///< what it is a form of, "人"; empty where it is itself
  std::string meaning;   ///< first English meaning of the target
};

/// All that is shown of one character, read in one go.
struct CharacterSheet {
  kanji::Character character;
  std::optional<kanji::Radical> radical;
  std::vector<Part> parts;
  std::vector<kanji::Word> words;
};

/// Characters as a list shows them. Immutable, so that threads may share it.
using Summaries = std::shared_ptr<const std::vector<kanji::Summary>>;

/// The kanji database behind a thread of its own. Requests return at once, answers come as signals. Of
/// several requests of one kind only the newest is answered. Thread: the owner of the inbox.
class CharacterLibrary {
 public:
  /// Most words of a sheet.
  static constexpr int kMaxWords = 60;

  /// Opens the database behind the caller; opened or failed follows.
  /// @param inbox  outlives this. @param path  of kanji.db.
  CharacterLibrary(base::Inbox& inbox, std::filesystem::path path);
  ~CharacterLibrary();
  CharacterLibrary(const CharacterLibrary&) = delete;
  CharacterLibrary& operator=(const CharacterLibrary&) = delete;

  /// Asks for all characters of a list; `listed` follows.
  void request_list(kanji::List which);
  /// Asks for what a search finds, as kanji::Query::text; `found` follows.
  void request_search(const std::string& text);
  /// Asks for a character; `sheet_ready` or `sheet_missing` follows.
  void request_sheet(char32_t code_point);

  base::Signal<const std::vector<kanji::Source>&> opened;
  /// The database cannot be opened, or not all of it can be read. The latter is reported once.
  base::Signal<const base::Error&> failed;
  base::Signal<kanji::List, const Summaries&> listed;
  base::Signal<const std::string&, const Summaries&> found;
  base::Signal<const std::shared_ptr<const CharacterSheet>&> sheet_ready;
  /// The character has no strokes in the database.
  base::Signal<char32_t> sheet_missing;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::practice
