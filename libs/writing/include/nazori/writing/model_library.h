// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/model.h"

namespace nazori::writing {

/// Models of the characters of a database, made when they are first asked for and then kept.
/// Not thread-safe, as the database is not.
class ModelLibrary {
 public:
  /// A character with all its forms, and those it must not be taken for.
  struct Entry {
    Model model;
    std::vector<Model> lookalikes;
  };

  /// @param database  must outlive the library.
  explicit ModelLibrary(const kanji::KanjiDatabase& database) : database_(&database) {}

  /// @return Errc::not_found for a character that the database does not have or does not draw. The entry
  /// stays where it is for as long as the library lives.
  [[nodiscard]] base::Result<const Entry*> find(char32_t character);

 private:
  const kanji::KanjiDatabase* database_;
  std::map<char32_t, Entry> entries_;
};

}  // namespace nazori::writing
