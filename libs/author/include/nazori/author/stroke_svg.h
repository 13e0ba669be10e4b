// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "nazori/author/own_stroke.h"
#include "nazori/geometry/svg_path.h"

namespace nazori::author {

/// The centre line as curves through few of its points: within 0.2 glyph units of it, corners kept.
/// @pre at least one point; a single one becomes a curve without length.
[[nodiscard]] geometry::BezierPath path_of(const OwnStroke& stroke);

/// Strokes as KanjiVG draws them: a picture of 109 x 109 units with one path for each stroke, in their order,
/// and their numbers. Widths, depths and endings are not in it.
/// @source the SVG files of KanjiVG.
[[nodiscard]] std::string to_svg(std::span<const OwnStroke> strokes);

}  // namespace nazori::author
