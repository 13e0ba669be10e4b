// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "nazori/base/result.h"
#include "nazori/scan/picture.h"

namespace nazori::scan {

/// Whether a file looks like a drawing in SVG.
[[nodiscard]] bool is_svg(std::span<const std::uint8_t> bytes);

/// A drawing on white paper, its longer side kSvgPixels long. Nothing that it refers to outside itself is
/// read.
/// @return Errc::parse for what cannot be drawn.
[[nodiscard]] base::Result<Photo> parse_svg(std::span<const std::uint8_t> bytes);
inline constexpr int kSvgPixels = 1024;

}  // namespace nazori::scan
