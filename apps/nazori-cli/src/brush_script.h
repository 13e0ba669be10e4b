// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/brush/pen.h"

namespace nazori::cli {

/// What a brush replays.
struct BrushScript {
  std::vector<brush::PenSample> samples;  ///< times ascend; in metres on the sheet
  std::optional<char32_t> character;      ///< that handwriting names
};

/// Reads a trajectory (.csv, docs/file-formats.md) or one object of handwriting (.json). A trajectory keeps
/// its metres. The box of handwriting becomes a square of `side_m` in the middle of the sheet. Handwriting
/// without times is written at kPlainSpeed_m_s.
/// @return Errc::parse or Errc::bad_argument; each names the file.
[[nodiscard]] base::Result<BrushScript> read_brush_script(const std::string& file, double side_m);

/// Speed of a pen whose times are not known.
inline constexpr double kPlainSpeed_m_s = 0.06;

}  // namespace nazori::cli
