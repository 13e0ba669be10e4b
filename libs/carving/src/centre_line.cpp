// SPDX-License-Identifier: Apache-2.0
#include "centre_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "brush.h"
#include "nazori/geometry/frames.h"

namespace nazori::carving {
namespace {

using geometry::GlyphPoint;

constexpr double kPi = 3.14159265358979323846;
constexpr double kCorner = 40 * kPi / 180;  // a point where the line turns by more stays a corner
constexpr double kSplit = 50 * kPi / 180;   // so does a bend that turns by more within a groove's width
constexpr double kLongPiece = 120 * kPi / 180;
constexpr double kLeastDistance = 1e-6;
// How far, in glyph units, a curve may leave the chord between two given points.
constexpr double kBow = 0.1;

/// A point of the refined line.
struct Node {
  GlyphPoint at;
  double s = 0;
  bool corner = false;
};

GlyphPoint unit(GlyphPoint v) {
  const double l = geometry::length(v);
  return l > 0 ? v * (1 / l) : GlyphPoint{1, 0};
}

double cross(GlyphPoint a, GlyphPoint b) { return a.x * b.y - a.y * b.x; }

double angle_between(GlyphPoint a, GlyphPoint b) {
  return std::atan2(std::abs(cross(a, b)), geometry::dot(a, b));
}

/// The given points without repetitions, with corners marked. Beside gentle bends between long segments there
/// is one more point on each side, so that the curve does not overshoot.
/// @param least  distance of two points that count as two.
std::vector<Node> knots(const std::vector<GlyphPoint>& given, double least) {
  std::vector<GlyphPoint> points;
  for (const GlyphPoint p : given)
    if (points.empty() || geometry::distance(points.back(), p) > least) points.push_back(p);
  std::vector<Node> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 0 || i + 1 == points.size()) {
      out.push_back({points[i]});
      continue;
    }
    const GlyphPoint before = points[i] - points[i - 1];
    const GlyphPoint after = points[i + 1] - points[i];
    const double turn = angle_between(before, after);
    if (turn > kCorner) {
      out.push_back({points[i], 0, true});
      continue;
    }
    // The largest distance of a curve from a chord of length c that turns by `turn` at one end is about 0.15
    // c turn.
    const double reach = kBow / (0.15 * std::max(turn, 1e-3));
    const double l0 = geometry::length(before);
    const double l1 = geometry::length(after);
    if (l0 > 2.5 * reach) out.push_back({points[i] - before * (reach / l0)});
    out.push_back({points[i]});
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

/// A stretch of the line over which the brush changes, and how finely it is sampled there.
struct Zone {
  double begin;
  double end;
  double step;
};

/// Adds points wherever the brush changes, so that its width is linear between two joints.
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

/// Nodes at which the stroke is split because it turns sharply there.
std::vector<std::size_t> corners(const std::vector<Node>& line, double reach) {
  std::vector<GlyphPoint> points;
  points.reserve(line.size());
  for (const Node& node : line) points.push_back(node.at);
  std::vector<std::size_t> out;
  // Only a line that bends is worth the time of the search.
  std::size_t best = 0;
  double best_turn = 0;
  const auto close = [&] {
    if (best_turn > 0) out.push_back(best);
    best_turn = 0;
  };
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (best_turn > 0 && line[i].s > line[best].s + reach) close();
    if (!out.empty() && !line[i].corner && line[i].s < line[out.back()].s + reach) continue;
    double turn = 0;
    if (line[i].corner) {
      turn = 2 * kPi;
    } else if (std::abs(cross(points[i] - points[i - 1], points[i + 1] - points[i])) > 1e-9) {
      turn = turn_at(points, i, reach);
    }
    if (line[i].corner && best_turn >= 2 * kPi) close();
    if (turn > kSplit && turn > best_turn) {
      best = i;
      best_turn = turn;
    }
  }
  close();
  return out;
}

/// Marks the joints about which the line turns on a smaller radius than the groove is wide. What counts is
/// the turn over about a half width: single joints are not significant, because their distances differ.
void mark_tight_bends(const std::vector<Node>& line, const std::vector<double>& turns, double scale,
                      std::vector<Joint>& joints) {
  constexpr double kTight = 0.85;  // radians over a half width
  double turned = 0;
  std::size_t first = 0;
  std::size_t end = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double reach = 0.5 * joints[i].half_width / scale;
    for (; end < line.size() && line[end].s <= line[i].s + reach; ++end) turned += turns[end];
    for (; line[first].s < line[i].s - reach; ++first) turned -= turns[first];
    // The groove narrows along a sweep, so the window's far end may lie behind one that was already passed.
    joints[i].needs_disc = turned > kTight;
  }
}

}  // namespace

