// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "nazori/base/result.h"

namespace nazori::ingest {

/// SHA-256 of a file's bytes, hexadecimal.
[[nodiscard]] base::Result<std::string> sha256_of(const std::filesystem::path& path);

/// The whole content of a .gz file; its length and checksum are verified.
/// @return Errc::parse for a file that is not gzip, is cut off or damaged, or grows over `max_bytes`.
[[nodiscard]] base::Result<std::string> read_gzip(const std::filesystem::path& path, std::size_t max_bytes);

/// The text of a file in EUC-JP, as UTF-8.
/// @return Errc::parse with "file:line" for bytes that are not EUC-JP.
[[nodiscard]] base::Result<std::string> read_euc_jp(const std::filesystem::path& path, std::size_t max_bytes);

/// Receives a member of an archive: its path and content. An error ends the reading.
using TakeMember = std::function<base::Result<void>(std::string_view path, std::string content)>;

/// Reads the regular files of a .tgz, in their order, that are in `wanted`; the archive is read to its end
/// and its checksum verified.
/// @return Errc::parse for a file that is not a .tgz, is cut off or damaged, or a wanted member over
/// `max_bytes`.
[[nodiscard]] base::Result<void> read_tgz(const std::filesystem::path& path, std::size_t max_bytes,
                                          const std::function<bool(std::string_view path)>& wanted,
                                          const TakeMember& take);

}  // namespace nazori::ingest
