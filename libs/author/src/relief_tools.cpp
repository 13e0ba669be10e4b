// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/relief_tools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hand_layer.h"
#include "nazori/geometry/frames.h"
#include "pen_line.h"

namespace nazori::author {
namespace {

using base::Errc;
using carving::GridBox;
using geometry::GlyphPoint;
using Pen = geometry::WrittenStroke<geometry::GlyphFrame>;

base::Result<void> refuse(std::string what, std::string where, std::string remedy = {}) {
  return base::fail(Errc::bad_argument, std::move(what), std::move(where), std::move(remedy));
}

base::Result<void> check_layer(const surface::HeightMap& map, const HandLayer& hand) {
  if (!map.is_loaded()) return refuse("is empty", "map");
  if (!hand.is_untouched() && hand.size != map.size())
    return refuse("has another size than the map", "hand", "give one of the map's size");
  return {};
}

base::Result<void> check_tool(const ToolSettings& settings, const Pen& pen) {
  if (!(settings.width >= 0.5 && settings.width <= 40))
    return refuse("is out of range", "width", "give 0.5 to 40 glyph units");
  if (!(settings.depth > 0 && settings.depth <= 1))
    return refuse("is out of range", "depth", "give more than 0, at most 1");
  if (pen.size() > kMostToolPoints)
    return refuse("has too many points", "pen", "give at most " + std::to_string(kMostToolPoints));
  constexpr double kFarthest = 2 * geometry::kGlyphSide;
  const auto is_near = [](double v) { return v >= -kFarthest && v <= kFarthest; };
  for (const auto& p : pen)
    if (!is_near(p.at.x) || !is_near(p.at.y)) return refuse("is too far from the picture", "pen");
  return {};
}

GlyphPoint mirrored(GlyphPoint p) { return {geometry::kGlyphSide - p.x, p.y}; }

carving::Groove mirrored(carving::Groove groove) {
  for (carving::GroovePoint& p : groove) p.at = mirrored(p.at);
  return groove;
}

/// The way of the tool as grooves, whose depth says how strongly the tool works.
std::vector<carving::Groove> ways_of(const ToolSettings& settings, const Pen& pen) {
  constexpr double kTolerance = 0.05;
  carving::Groove way;
  for (const auto& p : pen) {
    const double pressure = pressure_of(p);
    way.push_back({p.at, settings.width / 2 * (0.5 + 0.5 * pressure), settings.depth * pressure});
  }
  way = settings.straight && way.size() > 2 ? carving::Groove{way.front(), way.back()}
                                            : simplified(way, kTolerance);
  std::vector<carving::Groove> ways{std::move(way)};
  if (settings.mirrored) ways.push_back(mirrored(ways.front()));
  return ways;
}

/// A height that is cut by a groove of depth `cut`: they join as the grooves of strokes do.
float cut_into(float height, float cut) {
  const float square = (1 - height) * (1 - height);
  const float other = cut * cut;
  return 1 - std::sqrt(std::min(square + other - square * other, 1.0F));
}

/// Means of the map over squares around samples. Sums are whole numbers of 2^-24, so their order does not
/// matter.
class Means {
 public:
  /// @param box  of the samples that will be asked for. @param radius  half of the square's side.
  Means(const surface::HeightMap& map, const GridBox& box, int radius)
      : area_(carving::common({box.left - radius, box.top - radius, box.right + radius, box.bottom + radius},
                              carving::whole_map(map.size()))),
        radius_(radius),
        width_(static_cast<std::size_t>(area_.right - area_.left) + 1),
        sums_(width_ * (static_cast<std::size_t>(area_.bottom - area_.top) + 1), 0) {
    for (int row = area_.top; row < area_.bottom; ++row) {
      std::int64_t line = 0;
      for (int column = area_.left; column < area_.right; ++column) {
        line += std::lround(static_cast<double>(map.at(column, row)) * kUnit);
        sums_[index(column + 1, row + 1)] = sums_[index(column + 1, row)] + line;
      }
    }
  }

  [[nodiscard]] float at(int column, int row) const {
    const int left = std::max(column - radius_, area_.left);
    const int right = std::min(column + radius_ + 1, area_.right);
    const int top = std::max(row - radius_, area_.top);
    const int bottom = std::min(row + radius_ + 1, area_.bottom);
    const std::int64_t sum = sums_[index(right, bottom)] - sums_[index(left, bottom)] -
                             sums_[index(right, top)] + sums_[index(left, top)];
    return static_cast<float>(static_cast<double>(sum) / kUnit /
                              (static_cast<double>(right - left) * (bottom - top)));
  }

