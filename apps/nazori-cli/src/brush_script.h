// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/brush/replay.h"
#include "nazori/calligraphy/brush_widths.h"
#include "nazori/calligraphy/ruling.h"
#include "nazori/kanji/stroke.h"

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

/// The strokes of a model as a hand writes them: pressed at the start, lifted in a sweep or hook, pressed
/// again at a stop.
[[nodiscard]] std::vector<brush::PenSample> samples_of(const std::vector<kanji::StrokeLine>& lines,
                                                       double side_m);

/// The strokes of a model that have their own widths, written with a brush that makes them as broad.
[[nodiscard]] std::vector<brush::PenSample> samples_of(const std::vector<calligraphy::ModelStroke>& strokes,
                                                       const calligraphy::BrushWidths& widths);

/// Speed of a pen whose times are not known.
inline constexpr double kPlainSpeed_m_s = 0.06;

}  // namespace nazori::cli
