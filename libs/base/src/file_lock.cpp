// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <thread>

namespace nazori::base {

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<FileLock> FileLock::take(const std::filesystem::path& path, bool& is_locked) {
  is_locked = false;
  FileLock lock(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (lock.descriptor_ < 0) {
    return fail(Errc::io, "cannot be written: " + std::generic_category().message(errno),
                path.parent_path().string(), "check the permissions of the folder");
  }
  while (::flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    is_locked = errno == EWOULDBLOCK;
    return fail(Errc::io, "cannot be locked: " + std::generic_category().message(errno), path.string());
  }
  return lock;
}

Result<FileLock> FileLock::wait(const std::filesystem::path& path, std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds kStep{5};
  const auto end = std::chrono::steady_clock::now() + patience;
  for (;;) {
    bool is_locked = false;
    auto lock = take(path, is_locked);
    if (!is_locked) return lock;
    if (std::chrono::steady_clock::now() >= end)
      return fail(Errc::in_use, "is being written by another program", path.parent_path().string(),
                  "try again when that has ended");
    std::this_thread::sleep_for(kStep);
  }
}

}  // namespace nazori::base
