// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "nazori/author/own_character.h"
#include "nazori/base/result.h"
#include "nazori/carving/groove.h"
#include "nazori/geometry/written_stroke.h"
#include "nazori/surface/height_map.h"

namespace nazori::author {

/// What a tool does to the relief under it.
enum class ReliefTool : std::uint8_t {
  groove,  ///< cuts a groove, as deep as the pressure; it joins other grooves as strokes do
  raise,   ///< raises the ground, at most to the plateau
  smooth,  ///< evens out
  erase,   ///< takes back what the hand did; the strokes stay
};

/// How a tool is held.
struct ToolSettings {
  double width = 6;       ///< at full pressure [glyph units], 0.5..40; half of it where there is no pressure
  double depth = 0.5;     ///< at full pressure: fraction of the tablet's depth that it cuts or raises; of
                          ///< `smooth` and `erase` the share that is evened out or taken back; (0, 1]
  bool straight = false;  ///< only a straight line from the first to the last point
  bool mirrored = false;  ///< the same at the other side of the vertical middle line, too
};

/// Most points of one movement of a tool.
inline constexpr std::size_t kMostToolPoints = 10'000;

/// Moves a tool over the relief. The same calls give the same bytes.
/// @param pen  one movement; a missing pressure counts as 1.
/// @param map  the present relief as carve() makes it, of any size. It is not changed: call carve_box() with
/// the answer.
/// @param hand  that is changed; an untouched one becomes one of the map's size, else its size is that of the
/// map.
/// @return the samples that changed, empty where none did; Errc::bad_argument for settings out of range,
/// points that are not finite or too many, or a layer of another size; then nothing has changed.
[[nodiscard]] base::Result<carving::GridBox> use_tool(
    ReliefTool tool, const ToolSettings& settings, const geometry::WrittenStroke<geometry::GlyphFrame>& pen,
    const surface::HeightMap& map, HandLayer& hand);

/// Shapes that can be pressed into the relief.
enum class StampShape : std::uint8_t { dot, ring, bar, cross, square, triangle };
inline constexpr StampShape kStampShapes[] = {StampShape::dot,   StampShape::ring,   StampShape::bar,
                                              StampShape::cross, StampShape::square, StampShape::triangle};

/// A stamp as a height map of 65 x 65 samples: 1 outside of the shape, 0 in it, with soft edges.
[[nodiscard]] const surface::HeightMap& stamp_of(StampShape shape);

/// How a stamp is pressed.
struct StampSettings {
  double size = 12;       ///< side of the square that the stamp fills [glyph units], 1..109
  double depth = 0.5;     ///< where the stamp is 0: fraction of the tablet's depth, (0, 1]
  bool raised = false;    ///< raises instead of cutting
  bool mirrored = false;  ///< a mirrored one at the other side, too
};

/// Presses a stamp. @param at  its middle. @param stamp  loaded; for example a part of another relief.
/// The rest as for use_tool().
[[nodiscard]] base::Result<carving::GridBox> press_stamp(const surface::HeightMap& stamp,
                                                         const StampSettings& settings,
                                                         geometry::GlyphPoint at,
                                                         const surface::HeightMap& map, HandLayer& hand);

}  // namespace nazori::author
