// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::surface {

/// A picture of 8-bit sRGB colours: red, green and blue of each pixel, row by row from the top.
struct ColourPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  friend bool operator==(const ColourPicture&, const ColourPicture&) = default;
};

/// An 8-bit RGB PNG that names sRGB. Empty for a picture without pixels or with another number of bytes than
/// its size needs, and where there is not enough memory.
[[nodiscard]] std::vector<std::uint8_t> to_png(const ColourPicture& picture);
/// Written beside and renamed. @return Errc::bad_argument where to_png() has nothing to write.
[[nodiscard]] base::Result<void> save_png(const ColourPicture& picture, const std::filesystem::path& path);

}  // namespace nazori::surface