 private:
  static constexpr double kUnit = 1 << 24;
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row - area_.top) * width_ + static_cast<std::size_t>(column - area_.left);
  }
  GridBox area_;
  int radius_;
  std::size_t width_;
  std::vector<std::int64_t> sums_;
};

/// Changes a layer sample by sample, and keeps track of what changed. An untouched layer is made only where
/// something changes.
class LayerWriter {
 public:
  LayerWriter(HandLayer& hand, int size) : hand_(hand), size_(size) {}

  [[nodiscard]] float at(int column, int row) const {
    return hand_.is_untouched() ? 0.0F : hand_.heights[sample_index(size_, column, row)];
  }
  void set(int column, int row, float height) {
    height = std::clamp(height, -1.0F, 1.0F);
    if (height == at(column, row)) return;
    if (hand_.is_untouched()) {
      hand_.size = size_;
      hand_.heights.assign(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_), 0.0F);
    }
    hand_.heights[sample_index(size_, column, row)] = height;
    changed_ = carving::united(changed_, {column, row, column + 1, row + 1});
  }
  [[nodiscard]] const GridBox& changed() const { return changed_; }

 private:
  HandLayer& hand_;
  int size_;
  GridBox changed_;
};

/// How deep a stamp is at a place of its square, 0..1. @param u,v  0..1.
float stamp_depth(const surface::HeightMap& stamp, double u, double v) {
  const double x = u * (stamp.size() - 1);
  const double y = v * (stamp.size() - 1);
  const int left = std::min(static_cast<int>(x), stamp.size() - 2);
  const int top = std::min(static_cast<int>(y), stamp.size() - 2);
  const double a = x - left;
  const double b = y - top;
  const auto at = [&stamp](int c, int r) { return static_cast<double>(stamp.at(c, r)); };
  const double upper = at(left, top) * (1 - a) + at(left + 1, top) * a;
  const double lower = at(left, top + 1) * (1 - a) + at(left + 1, top + 1) * a;
  return static_cast<float>(1 - (upper * (1 - b) + lower * b));
}

/// A groove, and its mirror image.
std::vector<carving::Groove> both_halves(const carving::Groove& groove) { return {groove, mirrored(groove)}; }

surface::HeightMap draw_stamp(StampShape shape) {
  constexpr int kSide = 65;
  constexpr double kHalfWidth = 14;
  constexpr double kMiddle = geometry::kGlyphSide / 2;
  const auto line = [](std::vector<GlyphPoint> points) {
    carving::Groove groove;
    for (const GlyphPoint p : points) groove.push_back({p, kHalfWidth, 1});
    return groove;
  };
  std::vector<carving::Groove> grooves;
  switch (shape) {
    case StampShape::dot:
      grooves = {{{{kMiddle, kMiddle}, carving::kWidestHalf, 1}}};
      break;
    case StampShape::ring: {
      std::vector<GlyphPoint> half;
      for (int i = 0; i <= 12; ++i) {
        const double angle = i * 3.14159265358979323846 / 12;
        half.push_back({kMiddle + 38 * std::sin(angle), kMiddle - 38 * std::cos(angle)});
      }
      grooves = both_halves(line(std::move(half)));
      break;
    }
    case StampShape::bar:
      grooves = {line({{16, kMiddle}, {93, kMiddle}})};
      break;
    case StampShape::cross:
      grooves = {line({{16, kMiddle}, {93, kMiddle}}), line({{kMiddle, 16}, {kMiddle, 93}})};
      break;
    case StampShape::square:
      grooves = both_halves(line({{kMiddle, 18}, {91, 18}, {91, 91}, {kMiddle, 91}}));
      break;
    case StampShape::triangle:
      grooves = both_halves(line({{kMiddle, 18}, {91, 89}, {kMiddle, 89}}));
      break;
  }
  return carving::carve_grooves(grooves, kSide).value();
}

}  // namespace

