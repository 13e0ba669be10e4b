// SPDX-License-Identifier: Apache-2.0
#include "shared_ring.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

namespace nazori::recording {
namespace {

using base::Errc;
using haptics::SampleRing;

/// At the start of the shared memory; the ring follows.
struct Preamble {
  std::array<char, 8> magic;
  std::uint32_t layout;
  std::uint32_t sample_bytes;
  SessionId id;
};
constexpr std::array<char, 8> kMagic{'N', 'Z', 'R', 'r', 'i', 'n', 'g', '\n'};
// Increase this whenever the meaning of ServoSample changes.
constexpr std::uint32_t kLayout = 1;
constexpr std::size_t kRingAt = 4096;
constexpr std::size_t kBytes = kRingAt + sizeof(SampleRing);

std::string name_of(const SessionId& id) {
  std::string name = "/nazori-";
  for (const std::uint8_t byte : id) name += fmt::format("{:02x}", byte);
  return name + ".ring";
}

std::string reason(int error) { return std::generic_category().message(error); }

void* map(int fd) {
  return ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, fd, 0);
}

}  // namespace

SharedRing::SharedRing(std::string name, int fd, void* memory)
    : name_(std::move(name)),
      fd_(fd),
      memory_(memory),
      ring_(std::launder(reinterpret_cast<SampleRing*>(static_cast<char*>(memory) + kRingAt))) {}

SharedRing::SharedRing(SharedRing&& other) noexcept
    : name_(std::move(other.name_)),
      fd_(std::exchange(other.fd_, -1)),
      memory_(std::exchange(other.memory_, nullptr)),
      ring_(std::exchange(other.ring_, nullptr)) {}

SharedRing::~SharedRing() {
  if (memory_ != nullptr) ::munmap(memory_, kBytes);
  if (fd_ >= 0) ::close(fd_);
}

void SharedRing::remove() const { ::shm_unlink(name_.c_str()); }

base::Result<SharedRing> SharedRing::create(const SessionId& id) {
  const std::string name = name_of(id);
  const int fd = ::shm_open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (fd < 0) return base::fail(Errc::io, "no shared memory: " + reason(errno), name);
  // Lock first, so that no other process mistakes the ring for an abandoned one.
  int error = ::flock(fd, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
  // Fails here if there is no room; otherwise the first push to a missing page would end the program.
  if (error == 0) error = ::posix_fallocate(fd, 0, static_cast<off_t>(kBytes));
  void* memory = error == 0 ? map(fd) : MAP_FAILED;
  if (error == 0 && memory == MAP_FAILED) error = errno;
  if (error != 0) {
    ::shm_unlink(name.c_str());
    ::close(fd);
    return base::fail(Errc::io, "no shared memory to record into: " + reason(error), name,
                      fmt::format("{} MiB are needed", (kBytes >> 20) + 1));
  }
  // Keeps pages from being swapped out. Where the limit on locked memory forbids it, a page that was swapped
  // out can make a tick late, as any other page can.
  (void)::mlock(memory, kBytes);
  const Preamble preamble{kMagic, kLayout, sizeof(haptics::ServoSample), id};
  new (static_cast<char*>(memory) + kRingAt) SampleRing;
  std::memcpy(memory, &preamble, sizeof(preamble));
  return SharedRing(name, fd, memory);
}

base::Result<SharedRing> SharedRing::adopt(const SessionId& id) {
  const std::string name = name_of(id);
  const int fd = ::shm_open(name.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW, 0);
  if (fd < 0) return base::fail(Errc::not_found, "no ring was left behind", name);
  struct stat status {};
  if (::fstat(fd, &status) != 0 || status.st_uid != ::geteuid() ||
      status.st_size != static_cast<off_t>(kBytes)) {
    ::close(fd);
    return base::fail(Errc::schema, "a ring was left behind that this program did not make", name);
  }
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
    ::close(fd);
    return base::fail(Errc::device, "is still being recorded", name);
  }
  void* memory = map(fd);
  if (memory == MAP_FAILED) {
    const int error = errno;
    ::close(fd);
    return base::fail(Errc::io, "cannot be read: " + reason(error), name);
  }
  SharedRing shared(name, fd, memory);
  Preamble preamble{};
  std::memcpy(&preamble, memory, sizeof(preamble));
  if (preamble.magic != kMagic || preamble.layout != kLayout ||
      preamble.sample_bytes != sizeof(haptics::ServoSample) || preamble.id != id) {
    return base::fail(Errc::schema, "a ring was left behind by another version of the program", name);
  }
  return shared;
}

}  // namespace nazori::recording
