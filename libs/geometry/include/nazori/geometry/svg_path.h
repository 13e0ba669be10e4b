// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/geometry/point.h"

namespace nazori::geometry {

/// One continuous line of cubic Bezier curves: each piece starts where the previous one ended. Straight parts
/// are curves whose control points lie on the line.
struct BezierPath {
  GlyphPoint start;
  std::vector<std::array<GlyphPoint, 3>> pieces;  ///< two control points and the end of each
};

/// Reads the path data of one stroke (SVG 1.1, section 8.3): commands M L H V C S Q T in both cases, numbers
/// as SVG writes them ("-.5.5" is two). A stroke is one line, so a second M (or Z, or an arc A) is an error.
/// @return Errc::parse with the column (from 1) in `where` for anything else: unknown commands, too few
/// numbers, a number that is not finite, over 1e6 or more precise than a double, more than 10,000 pieces.
[[nodiscard]] base::Result<BezierPath> parse_svg_path(std::string_view data);

/// Straight segments that stay within `tolerance` glyph units of the curve. The first and last points are
/// those of the path; points at corners are kept; no point is repeated.
/// @param tolerance  > 0.
[[nodiscard]] Polyline<GlyphFrame> flatten(const BezierPath& path, double tolerance);

}  // namespace nazori::geometry
