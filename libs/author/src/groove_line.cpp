// SPDX-License-Identifier: Apache-2.0
#include "groove_line.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "nazori/geometry/frames.h"
#include "nazori/geometry/polyline.h"

namespace nazori::author {
namespace {

using geometry::GridPoint;

GridPoint unit(GridPoint v) {
  const double l = geometry::length(v);
  return l > 0 ? v * (1 / l) : GridPoint{};
}

GridLine evenly(const GridLine& line, double spacing) {
  const double length = geometry::arc_length<geometry::GridFrame>(line);
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(length / spacing))) + 1;
  return geometry::resample<geometry::GridFrame>(line, count);
}

/// Means of each point and its neighbours on both sides, fewer towards the ends.
GridLine with_means(const GridLine& line, std::size_t reach) {
  GridLine out = line;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const std::size_t r = std::min({reach, i, line.size() - 1 - i});
    GridPoint sum;
    double weights = 0;
    for (std::size_t k = i - r; k <= i + r; ++k) {
      const double off = (static_cast<double>(k) - static_cast<double>(i)) / static_cast<double>(r + 1);
      const double w = 1 - off * off;
      sum = sum + line[k] * w;
      weights += w;
    }
    out[i] = sum * (1 / weights);
  }
  return out;
}

/// From a point across the line to the rim of the ink; nothing where it is farther than `most`.
std::optional<double> to_rim(const InkMap& map, GridPoint from, GridPoint across, double most) {
  constexpr double kStep = 0.5;
  double before = static_cast<double>(between(map.level, from));
  if (before <= 1) return 0.0;
  // The walls of a groove end level, so their roots are straight near the rim: where the depth is four times
  // the limit and where it is the limit say where it is nothing.
  double at_four = 0;
  for (double d = kStep; d <= most; d += kStep) {
    const GridPoint p = from + across * d;
    if (p.x < 0 || p.y < 0 || p.x > kInkSide - 1 || p.y > kInkSide - 1) return d;
    const double now = static_cast<double>(between(map.level, p));
    const auto crosses = [&](double limit) { return d - kStep * (limit - now) / (before - now); };
    if (before > 4 && now <= 4) at_four = crosses(4);
    if (now <= 1) {
      const double rim = crosses(1);
      return map.is_groove ? rim + (rim - at_four) * (at_four > 0 ? 1 : 0) : rim;
    }
    before = now;
  }
  return {};
}

/// Widths where they are not known, because other ink is there: between known ones straight from one to the
/// other; at an end those that narrow towards it go on to narrow. Without any known one nothing changes.
void fill_gaps(std::vector<std::optional<double>>& widths, const GridLine& line) {
  constexpr double kLook = 16;  // samples over which the slope is taken
  std::vector<double> at(line.size());
  for (std::size_t i = 1; i < line.size(); ++i) at[i] = at[i - 1] + geometry::distance(line[i - 1], line[i]);
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < widths.size(); ++i)
    if (widths[i]) known.push_back(i);
  if (known.empty()) return;
  for (std::size_t n = 0; n + 1 < known.size(); ++n)
    for (std::size_t k = known[n] + 1; k < known[n + 1]; ++k) {
      const double t = (at[k] - at[known[n]]) / std::max(at[known[n + 1]] - at[known[n]], 1e-9);
      widths[k] = *widths[known[n]] * (1 - t) + *widths[known[n + 1]] * t;
    }
  const auto go_on = [&](std::size_t first, const auto& each_unknown, const auto& in_reach) {
    double slope = 0;
    for (const std::size_t i : known)
      if (in_reach(i)) slope = std::max(slope, (*widths[i] - *widths[first]) / std::abs(at[i] - at[first]));
    const double start = *widths[first];
    each_unknown(
        [&](std::size_t k) { widths[k] = std::max(0.0, start - slope * std::abs(at[k] - at[first])); });
  };
  const std::size_t last = known.back();
  const std::size_t first = known.front();
  const auto reaches = [&](std::size_t from) {
    return [&, from](std::size_t i) {
      const double d = std::abs(at[i] - at[from]);
      return d > kLook / 2 && d <= kLook;
    };
  };
  go_on(
      last,
      [&](const auto& use) {
        for (std::size_t k = last + 1; k < line.size(); ++k) use(k);
      },
      reaches(last));
  go_on(
      first,
      [&](const auto& use) {
        for (std::size_t k = 0; k < first; ++k) use(k);
      },
      reaches(first));
}

}  // namespace

GridLine smoothed(const GridLine& line, double spacing) {
  if (line.size() < 3) return line;
  constexpr std::size_t kReach = 4;
  return evenly(with_means(with_means(evenly(line, 1.0), kReach), kReach), spacing);
}

std::vector<Corner> corners_of(const GridLine& line, double reach) {
  constexpr double kLeast = 40 * 3.14159265358979323846 / 180;
  std::vector<Corner> corners;
  if (line.size() < 5) return corners;
  const double step = geometry::arc_length<geometry::GridFrame>(line) / static_cast<double>(line.size() - 1);
  if (step <= 0) return corners;
  const auto r = static_cast<std::size_t>(std::max(2.0, std::round(reach / step)));
  std::vector<double> turns(line.size());
  for (std::size_t i = 2; i + 2 < line.size(); ++i) {
    const std::size_t before = i - std::min(r, i);
    const std::size_t after = std::min(i + r, line.size() - 1);
    turns[i] = geometry::angle_between(line[i] - line[before], line[after] - line[i]);
  }
  for (std::size_t i = 2; i + 2 < line.size(); ++i) {
    if (turns[i] < kLeast) continue;
    const auto from = turns.begin() + static_cast<std::ptrdiff_t>(i - std::min(r, i));
    const auto to = turns.begin() + static_cast<std::ptrdiff_t>(std::min(i + r + 1, turns.size()));
    const auto most = std::max_element(from, to);
    if (most == turns.begin() + static_cast<std::ptrdiff_t>(i)) corners.push_back({i, turns[i]});
  }
  return corners;
}

