// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "nazori/author/own_stroke.h"
#include "nazori/geometry/written_stroke.h"

namespace nazori::author {

/// How a pen becomes a groove.
struct PenSettings {
  double width = 7;        ///< of the groove at full pressure [glyph units]
  double depth = 1;        ///< of the groove, fraction of the tablet's depth
  double thinnest = 0.25;  ///< share of the width at no pressure
  double tolerance = 0.3;  ///< how far the simplified line may leave the pen's [glyph units]
};

/// The stroke that a pen drew: as broad as it pressed (a missing pressure counts as 1), with only the points
/// that are needed for its line and its width. Points that are not finite are left out. The ending is read
/// from the width and the line: see ending_of().
/// @return nothing where no point is left.
[[nodiscard]] std::optional<OwnStroke> stroke_of_pen(const geometry::WrittenStroke<geometry::GlyphFrame>& pen,
                                                     const PenSettings& settings = {});

/// The ending that the groove of a stroke has: `hook` where its line has a hook and the groove narrows along
/// it, `taper` where it narrows over its last 15 % to less than 60 % of its body, else `stop`.
[[nodiscard]] kanji::StrokeEnding ending_of(const OwnStroke& stroke);

/// A place on the centre line of a stroke as it is carved.
struct StrokePlace {
  std::size_t stroke = 0;   ///< 0-based
  std::size_t segment = 0;  ///< index of the point before
  GroovePoint groove;       ///< the line and the groove there
  double distance = 0;      ///< from what was asked for [glyph units]
};

/// The place nearest to `at` on any stroke, or on one; nothing where there are no strokes.
[[nodiscard]] std::optional<StrokePlace> nearest_place(std::span<const OwnStroke> strokes,
                                                       geometry::GlyphPoint at);

/// Kinds of points that a click snaps to.
enum class PointKind : std::uint8_t { start, bend, end };

/// A point of a stroke.
struct SnappedPoint {
  std::size_t stroke = 0;  ///< 0-based
  std::size_t point = 0;   ///< 0-based
  PointKind kind = PointKind::start;
  double distance = 0;  ///< from the click [glyph units]
};

/// The point of a stroke nearest to a click; of several at the same distance the start of the latest stroke,
/// which is the one drawn on top. Nothing where none is within `reach`.
[[nodiscard]] std::optional<SnappedPoint> snap(std::span<const OwnStroke> strokes, geometry::GlyphPoint click,
                                               double reach = 4);

/// The stroke with one more point on its line, where that line is cut now. @param place  of nearest_place()
/// for this stroke. Its new point has the index place.segment + 1.
[[nodiscard]] OwnStroke with_point(const OwnStroke& stroke, const StrokePlace& place);
/// The stroke without a point. @param stroke  of at least two points.
[[nodiscard]] OwnStroke without_point(const OwnStroke& stroke, std::size_t point);

/// The two halves of a stroke, which both have the point at which it is split. The first stops; the second
/// keeps the ending, and no number is placed for it.
/// @param point  neither the first nor the last.
[[nodiscard]] std::pair<OwnStroke, OwnStroke> split_at(const OwnStroke& stroke, std::size_t point);

/// One stroke of two, with the number of the first and the ending of the second. A point that both have at
/// the join is there once.
[[nodiscard]] OwnStroke joined(const OwnStroke& first, const OwnStroke& second);

/// The same groove drawn from the other end, with the ending that it then has. Its number is placed by the
/// program.
[[nodiscard]] OwnStroke reversed(const OwnStroke& stroke);

/// The stroke with all half widths and depths scaled, limited to the ranges of GroovePoint.
[[nodiscard]] OwnStroke scaled(const OwnStroke& stroke, double width, double depth);

/// The stroke with only those points that its line, width and depth need. @param tolerance  how far the
/// straight segments between them may be off [glyph units]; a tenth of the depth counts as one unit.
[[nodiscard]] OwnStroke thinned(OwnStroke stroke, double tolerance = 0.15);

/// The box of a stroke's number: a digit is 4.6 wide and 6 high, as KanjiVG prints it at 8 units.
struct NumberBox {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
};
/// @param number  from 1. @param at  left end of its baseline.
[[nodiscard]] NumberBox number_box(std::size_t number, geometry::GlyphPoint at);

/// Where the numbers of all strokes are written: those that have a position keep it, the others are placed in
/// writing order, each as near to its start as it can be without covering another number or the start of a
/// stroke, inside the picture, and beside the grooves where that is near enough. Fixed rule: the same strokes
/// give the same places. Where nothing is free (about 100 strokes) a number stands at the upper left of its
/// start.
[[nodiscard]] std::vector<geometry::GlyphPoint> number_places(std::span<const OwnStroke> strokes);

}  // namespace nazori::author
