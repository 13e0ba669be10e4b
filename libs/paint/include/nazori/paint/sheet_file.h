// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/paint/sheet.h"

namespace nazori::paint {

/// A sheet and the ink in the brush, as a file of Nazori (.nzs): docs/file-formats.md, "Sheet of paper".
struct SavedSheet {
  Sheet sheet;
  InkLoad load;
  std::vector<std::uint8_t> attached = {};
};

/// What may be attached to a sheet [bytes].
inline constexpr std::size_t kMostAttached = std::size_t{32} << 20U;

/// The bytes of a file. Reading them gives the same sheet in every bit, wet as it is. @param attached  what
/// another room keeps with the sheet; this one only packs it. At most kMostAttached.
[[nodiscard]] std::vector<std::uint8_t> to_bytes(const Sheet& sheet, const InkLoad& load,
                                                 std::span<const std::uint8_t> attached = {});
/// @return Errc::parse for what is no whole file or has a value outside its range, Errc::schema for a file of
/// a newer version.
[[nodiscard]] base::Result<SavedSheet> parse_sheet(std::span<const std::uint8_t> bytes);
/// Written beside and renamed. Errors name the file.
[[nodiscard]] base::Result<void> save_sheet(const Sheet& sheet, const InkLoad& load,
                                            const std::filesystem::path& path,
                                            std::span<const std::uint8_t> attached = {});
/// Files of at most 64 MiB.
[[nodiscard]] base::Result<SavedSheet> load_sheet(const std::filesystem::path& path);

}  // namespace nazori::paint