void centre_ends(GridLine& line, const InkMap& map, bool front, bool back) {
  constexpr double kThinsOut = 0.8;  // of the width farther inside
  constexpr double kOtherInk = 1.6;  // of the width, ahead
  constexpr double kUneven = 1.3;    // one side to the other
  if (line.size() < 3) return;
  for (const bool at_front : {true, false}) {
    if (!(at_front ? front : back)) continue;
    if (at_front) std::reverse(line.begin(), line.end());
    const double at_end = static_cast<double>(between(map.distance.distance, line.back()));
    // Beside the line a radius inside, where the round end has begun nowhere.
    std::size_t inside = line.size() - 1;
    while (inside > 0 && geometry::distance(line[inside], line.back()) < std::max(3.0, 0.8 * at_end))
      --inside;
    const GridPoint out = unit(line.back() - line[inside]);
    const GridPoint side{-out.y, out.x};
    const auto left = to_rim(map, line[inside], side, 3 * at_end + 4);
    const auto right = to_rim(map, line[inside], side * -1, 3 * at_end + 4);
    const auto ahead = to_rim(map, line.back(), out, 3 * at_end + 4);
    if (left && right && ahead && std::max(*left, *right) < kUneven * std::min(*left, *right) + 1) {
      const double radius = (*left + *right) / 2;
      const double shift = *ahead - radius;
      if (at_end > kThinsOut * radius - 1 && *ahead < kOtherInk * radius) {
        const GridPoint end = line.back() + out * shift;
        while (line.size() > 2 && geometry::dot(end - line[line.size() - 2], out) < 1) line.pop_back();
        line.back() = end;
      }
    }
    if (at_front) std::reverse(line.begin(), line.end());
  }
}

OwnStroke groove_along(const GridLine& line, const InkMap& map) {
  OwnStroke stroke;
  std::vector<std::optional<double>> widths(line.size());
  std::vector<double> known;
  for (std::size_t i = 0; i < line.size(); ++i) {
    // Directions over some points, so that a bend does not turn the ray into the next wall.
    const GridPoint along =
        unit(line[std::min(i + 2, line.size() - 1)] - line[i - std::min<std::size_t>(i, 2)]);
    const GridPoint across{-along.y, along.x};
    if (along == GridPoint{}) continue;
    const auto left = to_rim(map, line[i], across, 60);
    const auto right = to_rim(map, line[i], across * -1, 60);
    if (!left || !right) continue;
    const double less = std::min(*left, *right);
    const double more = std::max(*left, *right);
    if (more < 1.35 * less + 2) widths[i] = (less + more) / 2;
    if (widths[i]) known.push_back(*widths[i]);
  }
  if (!known.empty()) {
    const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
    std::nth_element(known.begin(), middle, known.end());
    const double usual = *middle;
    for (auto& w : widths)
      if (w && *w > 1.7 * usual) w.reset();
  }
  fill_gaps(widths, line);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double half =
        widths[i] ? *widths[i] : static_cast<double>(between(map.distance.distance, line[i])) - 0.5;
    constexpr float kLeastDepth = 0.01F;
    const float depth = std::clamp(between(map.depth, line[i]), kLeastDepth, 1.0F);
    stroke.points.push_back({geometry::grid_to_glyph(line[i], kInkSide), std::max(half, 0.1) / kInkPerUnit,
                             static_cast<double>(depth)});
  }
  return stroke;
}

void lengthen_tips(OwnStroke& stroke) {
  // Glyph units. Nearest the tip the groove is too shallow for its width to be seen.
  constexpr double kMost = 3.0;
  constexpr double kNear = 1.0;
  constexpr double kLook = 2.0;
  constexpr double kFar = 5.0;
  constexpr double kLeastSlope = 0.1;
  constexpr double kNarrower = 0.7;
  for (const bool at_front : {true, false}) {
    const std::size_t count = stroke.points.size();
    const auto at = [&](std::size_t i) -> const GroovePoint& {
      return at_front ? stroke.points[i] : stroke.points[count - 1 - i];
    };
    double length = 0;
    std::optional<std::size_t> near;
    double near_length = 0;
    double slope = 0;
    double widest = 0;
    for (std::size_t i = 1; i < count && length < kFar; ++i) {
      length += geometry::distance(at(i - 1).at, at(i).at);
      if (!near && length >= kNear) {
        near = i;
        near_length = length;
      }
      widest = std::max(widest, at(i).half_width);
      // Beside a sharp hook the width is that of both parts, so the steepest slope counts.
      if (near && length - near_length >= kLook)
        slope = std::max(slope, (at(i).half_width - at(*near).half_width) / (length - near_length));
    }
    if (!near) continue;
    const double width = at(*near).half_width;
    if (slope < kLeastSlope || width > kNarrower * widest) continue;
    const double beyond = std::clamp(width / slope - near_length, 0.0, kMost);
    const geometry::GlyphPoint way = at(0).at - at(*near).at;
    const double way_length = geometry::length(way);
    if (way_length <= 0 || beyond <= 0) continue;
    const GroovePoint tip{at(0).at + way * (beyond / way_length), 0.1 / kInkPerUnit, at(0).depth};
    stroke.points.insert(at_front ? stroke.points.begin() : stroke.points.end(), tip);
  }
}

}  // namespace nazori::author
