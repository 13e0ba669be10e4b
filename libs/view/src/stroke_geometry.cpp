// SPDX-License-Identifier: Apache-2.0
#include "stroke_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "clearance_grid.h"
#include "hidden_lines.h"
#include "nazori/geometry/follow_line.h"
#include "nazori/geometry/polyline.h"

namespace nazori::view {
namespace {

using geometry::GlyphPoint;
using GlyphLine = geometry::Polyline<geometry::GlyphFrame>;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kCornerTurn = 35 * kDegree;
constexpr double kCornerReach = 2.5;    ///< glyph units before and after a point between which a turn counts
constexpr double kStraightPiece = 6.0;  ///< glyph units: no flattened curve has pieces this long that bend
constexpr double kStraightTurn = 8 * kDegree;
constexpr double kShortestStart =
    5.0;  ///< glyph units: the press of a brush at its start does not count as a run
constexpr double kShortestEnd = 2.5;  ///< nor does a rounding of the last point; a hook is longer
constexpr double kHeadReach = 5.0;    ///< glyph units over which an arrowhead's direction is measured
constexpr double kClassicHead = 5.0 / 127.0;
constexpr double kClassicSpread = 30 * kDegree;

constexpr double kInkStep = 1.0;  ///< glyph units
/// Maximum number of pieces of ink. No character has a hundredth of it; a file of strokes may hold millions
/// of long lines.
constexpr double kMostInk = 200'000;
constexpr double kWidthStep = 0.2;
constexpr double kWidestGroove = 20.0;
constexpr float kLip = 0.985F;        ///< of the plateau's height
constexpr double kPlainRadius = 2.5;  ///< of ink where nothing is carved

GlyphLine without_repeats(std::span<const GlyphPoint> line) {
  GlyphLine kept;
  for (const GlyphPoint p : line) {
    if (kept.empty() || geometry::distance(kept.back(), p) > 1e-6) kept.push_back(p);
  }
  return kept;
}

/// The point at arc length `s`, limited to the line. @param along  arc length at each of its points.
GlyphPoint point_at(std::span<const GlyphPoint> line, std::span<const double> along, double s) {
  return geometry::point_on(line, geometry::place_at(along, s));
}

GlyphPoint direction_into(std::span<const GlyphPoint> line, std::span<const double> along, double s,
                          double reach) {
  const GlyphPoint step = point_at(line, along, s) - point_at(line, along, std::max(s - reach, 0.0));
  const double size = geometry::length(step);
  return size > 0 ? step * (1 / size) : GlyphPoint{1, 0};
}

glm::vec2 to_metres(GlyphPoint p, const geometry::TabletShape& shape) {
  const auto m = geometry::glyph_to_tablet(p, shape);
  return {static_cast<float>(m.x), static_cast<float>(m.y)};
}

glm::vec2 rotated(glm::vec2 v, double angle) {
  const auto c = static_cast<float>(std::cos(angle));
  const auto s = static_cast<float>(std::sin(angle));
  return {v.x * c - v.y * s, v.x * s + v.y * c};
}

float height_at(const Relief& relief, GlyphPoint p) {
  const auto grid = geometry::glyph_to_grid(p, relief.size);
  const double x = std::clamp(grid.x, 0.0, relief.size - 1.0);
  const double y = std::clamp(grid.y, 0.0, relief.size - 1.0);
  const int i = std::min(static_cast<int>(x), relief.size - 2);
  const int j = std::min(static_cast<int>(y), relief.size - 2);
  const auto u = static_cast<float>(x - i);
  const auto v = static_cast<float>(y - j);
  return (relief.at(i, j) * (1 - u) + relief.at(i + 1, j) * u) * (1 - v) +
         (relief.at(i, j + 1) * (1 - u) + relief.at(i + 1, j + 1) * u) * v;
}

/// The most frequent height in the upper half of the relief: under ridges, as of axes, the plateau is lower
/// than 1.
float plateau_of(const Relief& relief) {
  constexpr std::size_t kSteps = 1024;
  std::vector<std::size_t> counts(kSteps, 0);
  for (const float height : relief.heights) {
    if (height >= 0.5F)
      ++counts[std::min(static_cast<std::size_t>((height - 0.5F) * 2 * kSteps), kSteps - 1)];
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  if (*most == 0) return 1;
  return 0.5F + 0.5F * static_cast<float>(most - counts.begin() + 1) / static_cast<float>(kSteps);
}

/// Distance from the centre line to the nearer edge of the groove; the farther one may belong to a crossing
/// stroke.
double groove_half_width(const Relief& relief, float lip, GlyphPoint centre, GlyphPoint direction) {
  if (relief.size < 2) return kPlainRadius;
  const GlyphPoint across{-direction.y, direction.x};
  double nearer = kWidestGroove;
  for (const double side : {-1.0, 1.0}) {
    double r = 0;
    while (r < nearer && height_at(relief, centre + across * (side * r)) < lip) r += kWidthStep;
    nearer = std::min(nearer, r);
  }
  return nearer;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Half widths at evenly spaced points, without the bulges that crossing grooves make.
std::vector<double> ink_radii(const Relief& relief, float lip, std::span<const GlyphPoint> points) {
  std::vector<double> raw;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, points.size() - 1);
    GlyphPoint along = points[after] - points[before];
    const double size = geometry::length(along);
    along = size > 0 ? along * (1 / size) : GlyphPoint{1, 0};
    raw.push_back(groove_half_width(relief, lip, points[i], along));
  }
  // Where grooves cross, the edge is that of the other one: such widths are replaced by those before and
  // after.
  const double widest = median(raw) * 1.06;
  std::vector<double> radii = raw;
  std::size_t after = 0;
  std::size_t before = 0;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] <= widest) {
      before = i;
      continue;
    }
    after = std::max(after, i);
    while (after + 1 < raw.size() && raw[after] > widest) ++after;
    const double from = std::min(raw[before], widest);
    const double to = std::min(raw[after], widest);
    const double t =
        after > before ? static_cast<double>(i - before) / static_cast<double>(after - before) : 0;
    radii[i] = std::lerp(raw[before] > widest ? to : from, raw[after] > widest ? from : to, t);
  }
  return radii;
}

