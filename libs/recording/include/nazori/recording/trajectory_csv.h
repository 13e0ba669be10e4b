// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/haptics/haptic_device.h"
#include "nazori/recording/byte_source.h"

namespace nazori::recording {

/// The position of a stylus at one moment.
struct TrajectoryPoint {
  double time_s = 0;
  haptics::Vec3 position_m{0, 0, 0};  ///< tablet frame
};

/// Reads the path of a stylus from CSV (RFC 4180): a header that names at least the columns t, x, y and z, in
/// any order and among others, then one row per moment: seconds, and metres in the tablet frame. Numbers as
/// in C, whatever the locale. Lines end in LF or CRLF; a byte order mark, empty lines and fields in double
/// quotes are accepted. The input is streamed: memory does not grow with it. Thread rules: one thread.
class TrajectoryReader {
 public:
  static constexpr std::size_t kLongestLine = 65536;

  /// Reads the header. @param path  "-" is standard input.
  /// @return Errc::parse with "file:line" for a header that lacks or repeats a column, an empty input and a
  /// line longer than kLongestLine; the errors of open_source.
  [[nodiscard]] static base::Result<TrajectoryReader> open(const std::filesystem::path& path);
  [[nodiscard]] static base::Result<TrajectoryReader> from(std::unique_ptr<ByteSource> source);

  /// The next row. @return false at the end; Errc::parse with "file:line" for a row with more or fewer values
  /// than the header, a value that is not a finite number, a time that is not after the previous one, and a
  /// file without any row.
  [[nodiscard]] base::Result<bool> next(TrajectoryPoint& point);

  /// Number of the last line read; the header is line 1.
  [[nodiscard]] std::uint64_t line() const { return line_; }
  /// Progress of reading the input, 0..1; 0 where its length is not known.
  [[nodiscard]] double progress() const;

 private:
  explicit TrajectoryReader(std::unique_ptr<ByteSource> source);
  [[nodiscard]] base::Result<bool> next_line(std::string_view& line);
  [[nodiscard]] base::Result<void> read_header();
  [[nodiscard]] base::Result<void> parse_row(std::string_view row, TrajectoryPoint& point) const;
  [[nodiscard]] tl::unexpected<base::Error> wrong(std::string what, std::string remedy = {}) const;

  std::unique_ptr<ByteSource> source_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // range that is not read yet
  bool exhausted_ = false;
  std::uint64_t line_ = 0, rows_ = 0, bytes_ = 0;
  std::vector<int> meaning_;  // of each column: 0..3 for t, x, y, z; -1: ignored
  double last_s_ = 0;
};

}  // namespace nazori::recording
