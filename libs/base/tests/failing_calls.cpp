// SPDX-License-Identifier: Apache-2.0
#include "failing_calls.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

extern "C" {

ssize_t read(int fd, void* to, size_t size) {
  using namespace nazori::base::test;
  if (is_interrupted() || is_refused("read")) return -1;
  CallsToFail* const now = calls_to_fail();
  if (now == nullptr) return ::syscall(SYS_read, fd, to, size);
  const size_t most = std::min({size, now->most_bytes.load(), now->bytes_to_read.load()});
  const ssize_t got = ::syscall(SYS_read, fd, to, most);
  if (got > 0) now->bytes_to_read -= static_cast<size_t>(got);
  return got;
}

ssize_t write(int fd, const void* from, size_t size) {
  using namespace nazori::base::test;
  if (is_interrupted() || is_refused("write")) return -1;
  CallsToFail* const now = calls_to_fail();
  if (now != nullptr && now->empty_writes > 0) {
    --now->empty_writes;
    errno = EIO;  // meaningless, because no call has failed
    return 0;
  }
  const size_t most = now == nullptr ? size : std::min(size, now->most_bytes.load());
  return ::syscall(SYS_write, fd, from, most);
}

int fsync(int fd) {
  if (nazori::base::test::is_refused("fsync")) return -1;
  return static_cast<int>(::syscall(SYS_fsync, fd));
}

int fdatasync(int fd) {
  if (auto* const now = nazori::base::test::calls_to_fail().load()) ++now->flushes;
  return static_cast<int>(::syscall(SYS_fdatasync, fd));
}

int ftruncate(int fd, off_t length) noexcept {
  if (nazori::base::test::is_refused("ftruncate")) return -1;
  return static_cast<int>(::syscall(SYS_ftruncate, fd, length));
}

off_t lseek(int fd, off_t to, int whence) noexcept {
  if (nazori::base::test::is_refused("lseek")) return -1;
  return ::syscall(SYS_lseek, fd, to, whence);
}

/// These functions return their error and leave errno alone.
int posix_fallocate(int fd, off_t from, off_t length) {
  const int before = errno;
  if (nazori::base::test::is_refused("posix_fallocate")) return std::exchange(errno, before);
  return ::syscall(SYS_fallocate, fd, 0, from, length) == 0 ? 0 : std::exchange(errno, before);
}

int flock(int fd, int operation) noexcept {
  if (nazori::base::test::is_refused("flock")) return -1;
  return static_cast<int>(::syscall(SYS_flock, fd, operation));
}

ssize_t getrandom(void* to, size_t size, unsigned flags) {
  if (nazori::base::test::is_refused("getrandom")) return -1;
  return ::syscall(SYS_getrandom, to, size, flags);
}

int fchmod(int fd, mode_t mode) noexcept {
  if (nazori::base::test::is_refused("fchmod")) return -1;
  return static_cast<int>(::syscall(SYS_fchmod, fd, mode));
}

int fstat(int fd, struct stat* status) noexcept {
  if (nazori::base::test::is_refused("fstat")) return -1;
  return ::fstatat(fd, "", status, AT_EMPTY_PATH);
}

/// A close that fails has closed the file nevertheless.
int close(int fd) {
  const int done = static_cast<int>(::syscall(SYS_close, fd));
  return nazori::base::test::is_refused("close") ? -1 : done;
}

int rename(const char* from, const char* to) noexcept {
  if (auto* const now = nazori::base::test::calls_to_fail().load()) ++now->renames;
  if (nazori::base::test::is_refused("rename")) return -1;
  return ::renameat(AT_FDCWD, from, AT_FDCWD, to);
}

}  // extern "C"
