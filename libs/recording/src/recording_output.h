// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "nazori/haptics/sample_ring.h"
#include "nazori/recording/recording_file.h"

namespace nazori::recording {

/// A recording to which records are appended. Thread rules: one thread at a time.
class RecordingOutput {
 public:
  enum class Ending { regular, recovered };

  /// Creates a recording with a header and no records in place of any file at `path`; the old file is kept
  /// until the header is complete.
  [[nodiscard]] static base::Result<RecordingOutput> create(const std::filesystem::path& path,
                                                            const Session& session);
  /// Continues an incomplete recording; an incomplete record at its end is cut off.
  [[nodiscard]] static base::Result<RecordingOutput> reopen(const std::filesystem::path& path);
  /// Whether its last record marks it as complete.
  [[nodiscard]] static bool is_complete(const std::filesystem::path& path);

  RecordingOutput(RecordingOutput&& other) noexcept;
  RecordingOutput& operator=(RecordingOutput&&) = delete;
  ~RecordingOutput();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::uint64_t records() const { return records_; }

  /// Appends the content of the ring and then marks it as stored.
  /// @return Errc::io; the file then ends with a complete record.
  [[nodiscard]] base::Result<void> take(haptics::SampleRing& ring);
  /// Flushes the file to the disk.
  void flush() const;
  /// Appends the end record and closes the file.
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
