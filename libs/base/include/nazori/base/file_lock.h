// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <utility>

#include "nazori/base/result.h"

namespace nazori::base {

/// A lock on a file that only one process on the computer can have. The system releases it when the process
/// ends, in whatever way.
class FileLock {
 public:
  FileLock() = default;
  FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileLock& operator=(FileLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~FileLock();

  /// Locks `path`, which is created if needed. @return Errc::io; `is_locked` says whether another process has
  /// the lock.
  [[nodiscard]] static Result<FileLock> take(const std::filesystem::path& path, bool& is_locked);
  /// The same, but waits while another process has the lock. Another lock of the same process counts as one
  /// of another process. Thread rules: any thread, but not one that must not wait.
  /// @return Errc::in_use where the other still has it after `patience`; Errc::io.
  [[nodiscard]] static Result<FileLock> wait(const std::filesystem::path& path,
                                             std::chrono::milliseconds patience);

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace nazori::base
