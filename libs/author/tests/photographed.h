// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "nazori/author/own_stroke.h"
#include "nazori/geometry/polyline.h"
#include "nazori/scan/picture.h"

namespace nazori::author::test {

/// How a drawing is photographed.
struct Shot {
  int width = 640;
  int height = 480;
  double left = 90;  ///< place of the glyph box [pixels]
  double top = 40;
  double scale = 3.6;        ///< pixels per glyph unit
  double turn_rad = 0;       ///< clockwise, around the middle of the glyph box
  double paper = 235;        ///< brightness at the left edge
  double paper_right = 235;  ///< and at the right edge
  double ink = 25;
  double blur = 0.7;  ///< half the width of the soft edge [pixels]
  double noise = 0;   ///< standard deviation of the brightness

  [[nodiscard]] geometry::GlyphPoint turned(geometry::GlyphPoint p) const {
    const double u = p.x - geometry::kGlyphSide / 2;
    const double v = p.y - geometry::kGlyphSide / 2;
    const double c = std::cos(turn_rad);
    const double s = std::sin(turn_rad);
    return {geometry::kGlyphSide / 2 + c * u - s * v, geometry::kGlyphSide / 2 + s * u + c * v};
  }
};

/// Strokes in ink: each pixel by its distance from the discs along the lines.
inline scan::Photo photographed(std::span<const OwnStroke> strokes, const Shot& shot) {
  const auto count = static_cast<std::size_t>(shot.width) * static_cast<std::size_t>(shot.height);
  std::vector<double> inside(count, -100);  // pixels within the rim
  for (const OwnStroke& stroke : strokes) {
    for (std::size_t i = 0; i + 1 < std::max<std::size_t>(2, stroke.points.size()); ++i) {
      const GroovePoint& a = stroke.points[i];
      const GroovePoint& b = stroke.points[std::min(i + 1, stroke.points.size() - 1)];
      const auto place = [&](const GroovePoint& p) {
        const auto q = shot.turned(p.at);
        return geometry::GridPoint{shot.left + q.x * shot.scale, shot.top + q.y * shot.scale};
      };
      const geometry::GridPoint from = place(a);
      const geometry::GridPoint to = place(b);
      const double most = std::max(a.half_width, b.half_width) * shot.scale + 4;
      const auto limit = [](double v, int side) { return std::clamp(static_cast<int>(v), 0, side - 1); };
      for (int y = limit(std::min(from.y, to.y) - most, shot.height);
           y <= limit(std::max(from.y, to.y) + most, shot.height); ++y)
        for (int x = limit(std::min(from.x, to.x) - most, shot.width);
             x <= limit(std::max(from.x, to.x) + most, shot.width); ++x) {
          const geometry::GridPoint p{static_cast<double>(x), static_cast<double>(y)};
          const double t = geometry::nearest_share(p, from, to);
          const double half = (a.half_width + (b.half_width - a.half_width) * t) * shot.scale;
          double& value = inside[static_cast<std::size_t>(y) * static_cast<std::size_t>(shot.width) +
                                 static_cast<std::size_t>(x)];
          value = std::max(value, half - geometry::distance(from + (to - from) * t, p));
        }
    }
  }
  std::mt19937 random(7);
  // A sum of twelve even numbers is nearly normal, and the same on every machine.
  const auto normal = [&random] {
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += static_cast<double>(random()) / 4294967296.0;
    return sum;
  };
  scan::Photo photo{shot.width, shot.height, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i % static_cast<std::size_t>(shot.width)) / shot.width;
    const double paper = shot.paper + (shot.paper_right - shot.paper) * share;
    const double dark = std::clamp(0.5 + inside[i] / (2 * shot.blur), 0.0, 1.0);
    const double value =
        paper * (1 - dark * (1 - shot.ink / 255)) + (shot.noise > 0 ? shot.noise * normal() : 0);
    photo.grey.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)));
  }
  return photo;
}

/// A stroke of one width, or of one that changes evenly from its start to its end.
inline OwnStroke drawn(const geometry::Polyline<geometry::GlyphFrame>& line, double half_width, double last) {
  OwnStroke stroke;
  const std::span<const geometry::GlyphPoint> all(line);
  const double length = geometry::arc_length(all);
  double before = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) before += geometry::distance(line[i - 1], line[i]);
    stroke.points.push_back(
        {line[i], length > 0 ? half_width + (last - half_width) * before / length : half_width, 1});
  }
  return stroke;
}
inline OwnStroke drawn(const geometry::Polyline<geometry::GlyphFrame>& line, double half_width) {
  return drawn(line, half_width, half_width);
}

}  // namespace nazori::author::test
