// SPDX-License-Identifier: Apache-2.0
#include "brush.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "centre_line.h"
#include "nazori/geometry/polyline.h"
#include "stroke_set.h"

namespace nazori::carving {
namespace {

using geometry::GlyphPoint;

// Lengths of the presses in widths of the brush, and how much wider they are than the body.
constexpr double kEntryReach = 0.9;
constexpr double kEntryPress = 0.08;
constexpr double kStopReach = 1.1;
constexpr double kStopPress = 0.15;
// Part of a stroke over which the brush is lifted in a sweep.
constexpr double kTaperShare = 1.0 / 3.0;
constexpr double kNarrowest = 3.0;
// A turn that starts a hook [rad], the largest part of a stroke that a hook may be, and, where the line has
// no such turn, its length in glyph units and at most in parts of the stroke.
constexpr double kSharp = 50 * 3.14159265358979323846 / 180;
constexpr double kLongestHookShare = 0.5;
constexpr double kLongestHook = 14.0;
constexpr double kPlainHook = 7.0;
constexpr double kPlainHookShare = 0.25;

/// 1 at 0, level there and at 1, 0 from 1 on.
double bump(double t) {
  const double u = std::max(0.0, 1 - t * t);
  return u * u;
}

/// Depth of a brush that is being lifted, u from 0 (down) to 1 (away): level at both ends.
double lift(double u) {
  const double v = 1 - u;
  return v * v * (3 - 2 * v);
}

/// Width of a brush that is being lifted: constant at first, then narrowing to a point.
double narrowing(double u) { return (1 - u) * (1 + u - 0.6 * u * u); }

/// Width of a brush in a hook after a stop: level at the stop, where its round end is still visible, then
/// narrowing to a point.
double kick_narrowing(double u) { return 1 - u * u * (1.5 - 0.5 * u); }

}  // namespace

BrushZones zones_of(const Brush& brush, kanji::StrokeEnding ending, double length, double hook_length) {
  const double hook =
      ending == kanji::StrokeEnding::hook && brush.endings ? std::clamp(hook_length, 0.0, length) : 0.0;
  BrushZones zones{};
  zones.body_end = length - hook;
  zones.entry_end = std::min(kEntryReach * brush.width, zones.body_end);
  zones.ending_start = ending == kanji::StrokeEnding::taper
                           ? length * (1 - kTaperShare)
                           : std::max(0.0, zones.body_end - kStopReach * brush.width);
  return zones;
}

BrushMark brush_at(const Brush& brush, kanji::StrokeEnding ending, double s, double length,
                   double hook_length) {
  BrushMark mark{brush.width / 2, brush.depth};
  if (!brush.endings) return mark;
  s = std::clamp(s, 0.0, length);
  const BrushZones zones = zones_of(brush, ending, length, hook_length);
  if (zones.entry_end > 0) mark.half_width *= 1 + kEntryPress * bump(s / zones.entry_end);
  if (ending == kanji::StrokeEnding::taper) {
    const double u = length > 0 ? (s - zones.ending_start) / (length - zones.ending_start) : 0.0;
    if (u > 0) {
      mark.half_width *= narrowing(u);
      mark.depth *= lift(u);
    }
    return mark;
  }
  if (s <= zones.body_end) {
    const double reach = zones.body_end - zones.ending_start;
    if (reach > 0) mark.half_width *= 1 + kStopPress * bump((zones.body_end - s) / reach);
  } else {
    const double u = (s - zones.body_end) / (length - zones.body_end);
    mark.half_width *= (1 + kStopPress) * kick_narrowing(u);
    mark.depth *= lift(std::pow(u, 1.4));
  }
  return mark;
}

double hook_length(const kanji::StrokeLine& line) {
  if (line.ending != kanji::StrokeEnding::hook) return 0;
  const std::span<const GlyphPoint> points(line.points);
  const double length = geometry::arc_length(points);
  // A hook drawn with a corner is found over a short distance, one drawn with a rounded bend only over a
  // longer one.
  constexpr double kCloseReach = 2.5;
  constexpr double kFarReach = 6.0;
  for (const double reach : {kCloseReach, kFarReach}) {
    double tail = 0;
    double best_turn = kSharp;
    double best_tail = 0;
    for (std::size_t i = points.size(); i-- > 2;) {
      tail += geometry::distance(points[i - 1], points[i]);
      if (tail > std::min(kLongestHook, kLongestHookShare * length)) break;
      if (best_tail > 0 && tail > best_tail + reach) break;
      const double turn = turn_at(points, i - 1, reach);
      if (turn <= best_turn) continue;
      best_turn = turn;
      best_tail = tail;
    }
    if (best_tail > 0) return best_tail;
  }
  return std::min(kPlainHook, length * kPlainHookShare);
}

double suggested_width(std::span<const kanji::StrokeLine> strokes) {
  // The lines as short steps, each with its direction; the neighbours of a step are the steps of other
  // strokes beside it.
  struct Step {
    GlyphPoint at;
    GlyphPoint forward;
    std::size_t stroke;
  };
  constexpr double kSpacing = 2.0;
  constexpr std::size_t kMostSteps = 1500;
  const std::vector<const kanji::StrokeLine*> set = stroke_set(strokes);
  double total = 0;
  for (const kanji::StrokeLine* line : set)
    total += geometry::arc_length(std::span<const GlyphPoint>(line->points));
  if (!std::isfinite(total)) return kWidest;
  const double spacing = std::max(kSpacing, total / static_cast<double>(kMostSteps));
  std::vector<Step> steps;
  for (std::size_t k = 0; k < set.size() && steps.size() < 2 * kMostSteps; ++k) {
    double until_next = spacing / 2;
    const auto& points = set[k]->points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double length = geometry::distance(points[i], points[i + 1]);
      if (length <= 0) continue;
      const GlyphPoint forward = (points[i + 1] - points[i]) * (1 / length);
      while (until_next < length) {
        steps.push_back({points[i] + forward * until_next, forward, k});
        until_next += spacing;
      }
      until_next -= length;
    }
  }
  if (steps.empty()) return kWidest;
  // Steps of one line (a stroke that goes on where another ended) are not neighbours.
  constexpr double kSameLine = 2.0;
  constexpr double kParallel = 0.94;
  std::vector<double> gaps(steps.size(), 2 * kWidest);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (std::size_t j = i + 1; j < steps.size(); ++j) {
      const GlyphPoint d = steps[j].at - steps[i].at;
      if (std::abs(d.x) > kWidest || std::abs(d.y) > kWidest || steps[i].stroke == steps[j].stroke) continue;
      if (std::abs(geometry::dot(steps[i].forward, steps[j].forward)) < kParallel) continue;
      if (std::abs(geometry::dot(steps[i].forward, d)) > spacing * 0.75) continue;
      const double gap = std::abs(steps[i].forward.x * d.y - steps[i].forward.y * d.x);
      if (gap < kSameLine) continue;
      gaps[i] = std::min(gaps[i], gap);
      gaps[j] = std::min(gaps[j], gap);
    }
  }
  constexpr double kCrowdedShare = 0.05;
  constexpr double kWidthPerGap = 1.0;
  const auto crowded =
      gaps.begin() + static_cast<std::ptrdiff_t>(kCrowdedShare * static_cast<double>(gaps.size()));
  std::nth_element(gaps.begin(), crowded, gaps.end());
  // Strokes at different angles crowd a character too, so limit the share of the box that they cover.
  constexpr double kWidthPerLength = 0.5 * 85.0 * 85.0;
  return std::clamp(std::min(kWidthPerGap * *crowded, kWidthPerLength / total), kNarrowest, kWidest);
}

Brush fitted(const Brush& brush, std::span<const kanji::StrokeLine> strokes) {
  Brush out = brush;
  if (brush.fit) out.width = std::min(brush.width, suggested_width(strokes));
  out.fit = false;
  return out;
}

}  // namespace nazori::carving
