// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "nazori/haptics/sample_ring.h"
#include "nazori/recording/recording_file.h"

namespace nazori::recording {

/// A recording that grows at its end. Thread rules: one thread at a time.
class RecordingOutput {
 public:
  enum class Ending { regular, recovered };

  /// A recording with its header and no records yet, in the place of whatever was at `path`: until the header
  /// is whole the old file stands.
  [[nodiscard]] static base::Result<RecordingOutput> create(const std::filesystem::path& path,
                                                            const Session& session);
  /// Goes on with one that broke off; half a record at its end is cut off.
  [[nodiscard]] static base::Result<RecordingOutput> reopen(const std::filesystem::path& path);
  /// Its last record says that it is complete.
  [[nodiscard]] static bool is_complete(const std::filesystem::path& path);

  RecordingOutput(RecordingOutput&& other) noexcept;
  RecordingOutput& operator=(RecordingOutput&&) = delete;
  ~RecordingOutput();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::uint64_t records() const { return records_; }

  /// Appends what is in the ring and then tells the ring that it is safe.
  /// @return Errc::io, the file then ending with a whole record.
  [[nodiscard]] base::Result<void> take(haptics::SampleRing& ring);
  /// As far as the disk.
  void flush() const;
  /// Appends the end and closes the file.
  [[nodiscard]] base::Result<void> close(std::uint64_t lost, Ending ending);

 private:
  RecordingOutput(std::filesystem::path path, int fd, std::uint64_t records);
  [[nodiscard]] base::Result<void> append();

  std::filesystem::path path_;
  int fd_;
  std::uint64_t records_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace nazori::recording
