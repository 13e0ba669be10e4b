// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <utility>

#include "nazori/base/result.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::practice {

/// Where characters come from.
struct CharacterSource {
  std::filesystem::path database;  ///< kanji.db
  std::filesystem::path own;       ///< folder of the characters that people made; empty: none are taken

  CharacterSource() = default;
  /// A database alone is a source, too.
  CharacterSource(std::filesystem::path kanji_db, std::filesystem::path own_characters = {})
      : database(std::move(kanji_db)), own(std::move(own_characters)) {}
};

/// kanji.db together with the characters that people made; opened when it is first looked into, and again
/// whenever one of those was kept, changed or removed. Thread rules: one thread at a time.
class CharacterBook {
 public:
  explicit CharacterBook(CharacterSource source) : source_(std::move(source)) {}

  /// To be called before each use. Takes microseconds where nothing has changed.
  /// @return whether database() is another one than before, so that what was made from it must be made again;
  /// the errors of KanjiDatabase::open(): then there is none, and the next call tries again.
  [[nodiscard]] base::Result<bool> look();

  /// nullptr before look(), and where it failed. The object stays at its place for as long as this one lives.
  [[nodiscard]] const kanji::KanjiDatabase* database() const { return database_ ? &*database_ : nullptr; }
  [[nodiscard]] const CharacterSource& source() const { return source_; }

 private:
  CharacterSource source_;
  std::optional<kanji::KanjiDatabase> database_;
  std::filesystem::file_time_type own_of_{};
};

}  // namespace nazori::practice
