// SPDX-License-Identifier: Apache-2.0
#include "centre_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "brush.h"
#include "line_nodes.h"
#include "nazori/geometry/frames.h"
#include "width_profile.h"

namespace nazori::carving {
namespace {

using geometry::GlyphPoint;

constexpr double kPi = 3.14159265358979323846;
constexpr double kSplit = 50 * kPi / 180;  // a bend that turns by more within a groove's width is a corner
constexpr double kLongPiece = 120 * kPi / 180;

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

namespace {

/// As fine as the samples, and at least `least` steps over `reach`.
double step_over(double reach, double scale, int least) {
  return std::max(1e-3, reach / std::clamp(reach * scale / 1.5, static_cast<double>(least), 96.0));
}

/// A line with the brush at each of its nodes.
struct MarkedLine {
  std::vector<Node> nodes;
  std::vector<BrushMark> marks;
};

MarkedLine mark_stroke(const kanji::StrokeLine& stroke, const Brush& brush, int size, Detail detail) {
  const double scale = (size - 1) / geometry::kGlyphSide;
  MarkedLine line{smooth_nodes(stroke.points, size, detail), {}};
  const double length = line.nodes.back().s;
  const double hook = hook_length(stroke);
  if (brush.endings && length > 0) {
    const BrushZones at = zones_of(brush, stroke.ending, length, hook);
    const Zone zones[] = {{0, at.entry_end, step_over(at.entry_end, scale, 8)},
                          {at.ending_start, at.body_end, step_over(at.body_end - at.ending_start, scale, 12)},
                          {at.body_end, length, step_over(length - at.body_end, scale, 12)}};
    line.nodes = subdivide(line.nodes, zones);
  }
  line.marks.reserve(line.nodes.size());
  for (const Node& node : line.nodes)
    line.marks.push_back(brush_at(brush, stroke.ending, node.s, length, hook));
  return line;
}

/// The groove at the nodes at which a point was given.
WidthProfile profile_of(const std::vector<Node>& line, const Groove& groove) {
  std::vector<WidthKnot> knots_of_width;
  for (const Node& node : line) {
    if (node.given < 0) continue;
    const GroovePoint& point = groove[static_cast<std::size_t>(node.given)];
    knots_of_width.push_back({node.s, point.half_width, point.depth});
  }
  return WidthProfile(std::move(knots_of_width));
}

/// @param least_steps  between two points of different width. @param scale  steps of 1.5 / scale there.
/// @param longest_step  everywhere.
MarkedLine mark_groove(const Groove& groove, int size, double scale, int least_steps, double longest_step) {
  std::vector<GlyphPoint> points;
  points.reserve(groove.size());
  for (const GroovePoint& point : groove) points.push_back(point.at);
  MarkedLine line{smooth_nodes(points, size, Detail::smooth), {}};
  const WidthProfile profile = profile_of(line.nodes, groove);
  std::vector<Zone> zones;
  const std::span<const WidthKnot> knots_of_width = profile.knots();
  if (std::isfinite(longest_step)) zones.push_back({0, line.nodes.back().s, longest_step});
  for (std::size_t i = 0; i + 1 < knots_of_width.size(); ++i) {
    const WidthKnot& a = knots_of_width[i];
    const WidthKnot& b = knots_of_width[i + 1];
    if (a.half_width != b.half_width || a.depth != b.depth)
      zones.push_back({a.s, b.s, step_over(b.s - a.s, scale, least_steps)});
  }
  if (line.nodes.size() > 1) line.nodes = subdivide(line.nodes, zones);
  line.marks.reserve(line.nodes.size());
  for (const Node& node : line.nodes) line.marks.push_back(profile.at(node.s));
  return line;
}

struct JoinedLine {
  std::vector<Joint> joints;
  std::vector<double> turns;
};

/// @param full  depth of the brush.
JoinedLine joints_of(const MarkedLine& line, double scale, double full) {
  JoinedLine out{std::vector<Joint>(line.nodes.size()), std::vector<double>(line.nodes.size(), 0.0)};
  for (std::size_t i = 0; i < line.nodes.size(); ++i) {
    const GlyphPoint at = line.nodes[i].at;
    const GlyphPoint before = i > 0 ? unit(at - line.nodes[i - 1].at) : GlyphPoint{};
    const GlyphPoint after = i + 1 < line.nodes.size() ? unit(line.nodes[i + 1].at - at) : GlyphPoint{};
    const GlyphPoint forward = unit(before + after);
    const BrushMark& mark = line.marks[i];
    out.joints[i] = {at.x * scale,     at.y * scale, forward.x, forward.y, mark.half_width * scale,
                     mark.depth / full};
    if (i > 0 && i + 1 < line.nodes.size()) out.turns[i] = angle_between(before, after);
  }
  mark_tight_bends(line.nodes, out.turns, scale, out.joints);
  return out;
}

/// @param width  of the body of the groove, glyph units.
std::vector<Piece> pieces_of(const std::vector<Node>& line, const JoinedLine& joined, double width) {
  const std::vector<Joint>& joints = joined.joints;
  const std::vector<double>& turns = joined.turns;
  std::vector<Piece> pieces;
  const std::vector<std::size_t> split = corners(line, 0.6 * width / 2);
  Piece piece;
  double turned = 0;
  double s_of_tight = -1e9;  // where the line last bent tightly
  std::size_t next_corner = 0;
  const double clear = 1.2 * width;
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

}  // namespace

std::vector<Piece> trace(const kanji::StrokeLine& stroke, const Brush& brush, int size, Detail detail) {
  const double scale = (size - 1) / geometry::kGlyphSide;
  const MarkedLine line = mark_stroke(stroke, brush, size, detail);
  JoinedLine joined = joints_of(line, scale, brush.depth);
  const double hook = hook_length(stroke);
  if (brush.endings && hook > 0) {
    // The walls of a hook converge so fast that a disc would stick out of them.
    const double hook_start = line.nodes.back().s - hook;
    for (std::size_t i = 0; i < line.nodes.size(); ++i)
      if (line.nodes[i].s > hook_start) joined.joints[i].needs_disc = false;
  }
  return pieces_of(line.nodes, joined, brush.width);
}

std::vector<Piece> trace(const Groove& groove, int size) {
  const double scale = (size - 1) / geometry::kGlyphSide;
  const MarkedLine line = mark_groove(groove, size, scale, 4, std::numeric_limits<double>::infinity());
  JoinedLine joined = joints_of(line, scale, 1.0);
  // As in a hook, a disc would stick out of walls that converge fast.
  constexpr double kFast = 0.05;
  for (std::size_t i = 0; i + 1 < line.nodes.size(); ++i) {
    const double narrows = line.marks[i].half_width - line.marks[i + 1].half_width;
    if (narrows > kFast * (line.nodes[i + 1].s - line.nodes[i].s)) joined.joints[i].needs_disc = false;
  }
  return pieces_of(line.nodes, joined, 2 * profile_of(line.nodes, groove).usual_half_width());
}

std::vector<SmoothPoint> smooth_line(const Groove& groove) {
  constexpr int kSize = 1024;
  constexpr double kStep = 1;
  const MarkedLine line = mark_groove(groove, kSize, 1.5 / kStep, 2, kStep);
  std::vector<SmoothPoint> out;
  out.reserve(line.nodes.size());
  std::size_t segment = 0;
  for (std::size_t i = 0; i < line.nodes.size(); ++i) {
    const Node& node = line.nodes[i];
    if (node.given >= 0) segment = static_cast<std::size_t>(node.given);
    out.push_back({node.at, line.marks[i].half_width, line.marks[i].depth, segment, node.s});
  }
  return out;
}

Groove groove_of(const kanji::StrokeLine& stroke, const Brush& brush) {
  constexpr int kSize = 1024;
  // How far the groove between two points may be from that of the brush: glyph units, and share of the depth.
  constexpr double kWidthTolerance = 0.012;
  constexpr double kDepthTolerance = 0.002;
  const MarkedLine line = mark_stroke(stroke, brush, kSize, Detail::smooth);
  std::vector<bool> kept(line.nodes.size(), false);
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = line.nodes[i].given >= 0;
  // The worst place gets a point until all are near enough.
  while (true) {
    std::vector<WidthKnot> knots_of_width;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (kept[i]) knots_of_width.push_back({line.nodes[i].s, line.marks[i].half_width, line.marks[i].depth});
    const WidthProfile profile(std::move(knots_of_width));
    double worst = 1;
    std::size_t at = kept.size();
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (kept[i]) continue;
      const BrushMark mark = profile.at(line.nodes[i].s);
      const double off = std::max(std::abs(mark.half_width - line.marks[i].half_width) / kWidthTolerance,
                                  std::abs(mark.depth - line.marks[i].depth) / kDepthTolerance);
      if (off <= worst) continue;
      worst = off;
      at = i;
    }
    if (at == kept.size()) break;
    kept[at] = true;
  }
  Groove groove;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) groove.push_back({line.nodes[i].at, line.marks[i].half_width, line.marks[i].depth});
  return groove;
}

}  // namespace nazori::carving
