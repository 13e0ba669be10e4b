// SPDX-License-Identifier: Apache-2.0
#include "recording_output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "nazori/base/file.h"

namespace nazori::recording {
namespace {

using base::Errc;
namespace fs = std::filesystem;

constexpr std::uint64_t kBatch = 2048;

tl::unexpected<base::Error> refusal(const fs::path& path, int error) {
  return base::fail(Errc::io, "cannot be written: " + std::generic_category().message(error), path.string());
}

/// The bytes of the records after the header; the last one may be incomplete.
std::uint64_t whole_records(off_t size) {
  const auto bytes = static_cast<std::uint64_t>(std::max<off_t>(size, 0));
  return bytes <= kHeaderBytes ? 0 : (bytes - kHeaderBytes) / kRecordBytes;
}

off_t offset_of(std::uint64_t record) { return static_cast<off_t>(kHeaderBytes + record * kRecordBytes); }

}  // namespace

RecordingOutput::RecordingOutput(fs::path path, int fd, std::uint64_t records)
    : path_(std::move(path)), fd_(fd), records_(records) {
  bytes_.reserve(kBatch * kRecordBytes);
}

RecordingOutput::RecordingOutput(RecordingOutput&& other) noexcept
    : path_(std::move(other.path_)),
      fd_(std::exchange(other.fd_, -1)),
      records_(other.records_),
      bytes_(std::move(other.bytes_)) {}

RecordingOutput::~RecordingOutput() {
  if (fd_ >= 0) ::close(fd_);
}

base::Result<RecordingOutput> RecordingOutput::create(const fs::path& path, const Session& session) {
  const auto header = encode_header(session);
  if (auto written = base::write_file(path, header); !written)
    return tl::unexpected(std::move(written.error()));
  return reopen(path);
}

base::Result<RecordingOutput> RecordingOutput::reopen(const fs::path& path) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (fd < 0) return refusal(path, errno);
  RecordingOutput output(path, fd, 0);
  struct stat status {};
  if (::fstat(fd, &status) != 0) return refusal(path, errno);
  output.records_ = whole_records(status.st_size);
  if (::ftruncate(fd, offset_of(output.records_)) != 0 || ::lseek(fd, 0, SEEK_END) < 0)
    return refusal(path, errno);
  return output;
}

bool RecordingOutput::is_complete(const fs::path& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return false;
  struct stat status {};
  bool complete = false;
  std::vector<char> last(kRecordBytes);
  std::vector<char> bytes(kHeaderBytes);
  if (::fstat(fd, &status) == 0 && whole_records(status.st_size) > 0 &&
      ::pread(fd, bytes.data(), kHeaderBytes, 0) == static_cast<ssize_t>(kHeaderBytes) &&
      ::pread(fd, last.data(), kRecordBytes, offset_of(whole_records(status.st_size) - 1)) ==
          static_cast<ssize_t>(kRecordBytes)) {
    bytes.insert(bytes.end(), last.begin(), last.end());
    auto reader = RecordingReader::from(memory_source({bytes.data(), bytes.size()}, path.string()));
    haptics::ServoSample sample;
    complete = reader && reader->read(std::span(&sample, 1)) && reader->end().finished;
  }
  ::close(fd);
  return complete;
}

base::Result<void> RecordingOutput::append() {
  std::size_t written = 0;
  while (written < bytes_.size()) {
    const ssize_t n = ::write(fd_, bytes_.data() + written, bytes_.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int error = errno;
      records_ += written / kRecordBytes;
      (void)(::ftruncate(fd_, offset_of(records_)) == 0);
      return refusal(path_, error);
    }
    written += static_cast<std::size_t>(n);
  }
  records_ += written / kRecordBytes;
  return {};
}

base::Result<void> RecordingOutput::take(haptics::SampleRing& ring) {
  std::uint64_t next = ring.taken.load(std::memory_order_relaxed);
  const std::uint64_t pushed = ring.pushed.load(std::memory_order_acquire);
  while (next < pushed) {
    const std::uint64_t batch = std::min(pushed - next, kBatch);
    bytes_.clear();
    for (std::uint64_t i = next; i < next + batch; ++i)
      encode_record(ring.slots[i % haptics::SampleRing::kCapacity], bytes_);
    if (auto done = append(); !done) return done;
    next += batch;
    ring.taken.store(next, std::memory_order_release);
  }
  return {};
}

void RecordingOutput::flush() const { (void)::fdatasync(fd_); }

base::Result<void> RecordingOutput::close(std::uint64_t lost, Ending ending) {
  bytes_.clear();
  encode_end(records_, lost, ending == Ending::recovered, bytes_);
  if (auto done = append(); !done) return done;
  int error = ::fsync(fd_) == 0 ? 0 : errno;
  if (::close(std::exchange(fd_, -1)) != 0 && error == 0) error = errno;
  if (error != 0) return refusal(path_, error);
  return {};
}

}  // namespace nazori::recording
