// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace nazori::recording {
namespace {

using base::Errc;

class DescriptorSource final : public ByteSource {
 public:
  DescriptorSource(int fd, bool owned, std::uint64_t size, std::string name)
      : fd_(fd), owned_(owned), size_(size), name_(std::move(name)) {}
  ~DescriptorSource() override {
    if (owned_) ::close(fd_);
  }
  DescriptorSource(const DescriptorSource&) = delete;
  DescriptorSource& operator=(const DescriptorSource&) = delete;

  base::Result<std::size_t> read(std::span<char> out) override {
    for (;;) {
      const ssize_t n = ::read(fd_, out.data(), out.size());
      if (n >= 0) return static_cast<std::size_t>(n);
      if (errno == EINTR) continue;
      return base::fail(Errc::io, "cannot be read: " + std::generic_category().message(errno), name_);
    }
  }
  [[nodiscard]] std::uint64_t size() const override { return size_; }
  [[nodiscard]] const std::string& name() const override { return name_; }

 private:
  int fd_;
  bool owned_;
  std::uint64_t size_;
  std::string name_;
};

class MemorySource final : public ByteSource {
 public:
  MemorySource(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  base::Result<std::size_t> read(std::span<char> out) override {
    const std::size_t n = bytes_.substr(at_).copy(out.data(), out.size());
    at_ += n;
    return n;
  }
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] const std::string& name() const override { return name_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::string name_;
};

}  // namespace

base::Result<std::unique_ptr<ByteSource>> open_source(const std::filesystem::path& path) {
  const bool standard = path == "-";
  const std::string name = standard ? "standard input" : path.string();
  const int fd = standard ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) {
    return base::fail(errno == ENOENT ? Errc::not_found : Errc::io,
                      "cannot be read: " + std::generic_category().message(errno), name);
  }
  struct stat status {};
  const bool known = ::fstat(fd, &status) == 0;
  const std::uint64_t size =
      known && S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(status.st_size) : 0;
  auto source = std::make_unique<DescriptorSource>(fd, !standard, size, name);
  if (known && S_ISDIR(status.st_mode)) return base::fail(Errc::io, "is a folder, not a file", name);
  return source;
}

std::unique_ptr<ByteSource> memory_source(std::string_view bytes, std::string name) {
  return std::make_unique<MemorySource>(bytes, std::move(name));
}

}  // namespace nazori::recording
