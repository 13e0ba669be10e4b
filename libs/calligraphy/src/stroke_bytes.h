// SPDX-License-Identifier: Apache-2.0
// The strokes of a sheet as bytes, for its file: docs/file-formats.md, "Sheet of paper".
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/calligraphy/brush_stroke.h"

namespace nazori::calligraphy {

/// Every bit of every point. Empty for no strokes, and for more than a file can hold (hours of writing).
[[nodiscard]] std::vector<std::uint8_t> to_bytes(const std::vector<BrushStroke>& strokes);
/// @return Errc::parse for what to_bytes() does not make, also for values that no brush has.
[[nodiscard]] base::Result<std::vector<BrushStroke>> parse_strokes(std::span<const std::uint8_t> bytes);

}  // namespace nazori::calligraphy
