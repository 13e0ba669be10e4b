// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "nazori/scan/picture.h"

namespace nazori::scan {

/// How a camera was held, as the Exif part of a JPEG file says: 1 upright, 2 to 8 turned or mirrored. 1 also
/// where the file does not say. Any bytes are allowed.
/// @source Exif 2.3, tag 0x0112.
[[nodiscard]] int exif_orientation(std::span<const std::uint8_t> jpeg);

/// The picture as it is meant to be seen. @param orientation  1..8.
[[nodiscard]] Photo upright(Photo photo, int orientation);

}  // namespace nazori::scan
