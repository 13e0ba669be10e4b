// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::scan {

/// A photograph or a scan: brightness 0..255, row by row from the top. Not empty.
struct Photo {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;

  [[nodiscard]] std::uint8_t at(int x, int y) const {
    return grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  /// Between pixels; outside, the nearest pixel. Centres of pixels are at whole numbers.
  [[nodiscard]] float sample(double x, double y) const;
};

inline constexpr int kFewestPixels = 64;    ///< a side
inline constexpr int kMostPixels = 20'000;  ///< a side
/// Larger pictures are refused before their pixels are read.
inline constexpr std::size_t kMostPhotoPixels = 120'000'000;

/// A PNG or JPEG picture of any kind, or a drawing in SVG, by its content; colours become grey, transparent
/// parts white. A photograph stands upright as its Exif part says. The longer side of a drawing is 1,024
/// pixels.
/// @return Errc::parse for other files and damaged ones, Errc::schema for a picture of a size that no
/// photograph of a page has. Any bytes are allowed.
[[nodiscard]] base::Result<Photo> parse_photo(std::span<const std::uint8_t> bytes);
/// The same from a file. @return also Errc::not_found, Errc::io.
[[nodiscard]] base::Result<Photo> load_photo(const std::filesystem::path& path);

}  // namespace nazori::scan
