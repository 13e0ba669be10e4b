// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/stroke_edits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "nazori/author/own_character.h"
#include "nazori/carving/groove.h"
#include "nazori/geometry/polyline.h"
#include "pen_line.h"

namespace nazori::author {
namespace {

using carving::SmoothPoint;
using geometry::GlyphPoint;

/// The place at an arc length of a smooth line. @param s  limited to its length.
SmoothPoint place_at(const std::vector<SmoothPoint>& line, double s) {
  const auto after = std::ranges::upper_bound(line, s, {}, &SmoothPoint::arc_length);
  if (after == line.begin()) return line.front();
  if (after == line.end()) return line.back();
  const SmoothPoint& b = *after;
  const SmoothPoint& a = *(after - 1);
  const double t = (s - a.arc_length) / (b.arc_length - a.arc_length);
  return {a.at + (b.at - a.at) * t, a.half_width + (b.half_width - a.half_width) * t,
          a.depth + (b.depth - a.depth) * t, a.segment, s};
}

/// Whether the line turns sharply near its end, as a hook does, and the groove narrows from there on.
bool has_hook(const std::vector<SmoothPoint>& line) {
  // Lengths and angle as those of carving::hook_length().
  constexpr double kShortest = 2;
  constexpr double kLongest = 14;
  constexpr double kReach = 2.5;
  constexpr double kSharp = 50 * 3.14159265358979323846 / 180;
  const double length = line.back().arc_length;
  for (double tail = kShortest; tail <= std::min(kLongest, length / 2); tail += 0.5) {
    const SmoothPoint middle = place_at(line, length - tail);
    const GlyphPoint before = middle.at - place_at(line, length - tail - kReach).at;
    const GlyphPoint after = place_at(line, length - tail + kReach).at - middle.at;
    if (geometry::angle_between(before, after) > kSharp) return true;
  }
  return false;
}

}  // namespace

std::optional<OwnStroke> stroke_of_pen(const geometry::WrittenStroke<geometry::GlyphFrame>& pen,
                                       const PenSettings& settings) {
  const auto inside = [](double v) { return std::clamp(v, -geometry::kGlyphSide, 2 * geometry::kGlyphSide); };
  carving::Groove groove;
  for (const auto& p : pen) {
    if (!std::isfinite(p.at.x) || !std::isfinite(p.at.y)) continue;
    const double share = settings.thinnest + (1 - settings.thinnest) * pressure_of(p);
    groove.push_back({{inside(p.at.x), inside(p.at.y)},
                      std::clamp(settings.width / 2 * share, 0.0, carving::kWidestHalf),
                      std::clamp(settings.depth, 0.0, 1.0)});
  }
  if (groove.empty()) return std::nullopt;
  double tolerance = settings.tolerance;
  OwnStroke stroke{simplified(groove, tolerance), kanji::StrokeEnding::stop, {}};
  for (; stroke.points.size() > kMostPoints; stroke.points = simplified(groove, tolerance))
    tolerance = std::max(tolerance, 0.1) * 1.5;
  stroke.ending = ending_of(stroke);
  return stroke;
}

kanji::StrokeEnding ending_of(const OwnStroke& stroke) {
  constexpr double kLastPart = 0.15;
  constexpr double kNarrow = 0.6;
  const std::vector<SmoothPoint> line = carving::smooth_line(stroke.points);
  const double length = line.back().arc_length;
  if (length <= 0) return kanji::StrokeEnding::stop;
  const double before = place_at(line, length * (1 - kLastPart)).half_width;
  if (line.back().half_width >= kNarrow * before) return kanji::StrokeEnding::stop;
  return has_hook(line) ? kanji::StrokeEnding::hook : kanji::StrokeEnding::taper;
}

std::optional<StrokePlace> nearest_place(std::span<const OwnStroke> strokes, GlyphPoint at) {
  std::optional<StrokePlace> best;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    const std::vector<SmoothPoint> line = carving::smooth_line(strokes[k].points);
    for (std::size_t i = 0; i < line.size(); ++i) {
      const SmoothPoint& a = line[i];
      const SmoothPoint& b = line[std::min(i + 1, line.size() - 1)];
      const double t = geometry::nearest_share(at, a.at, b.at);
      const GlyphPoint point = a.at + (b.at - a.at) * t;
      const double distance = geometry::distance(point, at);
      if (best && distance >= best->distance) continue;
      best = StrokePlace{
          k,
          a.segment,
          {point, a.half_width + (b.half_width - a.half_width) * t, a.depth + (b.depth - a.depth) * t},
          distance};
    }
  }
  return best;
}

