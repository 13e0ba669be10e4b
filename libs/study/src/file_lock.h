// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <utility>

#include "nazori/base/result.h"

namespace nazori::study {

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
  [[nodiscard]] static base::Result<FileLock> take(const std::filesystem::path& path, bool& is_locked);

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace nazori::study
