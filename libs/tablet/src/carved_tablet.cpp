// SPDX-License-Identifier: Apache-2.0
#include "nazori/tablet/carved_tablet.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "nazori/geometry/polyline.h"
#include "nazori/surface/ball_surface.h"

namespace nazori::tablet {
namespace {

using geometry::GlyphPoint;

// 0.5 glyph units are 0.46 mm on a tablet of 100 mm: the rise of a hook, which takes a few units, is sampled
// to a hundredth of the depth. A stroke file may hold millions of long segments, so the total is bounded too.
constexpr double kStep = 0.5;
constexpr double kMostSteps = 200'000;

/// A location on a stroke's line.
struct Place {
  GlyphPoint point;
  double s;  ///< arc length from the start [glyph units]
};

/// The line with all its points and, between them, more points, so that no two neighbours are further apart
/// than `step`.
std::vector<Place> walk(const TabletLine& line, double step) {
  std::vector<Place> places;
  if (line.points.empty()) return places;
  places.push_back({line.points.front(), 0});
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const GlyphPoint from = line.points[i];
    const GlyphPoint along = line.points[i + 1] - from;
    const double length = geometry::length(along);
    const double before = places.back().s;
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int k = 1; k < pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      places.push_back({from + along * t, before + length * t});
    }
    places.push_back({line.points[i + 1], before + length});
  }
  return places;
}

/// The sampling distance for all strokes.
double step_for(std::span<const TabletLine> lines) {
  double length = 0;
  for (const TabletLine& line : lines) length += geometry::arc_length<geometry::GlyphFrame>(line.points);
  return std::max(kStep, length / kMostSteps);
}

haptics::Vec3 in_tablet(GlyphPoint p, double z_m, const geometry::TabletShape& shape) {
  const geometry::TabletPoint at = geometry::glyph_to_tablet(p, shape);
  return {at.x, at.y, z_m};
}

/// One path for each line; `depth_of_line` gives, by a line's index, the depth of its groove at a location,
/// as a fraction of the tablet's depth.
template <class DepthOfLine>
std::vector<haptics::StrokePath> paths_of(std::span<const TabletLine> lines,
                                          const geometry::TabletShape& shape, DepthOfLine depth_of_line) {
  const double step = step_for(lines);
  std::vector<haptics::StrokePath> paths;
  paths.reserve(lines.size());
  for (const TabletLine& line : lines) {
    const std::vector<Place> places = walk(line, step);
    const auto depth_at = depth_of_line(paths.size(), places.empty() ? 0.0 : places.back().s);
    haptics::StrokePath path;
    path.points.reserve(places.size());
    for (const Place& place : places) {
      path.points.push_back(in_tablet(place.point, -depth_at(place) * shape.depth_m, shape));
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

base::Result<void> check_shape(const geometry::TabletShape& shape) {
  if (!(shape.width_m > 0) || !std::isfinite(shape.width_m) || !(shape.depth_m > 0) ||
      !std::isfinite(shape.depth_m)) {
    return base::fail(base::Errc::bad_argument, "the tablet has no width or no depth", "shape",
                      "give both in metres, above 0");
  }
  return {};
}

base::Result<void> check_lines(std::span<const TabletLine> lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const GlyphPoint p : lines[i].points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
        return base::fail(base::Errc::bad_argument, "a point is not a number",
                          "stroke " + std::to_string(i + 1));
      }
    }
  }
  return {};
}

}  // namespace

base::Result<std::shared_ptr<const CarvedTablet>> CarvedTablet::from_lines(
    std::vector<TabletLine> lines, int size, const carving::Brush& brush,
    const geometry::TabletShape& shape) {
  if (auto ok = check_shape(shape); !ok) return tl::unexpected(std::move(ok.error()));
  const std::vector<kanji::StrokeLine> strokes = stroke_lines(lines);
  auto map = carving::carve(strokes, size, brush);
  if (!map) return tl::unexpected(std::move(map.error()));
  auto surface = surface::SmoothSurface::create(*map);
  if (!surface) return tl::unexpected(std::move(surface.error()));

  std::shared_ptr<CarvedTablet> tablet(new CarvedTablet);
  const carving::Brush carved = carving::fitted(brush, strokes);
  tablet->lines_ = std::move(lines);
  tablet->paths_ = paths_of(tablet->lines_, shape, [&](std::size_t line, double length) {
    const double hook = carving::hook_length(strokes[line]);
    return [&carved, ending = strokes[line].ending, length, hook](const Place& place) {
      return carving::brush_at(carved, ending, place.s, length, hook).depth;
    };
  });
  tablet->map_ = std::move(*map);
  tablet->shape_ = shape;
  tablet->surface_ = std::move(*surface);
  return tablet;
}

base::Result<std::shared_ptr<const CarvedTablet>> CarvedTablet::from_height_map(
    surface::HeightMap map, std::vector<TabletLine> lines, const geometry::TabletShape& shape,
    std::shared_ptr<const haptics::FrictionZones> friction, std::vector<geometry::Label> labels) {
  if (auto ok = check_shape(shape); !ok) return tl::unexpected(std::move(ok.error()));
  if (auto ok = check_lines(lines); !ok) return tl::unexpected(std::move(ok.error()));
  if (friction && friction->size != map.size())
    return base::fail(base::Errc::bad_argument, "the zones of friction are not as many as the samples",
                      "friction", "give one for each sample");
  auto surface = surface::SmoothSurface::create(map);
  if (!surface) return tl::unexpected(std::move(surface.error()));

  std::shared_ptr<CarvedTablet> tablet(new CarvedTablet);
  const int size = map.size();
  tablet->paths_ = paths_of(lines, shape, [&](std::size_t, double) {
    return [&relief = **surface, size](const Place& place) {
      const geometry::GridPoint at = geometry::glyph_to_grid(place.point, size);
      return std::clamp(1 - relief.at(at.x, at.y).height, 0.0, 1.0);
    };
  });
  tablet->map_ = std::move(map);
  tablet->lines_ = std::move(lines);
  tablet->shape_ = shape;
  tablet->friction_ = std::move(friction);
  tablet->labels_ = std::move(labels);
  tablet->surface_ = std::move(*surface);
  return tablet;
}

base::Result<std::shared_ptr<const CarvedTablet>> CarvedTablet::with_tip(double radius_m) const {
  if (!(radius_m >= 0 && radius_m <= surface::kLargestBall_m))
    return base::fail(base::Errc::bad_argument, "no tip has this radius", "radius", "give 0 to 3 mm");
  std::shared_ptr<CarvedTablet> tablet(new CarvedTablet(*this));
  tablet->felt_ = nullptr;
  tablet->tip_radius_m_ = radius_m;
  if (radius_m > 0) {
    auto felt = surface::surface_for_ball(map_, shape_, radius_m);
    if (!felt) return tl::unexpected(std::move(felt.error()));
    tablet->felt_ = std::move(*felt);
  }
  return tablet;
}

std::shared_ptr<const haptics::HapticScene> CarvedTablet::scene(const haptics::Material& material,
                                                                const haptics::Snapping& snapping,
                                                                const haptics::Guiding& guiding) const {
  auto scene = std::make_shared<haptics::HapticScene>();
  scene->surface = felt_ ? felt_ : surface_;
  scene->tip_radius_m = tip_radius_m_;
  scene->shape = shape_;
  scene->material = material;
  scene->friction_zones = friction_;
  scene->strokes = paths_;
  scene->snapping = snapping;
  scene->guiding = guiding;
  return scene;
}

}  // namespace nazori::tablet