std::optional<SnappedPoint> snap(std::span<const OwnStroke> strokes, GlyphPoint click, double reach) {
  std::optional<SnappedPoint> best;
  const auto offer = [&](std::size_t stroke, std::size_t point, PointKind kind) {
    const double distance = geometry::distance(strokes[stroke].points[point].at, click);
    if (distance <= reach && (!best || distance < best->distance)) best = {stroke, point, kind, distance};
  };
  for (std::size_t k = strokes.size(); k-- > 0;) offer(k, 0, PointKind::start);
  for (std::size_t k = strokes.size(); k-- > 0;)
    if (strokes[k].points.size() > 1) offer(k, strokes[k].points.size() - 1, PointKind::end);
  for (std::size_t k = strokes.size(); k-- > 0;)
    for (std::size_t i = 1; i + 1 < strokes[k].points.size(); ++i) offer(k, i, PointKind::bend);
  return best;
}

OwnStroke with_point(const OwnStroke& stroke, const StrokePlace& place) {
  assert(place.segment < stroke.points.size());
  OwnStroke out = stroke;
  out.points.insert(out.points.begin() + static_cast<std::ptrdiff_t>(place.segment) + 1, place.groove);
  return out;
}

OwnStroke without_point(const OwnStroke& stroke, std::size_t point) {
  assert(stroke.points.size() > 1 && point < stroke.points.size());
  OwnStroke out = stroke;
  out.points.erase(out.points.begin() + static_cast<std::ptrdiff_t>(point));
  return out;
}

std::pair<OwnStroke, OwnStroke> split_at(const OwnStroke& stroke, std::size_t point) {
  assert(point > 0 && point + 1 < stroke.points.size());
  const auto middle = stroke.points.begin() + static_cast<std::ptrdiff_t>(point);
  OwnStroke first{{stroke.points.begin(), middle + 1}, kanji::StrokeEnding::stop, stroke.number_position};
  OwnStroke second{{middle, stroke.points.end()}, stroke.ending, {}};
  return {std::move(first), std::move(second)};
}

OwnStroke joined(const OwnStroke& first, const OwnStroke& second) {
  OwnStroke out = first;
  const bool meets = first.points.back().at == second.points.front().at;
  out.points.insert(out.points.end(), second.points.begin() + (meets ? 1 : 0), second.points.end());
  out.ending = second.ending;
  return out;
}

OwnStroke reversed(const OwnStroke& stroke) {
  OwnStroke out{{stroke.points.rbegin(), stroke.points.rend()}, kanji::StrokeEnding::stop, {}};
  out.ending = ending_of(out);
  return out;
}

OwnStroke scaled(const OwnStroke& stroke, double width, double depth) {
  OwnStroke out = stroke;
  for (GroovePoint& point : out.points) {
    point.half_width = std::clamp(point.half_width * width, 0.0, carving::kWidestHalf);
    point.depth = std::clamp(point.depth * depth, 0.0, 1.0);
  }
  return out;
}

OwnStroke thinned(OwnStroke stroke, double tolerance) {
  stroke.points = simplified(stroke.points, tolerance);
  return stroke;
}

}  // namespace nazori::author
