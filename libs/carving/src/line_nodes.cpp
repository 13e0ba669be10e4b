// SPDX-License-Identifier: Apache-2.0
#include "line_nodes.h"

#include <algorithm>
#include <cmath>

#include "nazori/geometry/frames.h"

namespace nazori::carving {
namespace {

using geometry::GlyphPoint;

constexpr double kCorner = 40 * 3.14159265358979323846 / 180;  // where the line turns by more stays a corner
constexpr double kLeastDistance = 1e-6;
// How far, in glyph units, a curve may leave the chord between two given points.
constexpr double kBow = 0.1;

/// The given points without repetitions, with corners marked. Beside gentle bends between long segments there
/// is one more point on each side, so that the curve does not overshoot.
/// @param least  distance of two points that count as two.
std::vector<Node> knots(std::span<const GlyphPoint> given, double least) {
  std::vector<GlyphPoint> points;
  std::vector<std::ptrdiff_t> index;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!points.empty() && geometry::distance(points.back(), given[i]) <= least) continue;
    points.push_back(given[i]);
    index.push_back(static_cast<std::ptrdiff_t>(i));
  }
  std::vector<Node> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 0 || i + 1 == points.size()) {
      out.push_back({points[i], 0, false, index[i]});
      continue;
    }
    const GlyphPoint before = points[i] - points[i - 1];
    const GlyphPoint after = points[i + 1] - points[i];
    const double turn = angle_between(before, after);
    if (turn > kCorner) {
      out.push_back({points[i], 0, true, index[i]});
      continue;
    }
    // The largest distance of a curve from a chord of length c that turns by `turn` at one end is about 0.15
    // c turn.
    const double reach = kBow / (0.15 * std::max(turn, 1e-3));
    const double l0 = geometry::length(before);
    const double l1 = geometry::length(after);
    if (l0 > 2.5 * reach) out.push_back({points[i] - before * (reach / l0)});
    out.push_back({points[i], 0, false, index[i]});
    if (l1 > 2.5 * reach) out.push_back({points[i] + after * (reach / l1)});
  }
  return out;
}

/// Curves through the knots (cubic Hermite, chord tangents), cut so that neighbouring segments turn by about
/// `max_turn`.
/// @param least_facet  no cut makes a segment shorter than this; 0: no limit.
std::vector<Node> refine(const std::vector<Node>& line, double max_turn, double least_facet) {
  std::vector<Node> out;
  out.reserve(4 * line.size());
  out.push_back(line.front());
  const auto is_smooth = [&line](std::size_t i) { return i > 0 && i + 1 < line.size() && !line[i].corner; };
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const GlyphPoint chord = line[i + 1].at - line[i].at;
    const double length = geometry::length(chord);
    const GlyphPoint along = chord * (1 / length);
    GlyphPoint start = is_smooth(i) ? unit(line[i + 1].at - line[i - 1].at) : along;
    GlyphPoint end = is_smooth(i + 1) ? unit(line[i + 2].at - line[i].at) : along;
    // Where one side has no further point, the curve continues as an arc.
    if (!is_smooth(i) && is_smooth(i + 1)) start = along * (2 * geometry::dot(along, end)) - end;
    if (is_smooth(i) && !is_smooth(i + 1)) end = along * (2 * geometry::dot(along, start)) - start;
    const double bend = angle_between(start, along) + angle_between(along, end);
    int parts = std::clamp(static_cast<int>(std::ceil(1.3 * bend / max_turn)), 1, 48);
    if (least_facet > 0) parts = std::clamp(static_cast<int>(length / least_facet), 1, parts);
    for (int k = 1; k < parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      const double t2 = t * t;
      const double t3 = t2 * t;
      const GlyphPoint p = line[i].at * (2 * t3 - 3 * t2 + 1) + start * (length * (t3 - 2 * t2 + t)) +
                           line[i + 1].at * (3 * t2 - 2 * t3) + end * (length * (t3 - t2));
      out.push_back({p});
    }
    out.push_back(line[i + 1]);
  }
  for (std::size_t i = 1; i < out.size(); ++i)
    out[i].s = out[i - 1].s + geometry::distance(out[i - 1].at, out[i].at);
  return out;
}

}  // namespace

std::vector<Node> smooth_nodes(std::span<const GlyphPoint> points, int size, Detail detail) {
  const double sample = geometry::kGlyphSide / (size - 1);
  const bool coarse = detail == Detail::samples;
  std::vector<Node> line = knots(points, coarse ? sample / 2 : kLeastDistance);
  // Fine enough that a facet is as long as two samples, but never visible even on a coarse grid.
  const double max_turn = std::clamp(12.0 / size, 0.012, 0.06);
  if (line.size() > 1) line = refine(line, max_turn, coarse ? sample : 0);
  return line;
}

std::vector<Node> subdivide(const std::vector<Node>& line, std::span<const Zone> zones) {
  std::vector<Node> out;
  out.reserve(line.size() + 64);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Node& a = line[i];
    const Node& b = line[i + 1];
    out.push_back(a);
    double s = a.s;
    const double least = 1e-3;
    while (b.s - s > least) {
      // The next point: a step within a zone, the border of a zone ahead, or the end of the segment.
      double next = b.s;
      for (const Zone& zone : zones) {
        if (s < zone.begin - least)
          next = std::min(next, zone.begin);
        else if (s < zone.end - least)
          next = std::min({next, zone.end, s + zone.step});
      }
      if (b.s - next <= least) break;
      out.push_back({a.at + (b.at - a.at) * ((next - a.s) / (b.s - a.s)), next});
      s = next;
    }
  }
  out.push_back(line.back());
  return out;
}

}  // namespace nazori::carving
