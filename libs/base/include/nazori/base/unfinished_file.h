// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>

namespace nazori::base {

/// Files that may exist next to an unfinished file.
enum class UnfinishedKind : std::uint8_t {
  plain,    ///< nothing
  database  ///< the journals of SQLite: "-journal", "-wal", "-shm"
};

/// Marks a file as incomplete while this object lives, such as one that is written under a temporary name
/// first. The file is removed when this object is destroyed before finish(), and by remove_unfinished_files()
/// when the program has to end at once. A folder is removed where it is empty by then. Thread rules: one
/// object by one thread at a time, several objects by several threads.
class UnfinishedFile {
 public:
  /// No file.
  UnfinishedFile() = default;
  /// Registers a file that will be made later, or was made already.
  explicit UnfinishedFile(std::filesystem::path path, UnfinishedKind kind = UnfinishedKind::plain);
  /// Makes a file with `make` and registers it, without a moment between the two in which the file would not
  /// be removed.
  /// @param make  returns its path, an empty one where it made none.
  [[nodiscard]] static UnfinishedFile made_by(const std::function<std::filesystem::path()>& make);

  UnfinishedFile(UnfinishedFile&& other) noexcept;
  UnfinishedFile& operator=(UnfinishedFile&& other) noexcept;
  ~UnfinishedFile();

  /// The file is complete, or has been renamed: it is no longer removed.
  void finish() noexcept;

 private:
  std::uint64_t id_ = 0;
};

/// While the result lives, remove_unfinished_files() waits, two seconds at most: files are being made that
/// can be registered only when they are there. One thread at a time; others wait.
[[nodiscard]] std::unique_lock<std::timed_mutex> making_files();

/// Removes every unfinished file of the program, the one registered last first. For use just before the
/// program ends: no file can be registered while the result lives.
[[nodiscard]] std::unique_lock<std::timed_mutex> remove_unfinished_files();

}  // namespace nazori::base
