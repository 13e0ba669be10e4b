// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/geometry/frames.h"
#include "nazori/haptics/haptic_device.h"
#include "nazori/haptics/servo.h"
#include "nazori/recording/byte_source.h"

namespace nazori::recording {

/// Extension of a recording: ".nzr". Its layout stands in docs/file-formats.md.
inline constexpr std::string_view kRecordingExtension = ".nzr";
inline constexpr std::size_t kHeaderBytes = 512;
inline constexpr std::size_t kRecordBytes = 152;

/// What a recording says of itself.
struct Session {
  haptics::DeviceDescription device;
  geometry::TabletShape shape;
  std::string character;      ///< what lay on the desk: "休", or a file's name
  std::int64_t start_ns = 0;  ///< since 1970-01-01 00:00 UTC
  /// Random; also names the ring that holds what is not in the file yet.
  std::array<std::uint8_t, 16> id{};
};

/// How a recording ends, known once it has been read to its end.
struct RecordingEnd {
  std::uint64_t samples = 0;         ///< whole and sound ones
  bool finished = false;             ///< it says itself that it is complete
  bool recovered = false;            ///< the program that recorded died; the rest was brought in from memory
  std::uint64_t lost = 0;            ///< ticks for which the ring had no room; only where it is finished
  std::uint64_t damaged = 0;         ///< records whose checksum is wrong; left out
  std::uint64_t trailing_bytes = 0;  ///< of a record that was cut off at the end of the file
};

/// The first kHeaderBytes of a recording. Texts that are too long are cut.
[[nodiscard]] std::array<std::uint8_t, kHeaderBytes> encode_header(const Session& session);
/// @param name  of the file, for messages.
/// @return Errc::schema for what is no recording or of a version to come, Errc::parse for a damaged header.
[[nodiscard]] base::Result<Session> decode_header(std::span<const std::uint8_t> bytes,
                                                  const std::string& name);

/// Appends the record of a sample.
void encode_record(const haptics::ServoSample& sample, std::vector<std::uint8_t>& bytes);
/// Appends the record that says that a recording is complete. @param samples  records before it.
void encode_end(std::uint64_t samples, std::uint64_t lost, bool recovered, std::vector<std::uint8_t>& bytes);

/// Reads a recording from its start, in constant memory. What is damaged or cut off is left out and counted,
/// so that a file that broke off is read to its last whole record. Thread rules: one thread.
class RecordingReader {
 public:
  /// @return the errors of open_source and decode_header.
  [[nodiscard]] static base::Result<RecordingReader> open(const std::filesystem::path& path);
  [[nodiscard]] static base::Result<RecordingReader> from(std::unique_ptr<ByteSource> source);

  [[nodiscard]] const Session& session() const { return session_; }
  /// Samples in order. @return how many of `out` were filled, 0 only at the end; Errc::io.
  [[nodiscard]] base::Result<std::size_t> read(std::span<haptics::ServoSample> out);
  /// What is known so far; complete after read() has given 0.
  [[nodiscard]] const RecordingEnd& end() const { return end_; }
  /// How far the file has been read, 0..1; 0 where its length is not known.
  [[nodiscard]] double progress() const;

 private:
  explicit RecordingReader(std::unique_ptr<ByteSource> source);
  [[nodiscard]] base::Result<void> fill(std::size_t wanted);

  std::unique_ptr<ByteSource> source_;
  Session session_;
  RecordingEnd end_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, filled_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace nazori::recording
