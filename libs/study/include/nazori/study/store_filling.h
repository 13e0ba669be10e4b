// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include "nazori/study/learner_store.h"

namespace SQLite {
class Database;
}

namespace nazori::study {

/// Receives all data of a learner, piece by piece, and checks that they are consistent.
class LearnerStore::Filling {
 public:
  /// Only checks.
  Filling();
  /// Also writes it into the tables of an empty store. add() and the similar functions then throw
  /// SQLite::Exception.
  explicit Filling(SQLite::Database& db);
  ~Filling();
  Filling(const Filling&) = delete;
  Filling& operator=(const Filling&) = delete;

  /// The next entry of the log. @param packed_ink  of a writing; empty where none was saved.
  /// @return Errc::bad_argument where it is inconsistent with the previous entries.
  [[nodiscard]] base::Result<void> add(const LogEntry& entry, std::span<const std::uint8_t> packed_ink);
  /// @return Errc::bad_argument for an invalid name.
  [[nodiscard]] base::Result<void> add_list(const CustomList& list);
  [[nodiscard]] base::Result<void> add_tag(const std::string& tag, std::span<const char32_t> characters);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace nazori::study