/// @param step  of the ink along the line, in glyph units.
void append_ink(StrokeGeometry& geometry, const GlyphLine& line, double step, const Relief& relief,
                const geometry::TabletShape& shape) {
  const double length = geometry::arc_length(std::span<const GlyphPoint>(line));
  const auto count = static_cast<std::size_t>(std::ceil(length / step)) + 1;
  const GlyphLine points = line.size() < 2 ? GlyphLine{line.front(), line.front()}
                                           : geometry::resample(std::span<const GlyphPoint>(line),
                                                                std::max<std::size_t>(count, 2));
  const auto radii = ink_radii(relief, kLip * geometry.plateau, points);
  const double metres = shape.width_m / geometry::kGlyphSide;
  InkRange range{geometry.ink.size(), points.size() - 1, length * metres};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double share = range.length_m / static_cast<double>(points.size() - 1);
    geometry.ink.push_back(
        {to_metres(points[i], shape),
         to_metres(points[i + 1], shape),
         {static_cast<float>(radii[i] * metres), static_cast<float>(radii[i + 1] * metres)},
         {static_cast<float>(share * static_cast<double>(i)),
          static_cast<float>(share * static_cast<double>(i + 1))}});
  }
  geometry.ink_ranges.push_back(range);
}

void append_heads(StrokeGeometry& geometry, const GlyphLine& line, float number,
                  const geometry::TabletShape& shape) {
  const auto along = geometry::arc_lengths<geometry::GlyphFrame>(line);
  double run_start = 0;
  for (const std::size_t end : run_ends(line)) {
    const double reach = std::min(kHeadReach, (along[end] - run_start) * 0.8);
    const GlyphPoint into = direction_into(line, along, along[end], reach);
    const glm::vec2 direction(static_cast<float>(into.x), static_cast<float>(-into.y));
    const glm::vec2 tip = to_metres(line[end], shape);
    geometry.heads.push_back({tip, direction, number});
    const auto size = static_cast<float>(kClassicHead * shape.width_m);
    for (const double side : {-1.0, 1.0}) {
      const glm::vec2 back = rotated(-direction, side * kClassicSpread);
      geometry.classic_heads.push_back({tip, tip + back * size, number});
    }
    run_start = along[end];
  }
}

