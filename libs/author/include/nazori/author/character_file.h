// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/author/own_character.h"
#include "nazori/base/result.h"

namespace nazori::author {

/// Largest document, and largest one unpacked [bytes].
inline constexpr std::size_t kLargestFile = std::size_t{64} << 20;
inline constexpr std::size_t kLargestUnpacked = std::size_t{300} << 20;

/// What of a document is read.
enum class FileParts : std::uint8_t {
  all,
  without_relief,  ///< no hand's layer, which may be most of the file
};

/// A character as the bytes of a .nazori file (docs/file-formats.md). The same character gives the same
/// bytes, and reading them gives the same character, to the last bit.
/// @return the errors of validate().
[[nodiscard]] base::Result<std::vector<std::uint8_t>> to_bytes(const OwnCharacter& character);
/// @return Errc::parse for what is not such a file, is damaged or exceeds a limit; Errc::schema for a newer
/// version. Members that are not known are passed over.
[[nodiscard]] base::Result<OwnCharacter> parse_character(std::span<const std::uint8_t> bytes,
                                                         FileParts parts = FileParts::all);
[[nodiscard]] base::Result<void> save_character(const OwnCharacter& character,
                                                const std::filesystem::path& path);
[[nodiscard]] base::Result<OwnCharacter> load_character(const std::filesystem::path& path,
                                                        FileParts parts = FileParts::all);

/// The strokes, parts and numbers as an SVG in the manner of KanjiVG, with the groove in attributes of its
/// own: parse_strokes_svg() reads back the same strokes and parts.
[[nodiscard]] std::string to_strokes_svg(const OwnCharacter& character);
/// Reads such an SVG, or one of KanjiVG. Where a file does not give the groove, it is that of a brush, whose
/// endings are read from kvg:type, so far as it says one. Rights, name and parts are read; the rest of the
/// facts is empty.
/// @return Errc::parse for what is not such a file or exceeds the limits.
[[nodiscard]] base::Result<OwnCharacter> parse_strokes_svg(std::string_view svg);

/// Kinds of files that a character is written to and read from.
enum class CharacterFormat : std::uint8_t {
  document,  ///< .nazori: all of it
  svg,       ///< strokes and parts
  strokes,   ///< .str: centre lines on a grid
  raw,       ///< the relief in 8 bits
  png,       ///< the relief in 16 bits
};
/// By the ending of a name (.nazori, .svg, .str, .raw, .png, in any case); nothing for others.
[[nodiscard]] std::optional<CharacterFormat> format_of(const std::filesystem::path& path);

/// Writes a character in a format. What the format cannot hold is left out. Written and opened again, the
/// file gives the same bytes.
/// @param size  samples per side of a RAW or PNG; side of the grid of a .str.
/// @return Errc::bad_argument for a format that would be empty: strokes of a character that has none.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> export_character(const OwnCharacter& character,
                                                                       CharacterFormat format, int size);
/// Reads a character in a format. @param grid  side of the grid of a .str or of a RAW; none: guessed.
[[nodiscard]] base::Result<OwnCharacter> import_character(std::span<const std::uint8_t> bytes,
                                                          CharacterFormat format,
                                                          std::optional<int> grid = {});

}  // namespace nazori::author