base::Result<GridBox> use_tool(ReliefTool tool, const ToolSettings& settings, const Pen& pen,
                               const surface::HeightMap& map, HandLayer& hand) {
  if (auto fit = check_layer(map, hand); !fit) return tl::unexpected(std::move(fit).error());
  if (auto fit = check_tool(settings, pen); !fit) return tl::unexpected(std::move(fit).error());
  if (pen.empty()) return GridBox{};
  const int size = map.size();
  const std::vector<carving::Groove> ways = ways_of(settings, pen);
  GridBox box;
  for (const carving::Groove& way : ways) box = carving::united(box, carving::box_of(way, size));
  if (box.is_empty()) return GridBox{};
  auto strength = surface::HeightMap::create(size);
  if (!strength) return tl::unexpected(std::move(strength).error());
  if (auto done = carving::carve_grooves_in(box, ways, *strength); !done)
    return tl::unexpected(std::move(done).error());

  const int radius =
      std::max(1, static_cast<int>(std::lround(settings.width / 8 * (size - 1) / geometry::kGlyphSide)));
  const Means means(map, tool == ReliefTool::smooth ? box : GridBox{}, radius);
  LayerWriter layer(hand, size);
  for (int row = box.top; row < box.bottom; ++row) {
    for (int column = box.left; column < box.right; ++column) {
      const float share = 1 - strength->at(column, row);
      if (!(share > 0)) continue;
      const float height = map.at(column, row);
      const float before = layer.at(column, row);
      switch (tool) {
        case ReliefTool::groove:
          layer.set(column, row, before + (cut_into(height, share) - height));
          break;
        case ReliefTool::raise:
          layer.set(column, row, before + (std::min(height + share, 1.0F) - height));
          break;
        case ReliefTool::smooth:
          layer.set(column, row, before + share * (means.at(column, row) - height));
          break;
        case ReliefTool::erase:
          layer.set(column, row, before * (1 - share));
          break;
      }
    }
  }
  return layer.changed();
}

const surface::HeightMap& stamp_of(StampShape shape) {
  static const std::array<surface::HeightMap, std::size(kStampShapes)> kStamps = [] {
    std::array<surface::HeightMap, std::size(kStampShapes)> stamps;
    for (std::size_t i = 0; i < stamps.size(); ++i) stamps[i] = draw_stamp(kStampShapes[i]);
    return stamps;
  }();
  return kStamps.at(static_cast<std::size_t>(shape));
}

base::Result<GridBox> press_stamp(const surface::HeightMap& stamp, const StampSettings& settings,
                                  GlyphPoint at, const surface::HeightMap& map, HandLayer& hand) {
  const auto fail = [](base::Result<void> refused) { return tl::unexpected(std::move(refused).error()); };
  if (auto fit = check_layer(map, hand); !fit) return fail(std::move(fit));
  if (!stamp.is_loaded()) return fail(refuse("is empty", "stamp"));
  if (!(settings.size >= 1 && settings.size <= geometry::kGlyphSide))
    return fail(refuse("is out of range", "size", "give 1 to 109 glyph units"));
  if (!(settings.depth > 0 && settings.depth <= 1))
    return fail(refuse("is out of range", "depth", "give more than 0, at most 1"));
  const auto is_near = [](double v) { return v >= -geometry::kGlyphSide && v <= 2 * geometry::kGlyphSide; };
  if (!is_near(at.x) || !is_near(at.y)) return fail(refuse("is too far from the picture", "place"));

  const int size = map.size();
  const double scale = (size - 1) / geometry::kGlyphSide;
  const double half = settings.size / 2 * scale;
  const auto box_around = [&](GlyphPoint middle) {
    const geometry::GridPoint m = geometry::glyph_to_grid(middle, size);
    return carving::common(
        {static_cast<int>(std::ceil(m.x - half)), static_cast<int>(std::ceil(m.y - half)),
         static_cast<int>(std::floor(m.x + half)) + 1, static_cast<int>(std::floor(m.y + half)) + 1},
        carving::whole_map(size));
  };
  const auto depth_at = [&](GlyphPoint middle, int column, int row, bool flipped) {
    const geometry::GridPoint m = geometry::glyph_to_grid(middle, size);
    double u = (column - m.x) / (2 * half) + 0.5;
    const double v = (row - m.y) / (2 * half) + 0.5;
    if (flipped) u = 1 - u;
    const bool inside = u >= 0 && u <= 1 && v >= 0 && v <= 1;
    return inside ? stamp_depth(stamp, u, v) : 0.0F;
  };
  GridBox box = box_around(at);
  if (settings.mirrored) box = carving::united(box, box_around(mirrored(at)));
  LayerWriter layer(hand, size);
  const auto full = static_cast<float>(settings.depth);
  for (int row = box.top; row < box.bottom; ++row) {
    for (int column = box.left; column < box.right; ++column) {
      float share = depth_at(at, column, row, false);
      if (settings.mirrored) share = std::max(share, depth_at(mirrored(at), column, row, true));
      share *= full;
      if (!(share > 0)) continue;
      const float height = map.at(column, row);
      const float changed = settings.raised ? std::min(height + share, 1.0F) : cut_into(height, share);
      layer.set(column, row, layer.at(column, row) + (changed - height));
    }
  }
  return layer.changed();
}

}  // namespace nazori::author
