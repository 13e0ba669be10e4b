// SPDX-License-Identifier: Apache-2.0
#include "nazori/carving/groove.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "centre_line.h"
#include "relief.h"
#include "stroke_set.h"

namespace nazori::carving {
namespace {

using base::Errc;

base::Result<void> check(std::span<const Groove> grooves) {
  constexpr double kFarthest = 10 * geometry::kGlyphSide;
  const auto is_near = [](double v) { return v >= -kFarthest && v <= geometry::kGlyphSide + kFarthest; };
  for (std::size_t i = 0; i < grooves.size(); ++i) {
    const std::string name = "stroke " + std::to_string(i + 1);
    if (grooves[i].empty()) return base::fail(Errc::bad_argument, "has no points", name);
    for (std::size_t k = 0; k < grooves[i].size(); ++k) {
      const GroovePoint& p = grooves[i][k];
      const std::string where = name + ", point " + std::to_string(k + 1);
      if (!is_near(p.at.x) || !is_near(p.at.y)) {
        return base::fail(Errc::bad_argument,
                          "is at (" + std::to_string(p.at.x) + ", " + std::to_string(p.at.y) + ")", where,
                          "points must be finite and within 10 boxes of the glyph box");
      }
      if (!(p.half_width >= 0 && p.half_width <= kWidestHalf)) {
        return base::fail(Errc::bad_argument, "its half width is " + std::to_string(p.half_width), where,
                          "give 0 to 20 glyph units");
      }
      if (!(p.depth >= 0 && p.depth <= 1)) {
        return base::fail(Errc::bad_argument, "its depth is " + std::to_string(p.depth), where,
                          "give 0 to 1");
      }
    }
  }
  return {};
}

}  // namespace

GridBox united(const GridBox& a, const GridBox& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

GridBox common(const GridBox& a, const GridBox& b) {
  const GridBox box{std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
                    std::min(a.bottom, b.bottom)};
  return box.is_empty() ? GridBox{} : box;
}

GridBox whole_map(int size) { return {0, 0, size, size}; }

GridBox box_of(const Groove& groove, int size) {
  // The cross lines of a joint are oblique to its segments, so the ends of a segment reach beyond the half
  // width.
  constexpr double kLean = 1.5;
  double left = std::numeric_limits<double>::infinity();
  double top = left;
  double right = -left;
  double bottom = -left;
  for (const Piece& piece : trace(groove, size)) {
    for (const Joint& joint : piece.joints) {
      const double reach = joint.half_width * kLean;
      left = std::min(left, joint.x - reach);
      right = std::max(right, joint.x + reach);
      top = std::min(top, joint.y - reach);
      bottom = std::max(bottom, joint.y + reach);
    }
  }
  const auto whole = [size](double v) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(size)));
  };
  const GridBox box{whole(std::floor(left)), whole(std::floor(top)), whole(std::ceil(right) + 1),
                    whole(std::ceil(bottom) + 1)};
  return box.is_empty() ? GridBox{} : box;
}

base::Result<surface::HeightMap> carve_grooves(std::span<const Groove> grooves, int size) {
  auto map = surface::HeightMap::create(size);
  if (!map) return map;
  if (auto done = carve_grooves_in(whole_map(size), grooves, *map); !done)
    return tl::unexpected(std::move(done).error());
  return map;
}

base::Result<void> carve_grooves_in(const GridBox& box, std::span<const Groove> grooves,
                                    surface::HeightMap& map) {
  if (auto fit = check(grooves); !fit) return fit;
  if (box.is_empty()) return {};
  const int size = map.size();
  assert(common(box, whole_map(size)) == box);
  const auto row_of = [&](int y) {
    return map.samples().subspan(
        static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(box.left),
        static_cast<std::size_t>(box.right - box.left));
  };
  for (int y = box.top; y < box.bottom; ++y) std::ranges::fill(row_of(y), 0.0F);
  Relief relief(map.samples(), size, box);
  for (const Groove* groove : groove_set(grooves))
    for (const Piece& piece : trace(*groove, size)) relief.cut(piece);
  for (int y = box.top; y < box.bottom; ++y)
    for (float& sample : row_of(y)) sample = 1.0F - std::sqrt(std::min(std::max(sample, 0.0F), 1.0F));
  return {};
}

}  // namespace nazori::carving
