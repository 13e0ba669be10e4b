// SPDX-License-Identifier: Apache-2.0
#include "stroke_guess.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "nazori/geometry/polyline.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;
using geometry::GridPoint;
using kanji::StrokeEnding;

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;

GridPoint unit(GridPoint v) {
  const double l = geometry::length(v);
  return l > 0 ? v * (1 / l) : GridPoint{};
}

/// For each pixel whether it is paper that is enclosed by ink.
std::vector<std::uint8_t> holes_of(const InkMap& map) {
  std::vector<std::uint8_t> hole(map.ink.size());
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < hole.size(); ++i) hole[i] = map.ink[i] == 0 ? 1 : 0;
  const auto visit = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= kInkSide || y >= kInkSide || hole[map.index(x, y)] == 0) return;
    hole[map.index(x, y)] = 0;
    open.push_back(map.index(x, y));
  };
  for (int k = 0; k < kInkSide; ++k) {
    visit(k, 0);
    visit(k, kInkSide - 1);
    visit(0, k);
    visit(kInkSide - 1, k);
  }
  while (!open.empty()) {
    const int x = static_cast<int>(open.back() % kInkSide);
    const int y = static_cast<int>(open.back() / kInkSide);
    open.pop_back();
    visit(x + 1, y);
    visit(x - 1, y);
    visit(x, y + 1);
    visit(x, y - 1);
  }
  return hole;
}

/// What a brush does at a corner.
enum class Turning : std::uint8_t {
  lift,   ///< another stroke begins
  fold,   ///< from the left, then down or to the lower left: ┐ フ
  angle,  ///< from the upper right, then to the right or the lower right: く ム
  bend,   ///< from above, then to the right: └
};

/// @param a,b  unit vectors from the corner along its arms. @param hole  whether the corner is one of a
/// closed shape.
Turning turning_of(GridPoint a, GridPoint b, bool hole) {
  const auto is = [&](GridPoint p, double degrees, double within) {
    const GridPoint q{std::cos(degrees * kDegree), std::sin(degrees * kDegree)};
    return geometry::angle_between(p, q) < within * kDegree;
  };
  // In any order, because nobody knows yet from which end the line is written.
  const auto arms = [&](double first, double within_first, double second, double within_second) {
    return (is(a, first, within_first) && is(b, second, within_second)) ||
           (is(b, first, within_first) && is(a, second, within_second));
  };
  if (arms(180, 40, 110, 45)) return Turning::fold;
  if (arms(-65, 40, 45, 22) || arms(-50, 22, -5, 22)) return Turning::angle;
  // Closed shapes are closed by a stroke of its own.
  if (arms(-85, 30, 0, 30)) return hole ? Turning::lift : Turning::bend;
  return Turning::lift;
}

/// A corner of a line and its arms.
struct Bent {
  std::size_t point = 0;
  GridPoint before;  ///< unit vectors away from the corner
  GridPoint after;
  Turning turning = Turning::lift;
};

std::vector<Bent> bent_at(const GridLine& line, double radius, const InkMap& map,
                          const std::vector<std::uint8_t>& hole) {
  constexpr double kHook = 14 * kInkPerUnit;
  constexpr double kLeastTurn = 50 * kDegree;
  std::vector<Bent> out;
  const double step = line.size() > 1 ? geometry::distance(line[0], line[1]) : 1.0;
  for (const Corner& corner : corners_of(line, std::max(8.0, 1.8 * radius))) {
    const std::size_t i = corner.point;
    const auto look = static_cast<std::size_t>(std::max(3.0, 2.5 * radius / step));
    Bent bent{i, unit(line[i - std::min(look, i)] - line[i]),
              unit(line[std::min(i + look, line.size() - 1)] - line[i])};
    if (std::max(corner.turn, kPi - geometry::angle_between(bent.before, bent.after)) < kLeastTurn) continue;
    // A short arm that thins out is a hook.
    const auto is_hook = [&](std::size_t points, GridPoint end) {
      return static_cast<double>(points) * step < kHook &&
             static_cast<double>(between(map.distance.distance, end)) < 0.5 * radius;
    };
    if (is_hook(i, line.front()) || is_hook(line.size() - 1 - i, line.back())) continue;
    const GridPoint inside = line[i] + (bent.before + bent.after) * (1.3 * radius + 2);
    const bool is_hole = inside.x >= 0 && inside.y >= 0 && inside.x < kInkSide - 1 &&
                         inside.y < kInkSide - 1 &&
                         hole[map.index(static_cast<int>(inside.x), static_cast<int>(inside.y))] != 0;
    bent.turning = turning_of(bent.before, bent.after, is_hole);
    out.push_back(bent);
  }
  // く is not written after ┐ without lifting the brush: the right side of 阝.
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (out[k].turning != Turning::angle) continue;
    const bool upper_is_before = out[k].before.y < out[k].after.y;
    if (upper_is_before ? k > 0 && out[k - 1].turning == Turning::fold
                        : k + 1 < out.size() && out[k + 1].turning == Turning::fold)
      out[k].turning = Turning::lift;
  }
  return out;
}

}  // namespace

