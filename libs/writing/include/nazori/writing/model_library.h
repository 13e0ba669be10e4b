// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/model.h"

namespace nazori::writing {

/// Models of the characters of a database, made when they are first needed and then kept. Not thread-safe,
/// like the database.
class ModelLibrary {
 public:
  /// A character with all its forms, and its lookalikes.
  struct Entry {
    Model model;
    std::vector<Model> lookalikes;
  };

  /// @param database  must outlive the library.
  explicit ModelLibrary(const kanji::KanjiDatabase& database) : database_(&database) {}

  /// @return Errc::not_found for a character that is not in the database or has no strokes. The entry stays
  /// valid as long as the library lives.
  [[nodiscard]] base::Result<const Entry*> find(char32_t character);

 private:
  const kanji::KanjiDatabase* database_;
  std::map<char32_t, Entry> entries_;
};

}  // namespace nazori::writing
