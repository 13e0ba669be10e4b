// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <utility>

#include "nazori/base/result.h"

namespace nazori::study {

/// A lock on a file that only one holder in the whole computer can have. The system gives it back when the
/// holder is gone, however it ended.
class FileLock {
 public:
  FileLock() = default;
  FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileLock& operator=(FileLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~FileLock();

  /// Takes the lock on `path`, made where it is not there. @return Errc::io; `taken` tells whether another
  /// holds it.
  [[nodiscard]] static base::Result<FileLock> take(const std::filesystem::path& path, bool& taken);

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace nazori::study
