// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/base/unfinished_file.h"

namespace nazori::base {

/// A regular file that is read piece by piece, from its beginning. Thread rules: one thread.
class InputFile {
 public:
  /// @return Errc::not_found for a missing file, Errc::io for a folder or a device.
  [[nodiscard]] static Result<InputFile> open(const std::filesystem::path& path);
  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&&) = delete;
  ~InputFile();

  /// Size in bytes when it was opened.
  [[nodiscard]] std::uintmax_t size() const { return size_; }
  /// Reads the next bytes into the beginning of `room`. @return how many; 0 at the end. Errc::io.
  [[nodiscard]] Result<std::size_t> read(std::span<std::uint8_t> room);

 private:
  InputFile(std::string name, int fd, std::uintmax_t size) : name_(std::move(name)), fd_(fd), size_(size) {}
  std::string name_;
  int fd_;
  std::uintmax_t size_;
};

/// The whole content of a regular file.
/// @param max_bytes  a larger file is refused before anything is read.
/// @return Errc::not_found for a missing file, Errc::io for a folder, a device or a file over the limit.
[[nodiscard]] Result<std::vector<std::uint8_t>> read_file(const std::filesystem::path& path,
                                                          std::size_t max_bytes);

/// Writes a file piece by piece, so that readers see either the old content or the new, never a part. The
/// pieces go into a temporary file in the same folder, which commit() flushes to disk and renames to the
/// final name. Without a commit the old file is unchanged and nothing is left behind. Thread rules: one
/// thread.
class OutputFile {
 public:
  [[nodiscard]] static Result<OutputFile> create(const std::filesystem::path& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  [[nodiscard]] Result<void> append(std::span<const std::uint8_t> bytes);
  [[nodiscard]] Result<void> append(std::string_view text);
  /// Call it once, as the last call.
  [[nodiscard]] Result<void> commit();

 private:
  OutputFile(std::filesystem::path path, std::string beside, UnfinishedFile unfinished, int fd)
      : path_(std::move(path)), beside_(std::move(beside)), unfinished_(std::move(unfinished)), fd_(fd) {}
  [[nodiscard]] Result<void> refusal(int error_number) const;

  std::filesystem::path path_;
  std::string beside_;
  UnfinishedFile unfinished_;
  int fd_;
};

/// Writes a file so that readers see either the old content or the new, never a part: it is written to a
/// temporary file in the same folder, flushed to disk, then renamed. On failure the old file is unchanged and
/// nothing is left behind.
[[nodiscard]] Result<void> write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
[[nodiscard]] Result<void> write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace nazori::base