std::vector<GridLine> divided(const std::vector<GridLine>& lines, const InkMap& map) {
  const std::vector<std::uint8_t> hole = holes_of(map);
  std::vector<GridLine> out;
  for (const GridLine& raw : lines) {
    const GridLine line = smoothed(raw);
    const double radius = static_cast<double>(between(map.distance.distance, line[line.size() / 2]));
    const double step = line.size() > 1 ? geometry::distance(line[0], line[1]) : 1.0;
    std::size_t begin = 0;
    for (const Bent& bent : bent_at(line, radius, map, hole)) {
      if (bent.turning != Turning::lift) continue;
      const std::size_t i = bent.point;
      // What is shorter than it is wide is the rim of the other part.
      if (static_cast<double>(i - begin) * step > radius)
        out.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(begin),
                         line.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      begin = i;
    }
    if (begin == 0 || static_cast<double>(line.size() - 1 - begin) * step > radius)
      out.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(begin), line.end());
  }
  return out;
}

StrokeEnding ending_of_ink(const OwnStroke& stroke) {
  const std::size_t count = stroke.points.size();
  if (count < 4) return StrokeEnding::stop;
  std::vector<double> widths;
  std::vector<double> at(count);  // distance to the end
  for (std::size_t i = count - 1; i-- > 0;)
    at[i] = at[i + 1] + geometry::distance(stroke.points[i].at, stroke.points[i + 1].at);
  const double length = at[0];
  if (length <= 0) return StrokeEnding::stop;
  for (std::size_t i = 0; i < count; ++i)
    if (at[i] > 0.3 * length) widths.push_back(stroke.points[i].half_width);
  std::nth_element(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2),
                   widths.end());
  const double body = widths[widths.size() / 2];
  if (stroke.points.back().half_width > 0.62 * body) return StrokeEnding::stop;
  // A hook: the last sharp turn lies in the last 15 units.
  std::vector<GlyphPoint> line;
  for (const GroovePoint& p : stroke.points) line.push_back(p.at);
  constexpr double kLongestHook = 15;
  constexpr double kReach = 3.0;
  for (std::size_t i = count - 1; i-- > 1 && at[i] < std::min(kLongestHook, 0.55 * length);) {
    if (at[i] < 1.5) continue;
    const std::span<const GlyphPoint> all(line);
    const GlyphPoint before = geometry::point_at(all, length - at[i] - kReach);
    const GlyphPoint after = geometry::point_at(all, length - std::max(0.0, at[i] - kReach));
    if (geometry::angle_between(line[i] - before, after - line[i]) > 42 * kDegree) return StrokeEnding::hook;
  }
  // Both thin out: a hook within at most 7 units or a quarter, a sweep over a third.
  double narrowing = 0;
  for (std::size_t i = count; i-- > 0 && at[i] < 0.6 * length;)
    if (stroke.points[i].half_width < 0.85 * body)
      narrowing = at[i];
    else if (at[i] > narrowing + 2)
      break;
  const double hook = std::min(7.0, 0.25 * length);
  return narrowing < 0.80 * hook && length > 21 ? StrokeEnding::hook : StrokeEnding::taper;
}

OwnStroke turned_round(OwnStroke stroke) {
  std::reverse(stroke.points.begin(), stroke.points.end());
  return stroke;
}

void direct(OwnStroke& stroke) {
  constexpr double kThin = 0.45;  // of the other end
  const double first = stroke.points.front().half_width;
  const double last = stroke.points.back().half_width;
  const GlyphPoint way = stroke.points.back().at - stroke.points.front().at;
  double down = 0;
  double right = 0;
  for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
    const GlyphPoint d = stroke.points[i + 1].at - stroke.points[i].at;
    down += d.y;
    right += d.x;
  }
  // A falling line is written down, a flat one to the right; what falls to the left at less than 35 degrees
  // is flat.
  bool is_backwards = down + 0.7 * right < 0;
  if (std::abs(way.x) < 1e-9 && std::abs(way.y) < 1e-9) is_backwards = false;
  if (first < kThin * last) is_backwards = true;
  if (last < kThin * first) is_backwards = false;
  if (is_backwards) stroke = turned_round(std::move(stroke));
}

void put_in_order(std::vector<OwnStroke>& strokes) {
  const auto key = [](const OwnStroke& s) {
    const GlyphPoint at = s.points.front().at;
    return at.y + 0.45 * at.x;
  };
  std::stable_sort(strokes.begin(), strokes.end(),
                   [&](const OwnStroke& a, const OwnStroke& b) { return key(a) < key(b); });
}

}  // namespace nazori::author
