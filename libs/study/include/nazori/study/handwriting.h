// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/geometry/written_stroke.h"

namespace nazori::study {

/// What a learner wrote, as it is saved with a review: strokes in the order they were drawn, with times since
/// the first point, which never decrease, and with pressures. The lean of the pen is not saved.
using Handwriting = geometry::WrittenStrokes<geometry::GlyphFrame>;
using HandwritingStroke = geometry::WrittenStroke<geometry::GlyphFrame>;
using HandwritingPoint = geometry::WrittenPoint<geometry::GlyphFrame>;

/// Positions are saved in steps of 1/32 glyph unit, times in milliseconds, pressures in 255ths.
inline constexpr int kSavedStepsPerUnit = 32;
inline constexpr double kFarthestSaved = 1'000;         ///< largest |x| and |y| [glyph units]
inline constexpr double kLatestSaved_s = 24 * 60 * 60;  ///< largest time
inline constexpr std::size_t kMostSavedStrokes = 100;
inline constexpr std::size_t kMostSavedPoints = 50'000;

/// The point as it is read back after saving: rounded to the steps above and limited to the range. An unknown
/// time or pressure becomes 0.
[[nodiscard]] HandwritingPoint saved_point(const HandwritingPoint& point);

/// Handwriting in few bytes (docs/file-formats.md: differences as varints, then DEFLATE), rounded as by
/// saved_point(); empty without strokes.
/// @return Errc::bad_argument for too many strokes or points, points out of range or decreasing times.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> pack(const Handwriting& ink);
/// @return Errc::parse for bytes that pack() would not write.
[[nodiscard]] base::Result<Handwriting> unpack_handwriting(std::span<const std::uint8_t> bytes);

/// How the pen moved.
struct PenMotion {
  double speed = 0;       ///< glyph units per second on paper, mean over drawn length
  double smoothness = 0;  ///< spectral arc length, <= 0; closer to 0 is smoother

  friend bool operator==(const PenMotion&, const PenMotion&) = default;
};

/// Measured on its saved form. nullopt for handwriting without times or without a stroke that is longer than
/// 2 units and 80 ms.
/// @source S. Balasubramanian, A. Melendez-Calderon, A. Roby-Brami, E. Burdet, "On the analysis of movement
/// smoothness", J. NeuroEng. Rehab. 12:112 (2015): SPARC, cut off at 10 Hz and at 5 % of the largest
/// amplitude; the mean over strokes.
[[nodiscard]] std::optional<PenMotion> motion_of(const Handwriting& ink);

}  // namespace nazori::study
