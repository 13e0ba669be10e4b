// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "nazori/author/own_character.h"
#include "nazori/base/file_lock.h"
#include "nazori/base/result.h"
#include "nazori/kanji/character.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/own_characters.h"

namespace nazori::author {

/// An own character as lists, search, study and worksheets take it: its lines as they are carved, its
/// readings (katakana counts as on'yomi), its meanings and its name as English ones, and its parts. A name of
/// one letter counts as a part, so that an own 永 is found by 永.
[[nodiscard]] kanji::Character kanji_character(const OwnCharacter& character, char32_t code_point);

/// The kept character whose form a character of a database has, if it is not a published form.
[[nodiscard]] std::optional<char32_t> kept_form_of(const kanji::Character& character);

/// A character of a collection, without the hand's layer.
struct KeptCharacter {
  char32_t code_point = 0;  ///< kanji::is_own()
  std::filesystem::path file;
  OwnCharacter character;
  /// The published character that it replaces. None where it stands beside all others, and where one
  /// that comes before it is used in that place already.
  std::optional<char32_t> instead_of;
};

/// Whether a new character may have the name of one that is kept.
enum class SameName : std::uint8_t {
  refuse,  ///< it is not kept, and the caller can ask
  beside,  ///< both are kept
};

/// All that could be read of a collection, and what could not.
struct CollectionContent {
  std::vector<KeptCharacter> characters;  ///< by name, then code point
  std::vector<base::Error> unread;        ///< one for each file that is damaged
};

/// The own characters that are shown, searched, studied and printed like any other: a folder with one .nazori
/// file for each, named by its code point ("U+F1A2B.nazori"). A character keeps its code point, by which
/// study remembers it, for as long as it is kept, also when it is changed. The code point follows from the
/// name, so that another computer most often gives a character of this name the same one. If several
/// replace the same published character, the one that was kept last does. Thread rules: any
/// thread, and any number of programs at once: what changes the folder waits for others that do. Not for the
/// servo thread.
class Collection {
 public:
  /// NAZORI_CHARACTERS, else characters/ in base::user_data_folder(); empty where there is neither, or where
  /// the variable is set and empty: then there is no collection.
  [[nodiscard]] static std::filesystem::path usual_folder();

  /// @param folder  need not exist. Empty: a collection that is empty and keeps nothing.
  explicit Collection(std::filesystem::path folder) : folder_(std::move(folder)) {}
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Reads every character. A folder that does not exist is an empty collection.
  /// @return Errc::io where the folder cannot be read.
  [[nodiscard]] base::Result<CollectionContent> read() const;

  /// One character with all of it. @return Errc::not_found; the errors of load_character().
  [[nodiscard]] base::Result<OwnCharacter> find(char32_t code_point) const;

  /// What is said about one, without reading its relief. @return the errors of load_character().
  [[nodiscard]] base::Result<Facts> facts(char32_t code_point) const;

  /// Keeps a character. If another one replaced the same published character, that one then stands beside it.
  /// @param as  the code point of a kept character that it replaces; none: it is a new one.
  /// @param same_name  of a new one.
  /// @return its code point; Errc::bad_argument for a character without name or strokes and for `as` that is
  /// no own code point; Errc::in_use where its name is refused, and where another program writes for longer
  /// than two seconds; Errc::io; the errors of save_character().
  [[nodiscard]] base::Result<char32_t> keep(const OwnCharacter& character, std::optional<char32_t> as = {},
                                            SameName same_name = SameName::beside) const;

  /// Takes a character out of the collection: its file gets the ending .removed beside it, and an older one
  /// of that name is replaced, so that the last removal can be taken back by hand.
  /// @return Errc::not_found, Errc::io, Errc::in_use as keep().
  [[nodiscard]] base::Result<void> remove(char32_t code_point) const;

  /// The kept characters with a name. @return the errors of read().
  [[nodiscard]] base::Result<std::vector<char32_t>> named(const std::string& name) const;

  /// The file in which a character is or would be kept.
  [[nodiscard]] std::filesystem::path file_of(char32_t code_point) const;
  /// What a file of the collection keeps; none for any other file. Does not look at the disk.
  [[nodiscard]] std::optional<char32_t> code_point_of(const std::filesystem::path& file) const;

  /// Changes whenever a character is kept, changed or removed, also by another program; equal where nothing
  /// has happened. Takes microseconds.
  [[nodiscard]] std::filesystem::file_time_type changed_at() const;

 private:
  [[nodiscard]] base::Result<base::FileLock> lock() const;
  void note_change(std::filesystem::file_time_type before) const;
  [[nodiscard]] base::Result<char32_t> free_place(const OwnCharacter& character) const;
  [[nodiscard]] base::Result<void> free_published(char32_t instead_of, char32_t but) const;

  std::filesystem::path folder_;
};

/// kanji.db with the characters of a collection, some of them instead of published ones.
/// @param unread  gets what could not be read of the collection; those characters are left out.
/// @return the errors of KanjiDatabase::open().
[[nodiscard]] base::Result<kanji::KanjiDatabase> open_with_own(const std::filesystem::path& database,
                                                               const Collection& collection,
                                                               std::vector<base::Error>* unread = nullptr);

}  // namespace nazori::author
