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

/// Writes everything. Returns 0 or the error number.
int write_all(int fd, std::span<const std::uint8_t> bytes) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t n = ::write(fd, bytes.data() + written, bytes.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    written += static_cast<std::size_t>(n);
  }
  return 0;
}

}  // namespace

Result<InputFile> InputFile::open(const fs::path& path) {
  // Do not wait for the writer of a pipe: a pipe is refused below.
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd < 0) {
    return fail(errno == ENOENT ? Errc::not_found : Errc::io, "cannot be read: " + reason(errno),
                path.string());
  }
  InputFile file(path.string(), fd, 0);
  struct stat status {};
  if (::fstat(fd, &status) != 0) return fail(Errc::io, reason(errno), path.string());
  if (S_ISDIR(status.st_mode)) return fail(Errc::io, "is a folder, not a file", path.string());
  if (!S_ISREG(status.st_mode)) return fail(Errc::io, "is not a regular file", path.string());
  file.size_ = static_cast<std::uintmax_t>(status.st_size);
  return file;
}

InputFile::InputFile(InputFile&& other) noexcept
    : name_(std::move(other.name_)), fd_(std::exchange(other.fd_, -1)), size_(other.size_) {}

InputFile::~InputFile() {
  if (fd_ >= 0) ::close(fd_);
}

Result<std::size_t> InputFile::read(std::span<std::uint8_t> room) {
  for (;;) {
    const ssize_t count = ::read(fd_, room.data(), room.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) return fail(Errc::io, "cannot be read: " + reason(errno), name_);
  }
}

Result<std::vector<std::uint8_t>> read_file(const fs::path& path, std::size_t max_bytes) {
  auto file = InputFile::open(path);
  if (!file) return tl::unexpected(std::move(file.error()));
  if (file->size() > max_bytes) {
    return fail(Errc::io,
                "has " + std::to_string(file->size()) + " bytes; the limit is " + std::to_string(max_bytes),
                path.string());
  }
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(file->size()));
  std::size_t have = 0;
  while (have < bytes.size()) {
    const auto count = file->read(std::span(bytes).subspan(have));
    if (!count) return tl::unexpected(count.error());
    if (*count == 0) break;
    have += *count;
  }
  bytes.resize(have);
  return bytes;
}

Result<OutputFile> OutputFile::create(const fs::path& path) {
  std::string beside = path.string() + ".XXXXXX";
  int fd = -1;
  int error = 0;
  auto unfinished = UnfinishedFile::made_by([&]() -> fs::path {
    fd = ::mkostemp(beside.data(), O_CLOEXEC);
    error = errno;
    return fd < 0 ? fs::path() : fs::path(beside);
  });
  if (fd < 0) return fail(Errc::io, "cannot be written: " + reason(error), path.string());
  return OutputFile(path, std::move(beside), std::move(unfinished), fd);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      beside_(std::move(other.beside_)),
      unfinished_(std::move(other.unfinished_)),
      fd_(std::exchange(other.fd_, -1)) {}

OutputFile::~OutputFile() {
  if (fd_ >= 0) ::close(fd_);
}

Result<void> OutputFile::refusal(int error_number) const {
  return fail(Errc::io, "cannot be written: " + reason(error_number), path_.string());
}

Result<void> OutputFile::append(std::span<const std::uint8_t> bytes) {
  if (const int error = write_all(fd_, bytes); error != 0) return refusal(error);
  return {};
}

Result<void> OutputFile::append(std::string_view text) {
  return append(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

Result<void> OutputFile::commit() {
  int error = ::fsync(fd_) == 0 ? 0 : errno;
  // mkostemp makes the file private; give a new file the permissions that any other program would.
  struct stat old {};
  const bool replaces = ::stat(path_.c_str(), &old) == 0;
  if (error == 0 && replaces && S_ISDIR(old.st_mode)) error = EISDIR;
  if (error == 0) {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(fd_, replaces ? old.st_mode & 0777U : 0666U & ~mask) != 0) error = errno;
  }
  if (::close(std::exchange(fd_, -1)) != 0 && error == 0) error = errno;
  if (error == 0 && ::rename(beside_.c_str(), path_.c_str()) != 0) error = errno;
  if (error != 0) return refusal(error);
  unfinished_.finish();
  return {};
}

Result<void> write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  auto file = OutputFile::create(path);
  if (!file) return tl::unexpected(std::move(file.error()));
  return file->append(bytes).and_then([&file] { return file->commit(); });
}

Result<void> write_file(const fs::path& path, std::string_view text) {
  return write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

}  // namespace nazori::base
