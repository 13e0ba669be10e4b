// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "nazori/base/result.h"

namespace nazori::print {

/// A picture on a page: 8-bit sRGB, red, green and blue of each pixel, row by row from the top.
struct PagePicture {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgb;
  double width_mm = 0;  ///< on the page; the height follows
};

/// A PDF with the picture in the middle of a page of A4 (210 x 297 mm), at its real size: every pixel is
/// kept, and printers are asked not to scale the page.
/// @param title  of the document, UTF-8.
/// @return Errc::bad_argument for a picture without pixels, with another number of bytes than its size needs,
/// or that does not fit on the page.
[[nodiscard]] base::Result<std::string> picture_page(const PagePicture& picture, std::string_view title);

}  // namespace nazori::print
