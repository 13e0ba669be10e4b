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

/// Extension of a recording: ".nzr". Its layout is described in docs/file-formats.md.
inline constexpr std::string_view kRecordingExtension = ".nzr";
inline constexpr std::size_t kHeaderBytes = 512;
inline constexpr std::size_t kRecordBytes = 152;

/// The metadata of a recording.
struct Session {
  haptics::DeviceDescription device;
  geometry::TabletShape shape;
  double tip_radius_m = 0;    ///< of the ball at the tip of the stylus; 0: a point
  std::string character;      ///< the character or file on the tablet: "休", or a file's name
  std::int64_t start_ns = 0;  ///< since 1970-01-01 00:00 UTC
  /// Random id; also names the ring with the samples that are not in the file yet.
  std::array<std::uint8_t, 16> id{};
};

/// The end of a recording, known once it has been read completely.
struct RecordingEnd {
  std::uint64_t samples = 0;         ///< whole and sound ones
  bool finished = false;             ///< it has the mark of a complete recording
  bool recovered = false;            ///< the recording program crashed; the rest was recovered from memory
  std::uint64_t lost = 0;            ///< ticks lost because the ring was full; only known if it is finished
  std::uint64_t damaged = 0;         ///< records with a wrong checksum; left out
  std::uint64_t trailing_bytes = 0;  ///< bytes of an incomplete record at the end of the file
};

/// The first kHeaderBytes of a recording. Texts that are too long are cut.
[[nodiscard]] std::array<std::uint8_t, kHeaderBytes> encode_header(const Session& session);
/// @param name  of the file, for messages.
/// @return Errc::schema for a file that is not a recording or has a newer version, Errc::parse for a damaged
/// header.
[[nodiscard]] base::Result<Session> decode_header(std::span<const std::uint8_t> bytes,
                                                  const std::string& name);

/// Appends the record of a sample.
void encode_record(const haptics::ServoSample& sample, std::vector<std::uint8_t>& bytes);
/// Appends the record that says that a recording is complete. @param samples  records before it.
void encode_end(std::uint64_t samples, std::uint64_t lost, bool recovered, std::vector<std::uint8_t>& bytes);

/// Reads a recording from its start, in constant memory. Damaged and incomplete records are left out and
/// counted, so that an unfinished file is read to its last complete record. Thread rules: one thread.
class RecordingReader {
 public:
  /// @return the errors of open_source and decode_header.
  [[nodiscard]] static base::Result<RecordingReader> open(const std::filesystem::path& path);
  [[nodiscard]] static base::Result<RecordingReader> from(std::unique_ptr<ByteSource> source);

  [[nodiscard]] const Session& session() const { return session_; }
  /// Reads samples in order. @return how many of `out` were filled, 0 only at the end; Errc::io.
  [[nodiscard]] base::Result<std::size_t> read(std::span<haptics::ServoSample> out);
  /// What is known so far; complete after read() has returned 0.
  [[nodiscard]] const RecordingEnd& end() const { return end_; }
  /// Progress of reading the file, 0..1; 0 where its length is not known.
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
