// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::archive {

/// A file in a ZIP.
struct ZipMember {
  std::string name;  ///< ASCII, with "/" between folders
  std::vector<std::uint8_t> content;
  friend bool operator==(const ZipMember&, const ZipMember&) = default;
};

/// Makes a ZIP file by file, in memory. The same calls give the same bytes: a file has no time but one that
/// is given, because libarchive would write the hour of the place where it runs. Thread rules: one thread.
class ZipWriter {
 public:
  /// @param level  of compression, 1..9; none: zlib's own.
  /// @param time  of all files, seconds since 1970.
  explicit ZipWriter(std::optional<int> level = {}, std::optional<std::time_t> time = {});
  ~ZipWriter();
  ZipWriter(const ZipWriter&) = delete;
  ZipWriter& operator=(const ZipWriter&) = delete;

  /// Adds a file. A failure is kept until finish().
  void add(std::string_view name, std::span<const std::uint8_t> content);
  void add(std::string_view name, std::string_view content);
  /// The bytes of the ZIP. Call it once, as the last call.
  /// @return Errc::io where libarchive refused something.
  [[nodiscard]] base::Result<std::vector<std::uint8_t>> finish();

 private:
  std::optional<std::time_t> time_;
  bool ok_ = false;
  std::vector<std::uint8_t> bytes_;
  void* zip_;  ///< libarchive's, whose header is not for users of this one
};

/// What a ZIP may cost to read.
struct ZipLimits {
  std::size_t members = 100;
  std::size_t bytes = std::size_t{64} << 20;  ///< of all members together, unpacked
  std::vector<std::string> only = {};         ///< names of the members that are wanted; empty: all
};

/// Unpacks a ZIP in memory. Folders and what is not wanted are left out, and members whose names are not
/// ASCII may be.
/// @return Errc::parse for what is not a ZIP, is damaged (a member's checksum is verified), is encrypted, has
/// two members of one name, or exceeds a limit. Thread-safe: yes.
[[nodiscard]] base::Result<std::vector<ZipMember>> read_zip(std::span<const std::uint8_t> bytes,
                                                            const ZipLimits& limits = {});

}  // namespace nazori::archive