/// The side of a stroke's start that keeps a number clear of all strokes, behind the start if possible.
glm::dvec2 clear_side(std::span<const GlyphLine> lines, const ClearanceGrid& grid, std::size_t stroke) {
  const GlyphLine& line = lines[stroke];
  const GlyphPoint start = line.front();
  const GlyphPoint ahead = direction_into(line, geometry::arc_lengths<geometry::GlyphFrame>(line), 8.0, 8.0);
  constexpr int kWays = 24;
  double best_score = -std::numeric_limits<double>::infinity();
  GlyphPoint best{0, -1};
  for (int k = 0; k < kWays; ++k) {
    const double angle = 2 * std::numbers::pi * k / kWays;
    const GlyphPoint way{std::cos(angle), std::sin(angle)};
    double score = -0.35 * geometry::dot(way, ahead) - 0.12 * way.x - 0.06 * way.y;
    for (const double reach : {4.0, 7.0}) {
      const GlyphPoint place = start + way * reach;
      double clearance = grid.at(place, 9);
      for (std::size_t other = 0; other < lines.size(); ++other) {
        if (other != stroke)
          clearance = std::min(clearance, geometry::distance(lines[other].front(), place) - 3);
      }
      score += 0.16 * clearance;
      const double outside =
          std::max({-place.x, -place.y, place.x - geometry::kGlyphSide, place.y - geometry::kGlyphSide, 0.0});
      score -= outside * 0.5;
    }
    if (score > best_score) {
      best_score = score;
      best = way;
    }
  }
  return {best.x, -best.y};
}

}  // namespace

std::vector<std::size_t> run_ends(std::span<const GlyphPoint> points) {
  std::vector<std::size_t> ends;
  if (points.size() < 2) return ends;
  const auto along = geometry::arc_lengths<geometry::GlyphFrame>(points);
  const double length = along.back();
  if (length <= 0) return ends;
  struct Corner {
    std::size_t index;
    double turn;
  };
  std::vector<Corner> corners;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double before = along[i] - along[i - 1];
    const double after = along[i + 1] - along[i];
    if (before <= 0 || after <= 0) continue;
    const double at_point = angle_between(points[i] - points[i - 1], points[i + 1] - points[i]);
    const double reach = std::min({kCornerReach, along[i], length - along[i]});
    const GlyphPoint into = points[i] - point_at(points, along, along[i] - reach);
    const GlyphPoint out = point_at(points, along, along[i] + reach) - points[i];
    const double turn = std::max(angle_between(into, out), at_point);
    const bool straight_bend =
        before >= kStraightPiece && after >= kStraightPiece && at_point >= kStraightTurn;
    if (turn >= kCornerTurn || straight_bend) corners.push_back({i, turn});
  }
  // Among the points of one rounded corner the sharpest represents all.
  for (std::size_t k = 0; k < corners.size();) {
    std::size_t last = k;
    std::size_t sharpest = k;
    while (last + 1 < corners.size() &&
           along[corners[last + 1].index] - along[corners[last].index] < kCornerReach) {
      ++last;
      if (corners[last].turn > corners[sharpest].turn) sharpest = last;
    }
    const double s = along[corners[sharpest].index];
    if (s > kShortestStart && length - s > kShortestEnd) ends.push_back(corners[sharpest].index);
    k = last + 1;
  }
  ends.push_back(points.size() - 1);
  return ends;
}

StrokeGeometry make_stroke_geometry(std::span<const GlyphLine> strokes, const Relief& relief,
                                    const geometry::TabletShape& shape) {
  StrokeGeometry geometry;
  geometry.plateau = plateau_of(relief);
  std::vector<GlyphLine> lines;
  double length = 0;
  for (const GlyphLine& stroke : strokes) {
    GlyphLine line = without_repeats(stroke);
    if (line.empty()) line.push_back({0, 0});
    length += geometry::arc_length(std::span<const GlyphPoint>(line));
    lines.push_back(std::move(line));
  }
  const ClearanceGrid grid(lines);
  const double ink_step = std::max(kInkStep, length / kMostInk);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const GlyphLine& line = lines[i];
    const auto number = static_cast<float>(i + 1);
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      geometry.lines.push_back({to_metres(line[k], shape), to_metres(line[k + 1], shape), number});
    if (line.size() == 1)
      geometry.lines.push_back({to_metres(line[0], shape), to_metres(line[0], shape), number});
    append_heads(geometry, line, number, shape);
    append_ink(geometry, line, ink_step, relief, shape);
    geometry.anchors.push_back({geometry::glyph_to_tablet(line.front(), shape), clear_side(lines, grid, i)});
  }
  geometry.shown_lines = put_hidden_last(geometry.lines, shape);
  geometry.shown_heads = put_hidden_last(geometry.heads, shape);
  geometry.shown_classic_heads = put_hidden_last(geometry.classic_heads, shape);
  return geometry;
}

}  // namespace nazori::view
