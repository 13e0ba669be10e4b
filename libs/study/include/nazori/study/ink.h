// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/geometry/point.h"

namespace nazori::study {

/// A point of the pen, in steps of 1/32 of a glyph unit, milliseconds and 255ths of full pressure, so that
/// what was kept is exactly what was given.
struct InkPoint {
  static constexpr int kStepsPerUnit = 32;
  static constexpr int kFarthest = 1'000 * kStepsPerUnit;  ///< largest |x| and |y|
  static constexpr int kLatest = 24 * 60 * 60 * 1'000;     ///< largest time
  std::int32_t x = 0;                                      ///< right
  std::int32_t y = 0;                                      ///< down
  std::int32_t time_ms = 0;   ///< since the first point of the ink; never goes back
  std::uint8_t pressure = 0;  ///< 0 where the pen tells none

  friend bool operator==(const InkPoint&, const InkPoint&) = default;
};

using InkStroke = std::vector<InkPoint>;

/// What a learner wrote: strokes in the order they were drawn.
struct Ink {
  std::vector<InkStroke> strokes;

  friend bool operator==(const Ink&, const Ink&) = default;
};

inline constexpr std::size_t kMostInkStrokes = 100;
inline constexpr std::size_t kMostInkPoints = 50'000;

/// A point from the glyph frame, rounded and brought within range. @param pressure 0..1
[[nodiscard]] InkPoint ink_point(geometry::GlyphPoint at, double time_ms, double pressure);
[[nodiscard]] geometry::GlyphPoint position_of(const InkPoint& point);

/// The ink in few bytes (docs/file-formats.md: differences as varints, then DEFLATE); nothing for no strokes.
/// @return Errc::bad_argument for more than may be kept or times that go back.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> pack(const Ink& ink);
/// @return Errc::parse for bytes that pack() does not write.
[[nodiscard]] base::Result<Ink> unpack_ink(std::span<const std::uint8_t> bytes);

/// How the pen moved.
struct PenMotion {
  double speed = 0;       ///< glyph units a second on paper, mean over drawn length
  double smoothness = 0;  ///< spectral arc length, <= 0; nearer to 0 is smoother

  friend bool operator==(const PenMotion&, const PenMotion&) = default;
};

/// nullopt for ink without times or without a stroke that is longer than 2 units and 80 ms.
/// @source S. Balasubramanian, A. Melendez-Calderon, A. Roby-Brami, E. Burdet, "On the analysis of movement
/// smoothness", J. NeuroEng. Rehab. 12:112 (2015): SPARC, cut off at 10 Hz and at 5 % of the largest
/// amplitude; the mean over strokes.
[[nodiscard]] std::optional<PenMotion> motion_of(const Ink& ink);

}  // namespace nazori::study
