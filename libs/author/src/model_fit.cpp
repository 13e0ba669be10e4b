// SPDX-License-Identifier: Apache-2.0
#include "model_fit.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "gaps.h"
#include "groove_line.h"
#include "ink_graph.h"
#include "junctions.h"
#include "laid_over.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/polyline.h"
#include "ridge.h"
#include "snapped.h"
#include "stroke_guess.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;

/// Points about a unit apart, at least two.
GlyphLine evenly(const GlyphLine& line) {
  const double length = geometry::arc_length<geometry::GlyphFrame>(line);
  if (length < 1e-3) return {line.front() - GlyphPoint{0.5, 0.5}, line.front() + GlyphPoint{0.5, 0.5}};
  const auto count = static_cast<std::size_t>(std::min(2000.0, std::max(4.0, std::round(length / 1.0)))) + 1;
  return geometry::resample<geometry::GlyphFrame>(line, count);
}

}  // namespace

base::Result<void> check_known(std::span<const kanji::StrokeLine> character) {
  constexpr double kFarthest = 10 * geometry::kGlyphSide;
  const auto fail = [](std::string what) {
    return base::fail(base::Errc::bad_argument, std::move(what), "character", "give strokes of the database");
  };
  if (character.empty()) return fail("has no strokes");
  if (character.size() > kMostTracedStrokes) return fail("has too many strokes");
  for (const kanji::StrokeLine& stroke : character) {
    if (stroke.points.empty()) return fail("has a stroke without points");
    for (const geometry::GlyphPoint p : stroke.points)
      if (!(std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest))
        return fail("has a point far outside of the glyph box");
  }
  return {};
}

std::vector<FittedStroke> fitted(const InkMap& map, std::span<const kanji::StrokeLine> character) {
  const double reach = map.is_groove ? kGrooveReach : kInkReach;
  const Ridge ridge = ridge_of(divided_at_gaps(middle_lines(map), map), map, reach);
  std::vector<GlyphLine> lines;
  lines.reserve(character.size());
  std::vector<bool> thins_out;
  for (const kanji::StrokeLine& stroke : character) {
    lines.push_back(evenly(stroke.points));
    thins_out.push_back(stroke.ending == kanji::StrokeEnding::taper ||
                        stroke.ending == kanji::StrokeEnding::hook);
  }
  const LaidOver over = laid_over(lines, ridge, map.is_groove);
  constexpr double kFirstGate = 4.5;
  constexpr double kGate = 2.5;
  std::vector<GlyphLine> first;
  for (Snapped& s : snapped(over.bent, thins_out, ridge, kFirstGate)) first.push_back(evenly(s.line));
  const std::vector<Snapped> second = snapped(first, thins_out, ridge, kGate);

  std::vector<FittedStroke> out;
  for (std::size_t k = 0; k < second.size(); ++k) {
    GridLine line;
    for (const GlyphPoint p : second[k].line) line.push_back(geometry::glyph_to_grid(p, kInkSide));
    FittedStroke fit{groove_along(line, map), {}, 0, 0};
    if (thins_out[k]) lengthen_tips(fit.stroke);
    fit.ending_of_ink = ending_of_ink(fit.stroke);
    fit.stroke.ending = character[k].ending;
    const auto on = std::count(second[k].is_on_ink.begin(), second[k].is_on_ink.end(), true);
    fit.covered = static_cast<double>(on) / static_cast<double>(second[k].is_on_ink.size());
    for (const GlyphPoint p : second[k].line)
      fit.moved += geometry::nearest_point<geometry::GlyphFrame>(over.as_a_whole[k], p).distance;
    fit.moved /= static_cast<double>(second[k].line.size());
    out.push_back(std::move(fit));
  }
  return out;
}

}  // namespace nazori::author
