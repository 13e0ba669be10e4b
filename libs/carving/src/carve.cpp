// SPDX-License-Identifier: Apache-2.0
#include "nazori/carving/carve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "centre_line.h"
#include "relief.h"
#include "stroke_set.h"

namespace nazori::carving {
namespace {

using base::Errc;

/// With more points than this in all strokes, curves are sampled no finer than the grid shows. No character
/// has a tenth of it; a file of strokes may have 65 million.
constexpr std::size_t kMostSmooth = 50'000;

base::Result<void> check(const Brush& brush) {
  if (!(brush.width >= 0.5 && brush.width <= 40)) {
    return base::fail(Errc::bad_argument, "the brush is " + std::to_string(brush.width) + " glyph units wide",
                      "brush.width", "give 0.5 to 40");
  }
  if (!(brush.depth > 0 && brush.depth <= 1)) {
    return base::fail(Errc::bad_argument, "the brush goes " + std::to_string(brush.depth) + " deep",
                      "brush.depth", "give more than 0, at most 1");
  }
  return {};
}

base::Result<void> check(std::span<const kanji::StrokeLine> strokes) {
  constexpr double kFarthest = 10 * geometry::kGlyphSide;
  const auto is_near = [](double v) { return v >= -kFarthest && v <= geometry::kGlyphSide + kFarthest; };
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const std::string name = "stroke " + std::to_string(i + 1);
    if (strokes[i].points.empty()) return base::fail(Errc::bad_argument, "has no points", name);
    for (const geometry::GlyphPoint p : strokes[i].points) {
      if (is_near(p.x) && is_near(p.y)) continue;
      return base::fail(Errc::bad_argument,
                        "has a point at (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")", name,
                        "points must be finite and within 10 boxes of the glyph box");
    }
  }
  return {};
}

}  // namespace

base::Result<surface::HeightMap> carve(std::span<const kanji::StrokeLine> strokes, int size,
                                       const Brush& brush) {
  if (auto fit = check(brush); !fit) return tl::unexpected(std::move(fit).error());
  if (auto fit = check(strokes); !fit) return tl::unexpected(std::move(fit).error());
  auto map = surface::HeightMap::create(size, 0.0F);
  if (!map) return map;

  const Brush used = fitted(brush, strokes);
  Relief relief(map->samples(), size, brush.cross_section);
  const auto set = stroke_set(strokes);
  std::size_t points = 0;
  for (const kanji::StrokeLine* stroke : set) points += stroke->points.size();
  const Detail detail = points > kMostSmooth ? Detail::samples : Detail::smooth;
  for (const kanji::StrokeLine* stroke : set)
    for (const Piece& piece : trace(*stroke, used, size, detail)) relief.cut(piece);

  const auto depth = static_cast<float>(brush.depth);
  for (float& sample : map->samples())
    sample = 1.0F - depth * std::sqrt(std::min(std::max(sample, 0.0F), 1.0F));
  return map;
}

}  // namespace nazori::carving
