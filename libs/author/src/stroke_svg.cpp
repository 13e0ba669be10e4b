// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/stroke_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include "nazori/geometry/needed_points.h"
#include "nazori/geometry/polyline.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;

constexpr double kTolerance = 0.08;
constexpr double kBow = 0.12;
constexpr double kCorner = 40 * 3.14159265358979323846 / 180;

std::string path_data(const geometry::BezierPath& path) {
  std::string data = fmt::format("M{:.2f},{:.2f}", path.start.x, path.start.y);
  for (const auto& piece : path.pieces)
    fmt::format_to(std::back_inserter(data), "C{:.2f},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f}", piece[0].x,
                   piece[0].y, piece[1].x, piece[1].y, piece[2].x, piece[2].y);
  return data;
}

}  // namespace

geometry::BezierPath path_of(const OwnStroke& stroke) {
  std::vector<GlyphPoint> all;
  for (const GroovePoint& p : stroke.points) all.push_back(p.at);
  std::vector<GlyphPoint> points;
  for (const std::size_t i : geometry::needed_points<GlyphPoint>(all, kTolerance)) points.push_back(all[i]);
  geometry::BezierPath path{points.front(), {}};
  if (points.size() == 1) path.pieces.push_back({points[0], points[0], points[0]});
  const auto unit = [](GlyphPoint v) {
    const double l = geometry::length(v);
    return l > 0 ? v * (1 / l) : GlyphPoint{};
  };
  // The direction at a point is that of the circle through it and its neighbours; ends and corners have none.
  std::vector<std::optional<GlyphPoint>> direction(points.size());
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const GlyphPoint before = points[i] - points[i - 1];
    const GlyphPoint after = points[i + 1] - points[i];
    if (geometry::angle_between(before, after) > kCorner) continue;
    direction[i] = unit(unit(before) * geometry::length(after) + unit(after) * geometry::length(before));
  }
  const auto arm = [&](std::size_t i, std::size_t other) {
    const GlyphPoint chord = points[other] - points[i];
    const GlyphPoint along = unit(chord);
    const double forward = other > i ? 1 : -1;
    GlyphPoint way = along;
    if (direction[i]) {
      way = *direction[i] * forward;
    } else if (direction[other]) {
      // As at the other end of the chord, on the other side of it.
      const GlyphPoint mirrored = *direction[other] * forward;
      way = along * (2 * geometry::dot(mirrored, along)) - mirrored;
    }
    // Between two points the line is as good as straight, so the curve may not bow out by more.
    const double length = geometry::length(chord);
    const double most = 2 * std::atan(2 * kBow / std::max(length, 1e-9));
    const double turn = geometry::angle_between(along, way);
    if (turn > most) {
      const GlyphPoint side = unit(way - along * geometry::dot(way, along));
      way = along * std::cos(most) + side * std::sin(most);
    }
    // That long, the curve is nearly the arc of a circle.
    return way * (length * 2 / (3 * (1 + std::max(0.0, geometry::dot(way, along)))));
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    path.pieces.push_back({points[i] + arm(i, i + 1), points[i + 1] + arm(i + 1, i), points[i + 1]});
  return path;
}

std::string to_svg(std::span<const OwnStroke> strokes) {
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"109\" height=\"109\" viewBox=\"0 0 109 109\">\n"
      "<g id=\"StrokePaths\" style=\"fill:none;stroke:#000000;stroke-width:3;stroke-linecap:round;"
      "stroke-linejoin:round;\">\n";
  for (std::size_t k = 0; k < strokes.size(); ++k)
    text += fmt::format("<path id=\"s{}\" d=\"{}\"/>\n", k + 1, path_data(path_of(strokes[k])));
  text += "</g>\n<g id=\"StrokeNumbers\" style=\"font-size:8;fill:#808080\">\n";
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    // Beside the start, inside the picture.
    const GlyphPoint start = strokes[k].points.front().at;
    const GlyphPoint beside{std::clamp(start.x - 8, 0.0, 101.0), std::clamp(start.y + 1, 8.0, 108.0)};
    const GlyphPoint at = strokes[k].number_position.value_or(beside);
    text += fmt::format("<text transform=\"matrix(1 0 0 1 {:.2f} {:.2f})\">{}</text>\n", at.x, at.y, k + 1);
  }
  return text + "</g>\n</svg>\n";
}

}  // namespace nazori::author
