// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "nazori/base/result.h"

namespace nazori::recording {

/// Bytes in order, from a file, standard input or memory; never more of them in memory than the reader
/// requests. Thread rules: one thread.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Fills `out` from its start. @return the number of bytes read, 0 only at the end.
  [[nodiscard]] virtual base::Result<std::size_t> read(std::span<char> out) = 0;
  /// Total length, 0 where it is not known (a pipe).
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// For messages: the file's name, "standard input".
  [[nodiscard]] virtual const std::string& name() const = 0;
};

/// @param path  "-" is standard input.
/// @return Errc::not_found for a missing file, Errc::io for a folder and without permission to read.
[[nodiscard]] base::Result<std::unique_ptr<ByteSource>> open_source(const std::filesystem::path& path);

/// Bytes in memory, which must outlive the source.
[[nodiscard]] std::unique_ptr<ByteSource> memory_source(std::string_view bytes, std::string name);

}  // namespace nazori::recording
