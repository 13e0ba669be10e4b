// SPDX-License-Identifier: Apache-2.0
#include "file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace nazori::study {

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

base::Result<FileLock> FileLock::take(const std::filesystem::path& path, bool& is_locked) {
  is_locked = false;
  FileLock lock(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (lock.descriptor_ < 0) {
    return base::fail(base::Errc::io, "cannot be written: " + std::generic_category().message(errno),
                      path.parent_path().string(), "check the permissions of the folder");
  }
  while (::flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    is_locked = errno == EWOULDBLOCK;
    return base::fail(base::Errc::io, "cannot be locked: " + std::generic_category().message(errno),
                      path.string());
  }
  return lock;
}

}  // namespace nazori::study