double turn_at(std::span<const GlyphPoint> line, std::size_t i, double reach) {
  const auto look = [&](std::ptrdiff_t step) {
    double left = reach;
    std::size_t k = i;
    while (true) {
      const std::size_t next = k + static_cast<std::size_t>(step);
      if (next >= line.size())
        return line[k];  // also catches values below 0, which wrap around: without a length there is no turn
      const double d = geometry::distance(line[k], line[next]);
      if (d >= left && d > 0) return line[k] + (line[next] - line[k]) * (left / d);
      left -= d;
      k = next;
    }
  };
  return angle_between(line[i] - look(-1), look(1) - line[i]);
}

std::vector<Piece> trace(const kanji::StrokeLine& stroke, const Brush& brush, int size, Detail detail) {
  const double scale = (size - 1) / geometry::kGlyphSide;
  const double sample = 1 / scale;
  const bool coarse = detail == Detail::samples;
  std::vector<Node> line = knots(stroke.points, coarse ? sample / 2 : kLeastDistance);
  // Fine enough that a facet is as long as two samples, but never visible even on a coarse grid.
  const double max_turn = std::clamp(12.0 / size, 0.012, 0.06);
  if (line.size() > 1) line = refine(line, max_turn, coarse ? sample : 0);
  const double length = line.back().s;
  const double hook = hook_length(stroke);
  if (brush.endings && length > 0) {
    const BrushZones at = zones_of(brush, stroke.ending, length, hook);
    const auto step = [scale](double reach, int least) {
      return std::max(1e-3, reach / std::clamp(reach * scale / 1.5, static_cast<double>(least), 96.0));
    };
    const Zone zones[] = {{0, at.entry_end, step(at.entry_end, 8)},
                          {at.ending_start, at.body_end, step(at.body_end - at.ending_start, 12)},
                          {at.body_end, length, step(length - at.body_end, 12)}};
    line = subdivide(line, zones);
  }

  std::vector<Joint> joints(line.size());
  std::vector<double> turns(line.size(), 0.0);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const GlyphPoint before = i > 0 ? unit(line[i].at - line[i - 1].at) : GlyphPoint{};
    const GlyphPoint after = i + 1 < line.size() ? unit(line[i + 1].at - line[i].at) : GlyphPoint{};
    const GlyphPoint forward = unit(before + after);
    const BrushMark mark = brush_at(brush, stroke.ending, line[i].s, length, hook);
    Joint& joint = joints[i];
    joint = {line[i].at.x * scale,    line[i].at.y * scale,    forward.x, forward.y,
             mark.half_width * scale, mark.depth / brush.depth};
    if (i > 0 && i + 1 < line.size()) turns[i] = angle_between(before, after);
  }
  mark_tight_bends(line, turns, scale, joints);

  if (brush.endings && hook > 0) {
    // The walls of a hook converge so fast that a disc would stick out of them.
    for (std::size_t i = 0; i < line.size(); ++i)
      if (line[i].s > length - hook) joints[i].needs_disc = false;
  }
  std::vector<Piece> pieces;
  const std::vector<std::size_t> split = corners(line, 0.6 * brush.width / 2);
  Piece piece;
  double turned = 0;
  double s_of_tight = -1e9;  // where the line last bent tightly
  std::size_t next_corner = 0;
  const double clear = 1.2 * brush.width;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    piece.joints.push_back(joints[i]);
    turned += turns[i];
    if (joints[i].needs_disc) s_of_tight = line[i].s;
    const bool last = i + 1 == joints.size();
    const bool corner = next_corner < split.size() && split[next_corner] == i;
    bool level = false;
    if (!last && turned > kLongPiece && line[i].s > s_of_tight + clear) {
      // A long bend is split where it is gentle and no corner is near, so that a line that crosses itself
      // crosses a different piece.
      level = next_corner >= split.size() || line[split[next_corner]].s > line[i].s + clear;
      for (std::size_t k = i; level && k < joints.size() && line[k].s < line[i].s + clear; ++k)
        level = !joints[k].needs_disc;
      if (line.back().s < line[i].s + clear) level = false;
    }
    if (!last && !corner && !level) continue;
    piece.round_end = !level;
    if (corner || last) {
      // At a corner each side ends at a right angle to its own direction.
      Joint& end = piece.joints.back();
      end.needs_disc = false;
      if (i > 0) {
        const GlyphPoint own = unit(line[i].at - line[i - 1].at);
        end.forward_x = own.x;
        end.forward_y = own.y;
      }
    }
    pieces.push_back(std::move(piece));
    piece = {};
    turned = 0;
    if (last) break;
    if (corner) ++next_corner;
    piece.round_start = !level;
    Joint start = joints[i];
    if (corner) {
      const GlyphPoint own = unit(line[i + 1].at - line[i].at);
      start.forward_x = own.x;
      start.forward_y = own.y;
      start.needs_disc = false;
    }
    piece.joints.push_back(start);
  }
  return pieces;
}

}  // namespace nazori::carving
