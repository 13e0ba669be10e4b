// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "nazori/base/result.h"
#include "nazori/kanji/stroke.h"
#include "nazori/surface/height_map.h"

namespace nazori::carving {

/// Cross section of a groove.
enum class CrossSection : std::uint8_t {
  rounded,      ///< smooth bowl, no step in slope anywhere
  v_shaped,     ///< straight walls, eased at the bottom and the rim
  flat_bottom,  ///< level floor over the middle half
};

/// Width of the brush for characters whose strokes stand far apart, glyph units.
inline constexpr double kWidest = 7.0;

/// The brush that carves.
struct Brush {
  double width = kWidest;  ///< of the groove along the body of a stroke [glyph units, of 109], 0.5..40
  double depth = 1.0;      ///< of the centre line, as a fraction of the tablet's depth, (0, 1]
  CrossSection cross_section = CrossSection::rounded;
  bool endings =
      true;  ///< carve stop, hook and taper differently; false: every stroke keeps its width to its end
  bool fit = true;  ///< carve() narrows the width to suggested_width() where the strokes are closer together
};

/// Width and depth of the brush at one location on a stroke.
struct BrushMark {
  double half_width;  ///< [glyph units]
  double depth;       ///< fraction of the tablet's depth
};

/// The brush at arc length `s` of a stroke that is `length` long, both in glyph units: press at entry,
/// uniform body, then the ending. Carving uses this profile, and so does the depth of the stroke's centre
/// line in haptics. `either` is carved as stop.
/// @param hook_length  length of the hook at the end, 0 for strokes without one (see hook_length()).
[[nodiscard]] BrushMark brush_at(const Brush& brush, kanji::StrokeEnding ending, double s, double length,
                                 double hook_length = 0);

/// Length of the hook at the end of a stroke's line, glyph units: the part after its last sharp turn where
/// the ending is a hook (without such a turn its last quarter, at most 7 units), else 0.
[[nodiscard]] double hook_length(const kanji::StrokeLine& line);

/// The widest groove, up to kWidest, that leaves a clear ridge between neighbouring parallel strokes. It is
/// proportional to the distance between the closest of them, as a writer takes a finer brush for a crowded
/// character. At least 3 glyph units, so that a stylus still fits in.
[[nodiscard]] double suggested_width(std::span<const kanji::StrokeLine> strokes);

/// The brush that carve() uses: `brush` narrowed where Brush::fit is set.
[[nodiscard]] Brush fitted(const Brush& brush, std::span<const kanji::StrokeLine> strokes);

/// Carves strokes into a tablet of `size` x `size` samples. Overlapping grooves join at the deeper one
/// without a ridge, so the order of strokes does not change the result; strokes that leave the glyph box are
/// carved only inside it.
/// @param size  HeightMap::kMinSize..kMaxSize.
/// @return Errc::bad_argument naming the argument: size, a brush setting out of range, a point that is not
/// finite or farther than 10 boxes away.
/// @cost time in proportion to the area of the grooves; memory at most twice the map. Thread-safe: yes. Not
/// for the servo thread.
/// @source profile: own design; see brush_at().
[[nodiscard]] base::Result<surface::HeightMap> carve(std::span<const kanji::StrokeLine> strokes, int size,
                                                     const Brush& brush = {});

}  // namespace nazori::carving
