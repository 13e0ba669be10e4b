// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace nazori::base {
namespace {

namespace fs = std::filesystem;

std::string reason(int error_number) { return std::generic_category().message(error_number); }

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] int get() const { return fd_; }
  /// Closes now; 0 or the error number.
  int close() {
    const int status = ::close(fd_);
    fd_ = -1;
    return status == 0 ? 0 : errno;
  }

 private:
  int fd_;
};

/// Writes and flushes everything; 0 or the error number.
int write_all(int fd, std::span<const std::uint8_t> bytes) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t n = ::write(fd, bytes.data() + written, bytes.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    written += static_cast<std::size_t>(n);
  }
  return ::fsync(fd) == 0 ? 0 : errno;
}

}  // namespace

Result<std::vector<std::uint8_t>> read_file(const fs::path& path, std::size_t max_bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) {
    return fail(errno == ENOENT ? Errc::not_found : Errc::io, "cannot be read: " + reason(errno),
                path.string());
  }
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return fail(Errc::io, reason(errno), path.string());
  if (S_ISDIR(status.st_mode)) return fail(Errc::io, "is a folder, not a file", path.string());
  if (!S_ISREG(status.st_mode)) return fail(Errc::io, "is not a regular file", path.string());
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > max_bytes) {
    return fail(
        Errc::io,
        "has " + std::to_string(size) + " bytes, at most " + std::to_string(max_bytes) + " are allowed",
        path.string());
  }
  std::vector<std::uint8_t> bytes(size);
  std::size_t have = 0;
  while (have < size) {
    const ssize_t n = ::read(file.get(), bytes.data() + have, size - have);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return fail(Errc::io, "cannot be read: " + reason(errno), path.string());
    if (n == 0) break;
    have += static_cast<std::size_t>(n);
  }
  bytes.resize(have);
  return bytes;
}

Result<void> write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  std::string beside = path.string() + ".XXXXXX";
  Descriptor file(::mkostemp(beside.data(), O_CLOEXEC));
  if (file.get() < 0) return fail(Errc::io, "cannot be written: " + reason(errno), path.string());
  int error = write_all(file.get(), bytes);
  // mkostemp makes the file private; a new file gets the permissions any other program would give it.
  struct stat old {};
  const bool replaces = ::stat(path.c_str(), &old) == 0;
  if (error == 0 && replaces && S_ISDIR(old.st_mode)) error = EISDIR;
  if (error == 0) {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(file.get(), replaces ? old.st_mode & 0777U : 0666U & ~mask) != 0) error = errno;
  }
  if (error == 0) error = file.close();
  if (error == 0 && ::rename(beside.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(beside.c_str());
    return fail(Errc::io, "cannot be written: " + reason(error), path.string());
  }
  return {};
}

Result<void> write_file(const fs::path& path, std::string_view text) {
  return write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

}  // namespace nazori::base
