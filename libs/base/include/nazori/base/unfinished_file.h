// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>

namespace nazori::base {

/// What may lie beside an unfinished file.
enum class UnfinishedKind : std::uint8_t {
  plain,    ///< nothing
  database  ///< the journals of SQLite: "-journal", "-wal", "-shm"
};

/// A file that is only half there while this object lives, such as one that is written under another name
/// first. It is removed when the object goes before finish(), and by remove_unfinished_files() when the
/// program has to end at once. A folder is removed where it is empty by then. Thread rules: one object by one
/// thread at a time, several objects by several threads.
class UnfinishedFile {
 public:
  /// No file.
  UnfinishedFile() = default;
  /// Notes a file that is made later, or was made already.
  explicit UnfinishedFile(std::filesystem::path path, UnfinishedKind kind = UnfinishedKind::plain);
  /// Notes the file that `make` makes, so that there is no moment between the two.
  /// @param make  returns its path, an empty one where it made none.
  [[nodiscard]] static UnfinishedFile made_by(const std::function<std::filesystem::path()>& make);

  UnfinishedFile(UnfinishedFile&& other) noexcept;
  UnfinishedFile& operator=(UnfinishedFile&& other) noexcept;
  ~UnfinishedFile();

  /// The file is whole, or has another name now: it stays.
  void finish() noexcept;

 private:
  std::uint64_t id_ = 0;
};

/// Removes every unfinished file of the program, the one noted last first. For the moment before it ends: no
/// file can be noted while the result lives.
[[nodiscard]] std::unique_lock<std::timed_mutex> remove_unfinished_files();

}  // namespace nazori::base
