// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "dashes.h"
#include "distance_grid.h"
#include "layers.h"
#include "nazori/functions/tablet_curves.h"
#include "plate_settings.h"

namespace nazori::functions {
namespace {

// The ripple that marks a region for touch: one wave per this share of the plate; its lowest and highest
// share of the depth.
constexpr double kRipple = 0.012;
constexpr double kRippleLow = 0.10;
constexpr double kRippleHigh = 0.25;
constexpr double kDash = 0.022;

/// Raised cosine: 1 on the centre line, 0 from the half width on.
double profile(double distance, double half_width) {
  if (distance >= half_width) return 0;
  return 0.5 * (1 + std::cos(std::numbers::pi * distance / half_width));
}

/// Bumps on the floor of a groove, as a share of the depth: 0 for the first curve and on the walls, so that
/// the groove is as wide as without.
double texture(std::size_t sample, int size, int statement, double depth) {
  constexpr double kWall = 0.7;
  constexpr double kBump = 0.15;
  const double period = feel_of(statement).texture_period;
  if (period == 0 || depth <= kWall) return 0;
  const auto n = static_cast<std::size_t>(size);
  const double column = static_cast<double>(sample % n) / size;
  const double row = static_cast<double>(sample / n) / size;
  const double wave =
      std::cos(2 * std::numbers::pi * column / period) * std::cos(2 * std::numbers::pi * row / period);
  return kBump * (0.5 + 0.5 * wave) * (depth - kWall) / (1 - kWall);
}

/// Whether a piece touches the window itself, not only the margin around it.
bool touches_window(PlatePoint p, PlatePoint q) {
  constexpr double kHair = 1e-9;
  double from = 0;
  double to = 1;
  for (const auto& [start, step] : {std::pair{p.u, q.u - p.u}, std::pair{p.v, q.v - p.v}}) {
    if (std::abs(step) < 1e-300) {
      if (start < -kHair || start > 1 + kHair) return false;
      continue;
    }
    const double a = (-kHair - start) / step;
    const double b = (1 + kHair - start) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}

bool touches_window(const Branch& branch) {
  for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
    const CurvePoint& a = branch.points[i];
    const CurvePoint& b = branch.points[i + 1];
    if (touches_window(PlatePoint{a.u, a.v}, PlatePoint{b.u, b.v})) return true;
  }
  return false;
}

/// Only the parts that belong to one statement.
void keep_alone(Tracing& tracing, int statement) {
  const auto other = [statement](const auto& part) { return part.statement != statement; };
  std::erase_if(tracing.branches, other);
  std::erase_if(tracing.bars, other);
  std::erase_if(tracing.dots, other);
  std::erase_if(tracing.fills, other);
  std::erase_if(tracing.events, other);
  tracing.dense = !tracing.bars.empty();
}

}  // namespace

base::Result<void> check(const PlateSettings& settings) {
  if (settings.size < 32 || settings.size > 4096) {
    return base::fail(base::Errc::bad_argument,
                      "a plate cannot have " + std::to_string(settings.size) + " samples a side", "size",
                      "give 32 to 4096");
  }
  if (!(settings.half_width >= 0.001 && settings.half_width <= 0.2)) {
    return base::fail(base::Errc::bad_argument, "the half width of a groove is out of range", "half width",
                      "give 0.001 to 0.2 of the plate's side");
  }
  if (settings.heights && !(settings.heights->low < settings.heights->high &&
                            std::isfinite(settings.heights->high - settings.heights->low))) {
    return base::fail(base::Errc::bad_argument, "the range of heights is empty", "z", "give low < high");
  }
  return {};
}

base::Result<Plate> carve(const Tracing& tracing, const PlateSettings& settings) {
  if (auto good = check(settings); !good) return tl::unexpected(std::move(good.error()));
  const double plateau = settings.layers.any() ? kPlateauUnderLayers : 1.0;
  auto map = surface::HeightMap::create(settings.size, static_cast<float>(plateau));
  if (!map) return tl::unexpected(std::move(map.error()));
  const double half_width = settings.half_width;
  const double reach = settings.layers.any() ? half_width * (1 + kClearance) : half_width;
  DistanceGrid all(settings.size, reach);
  bool strict = false;
  for (const Branch& b : tracing.branches) {
    // A curve that only comes near the window is not in the picture.
    if (!touches_window(b)) continue;
    if (b.strict) {
      strict = true;
    } else {
      all.add_line(b.points, b.closed, b.statement);
    }
  }
  for (const Bar& b : tracing.bars) {
    if (touches_window(b.from, b.to)) all.add_segment(b.from, b.to, b.statement);
  }
  for (const Dot& d : tracing.dots) {
    if (touches_window(d.at, d.at)) all.add_segment(d.at, d.at, d.statement);
  }

  Plate plate;
  plate.heights = std::move(*map);
  const std::span<float> heights = plate.heights.samples();
  plate.mask.assign(heights.size(), 0);
  plate.statement.assign(heights.size(), 0);
  const std::vector<std::uint8_t> inside = regions_of(tracing, settings.size);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (inside[i] == 0) continue;
    const double column = static_cast<double>(i % static_cast<std::size_t>(settings.size)) / settings.size;
    const double row = static_cast<double>(i / static_cast<std::size_t>(settings.size)) / settings.size;
    const double wave = 0.5 + 0.5 * std::cos(2 * std::numbers::pi * (column + row) / kRipple);
    heights[i] = static_cast<float>(plateau * (1 - kRippleLow - (kRippleHigh - kRippleLow) * wave));
    plate.mask[i] = 255;
    plate.statement[i] = inside[i];
  }
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const float d = all.distance(i);
    if (!(d <= half_width)) continue;
    const double depth = profile(d, half_width);
    const double floor = depth * (1 - texture(i, settings.size, all.statement(i) - 1, depth));
    heights[i] = std::min(heights[i], static_cast<float>(plateau * (1 - floor)));
    plate.mask[i] = 255;
    plate.statement[i] = static_cast<std::uint8_t>(all.statement(i));
  }
  if (strict) {
    const double dash = std::max(kDash, 2 * half_width);
    DistanceGrid dashes(settings.size, half_width);
    for (const Branch& b : tracing.branches) {
      if (b.strict) add_dashes(dashes, b, std::array{dash, dash});
    }
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const float d = dashes.distance(i);
      if (d <= half_width)
        heights[i] = std::min(heights[i], static_cast<float>(plateau * (1 - profile(d, half_width))));
    }
  }
  add_layers(plate, tracing.window, settings,
             [&](std::size_t i) { return inside.empty() || inside[i] == 0 ? all.distance(i) : 0.0F; });
  return plate;
}

base::Result<Picture> draw(const Plot& plot, const Window& window, const PlateSettings& settings,
                           const base::Progress& progress, double most_milliseconds) {
  if (auto good = check(settings); !good) return tl::unexpected(std::move(good.error()));
  Picture picture;
  picture.tracing.window = window;
  if (plot.is_surface()) {
    auto plate = carve_surface(plot.statements[0], window, settings, progress);
    if (!plate) return tl::unexpected(std::move(plate.error()));
    picture.plate = std::move(*plate);
    return picture;
  }
  TraceSettings trace_settings;
  trace_settings.resolution = settings.size;
  trace_settings.most_milliseconds = most_milliseconds;
  trace_settings.margin = std::max(0.02, settings.half_width * 1.05);
  auto tracing = trace(plot, window, trace_settings, progress);
  if (!tracing) return tl::unexpected(std::move(tracing.error()));
  picture.tracing = std::move(*tracing);
  if (settings.alone >= 0) keep_alone(picture.tracing, settings.alone);
  auto plate = carve(picture.tracing, settings);
  if (!plate) return tl::unexpected(std::move(plate.error()));
  picture.plate = std::move(*plate);
  return picture;
}

base::Result<void> draw_coarse_to_fine(const Plot& plot, const Window& window, const PlateSettings& settings,
                                       const std::function<bool(Picture&&, bool)>& show,
                                       const base::Progress& progress) {
  constexpr int kCoarse = 128;
  // Share of the 100 ms until the first picture; carving uses the rest.
  constexpr double kCoarseMilliseconds = 60;
  const auto stopped = [] { return base::fail(base::Errc::cancelled, "the drawing was stopped"); };
  if (settings.size > kCoarse) {
    PlateSettings coarse = settings;
    coarse.size = kCoarse;
    auto first = draw(
        plot, window, coarse,
        [&progress](double done, std::string_view step) { return !progress || progress(done * 0.1, step); },
        kCoarseMilliseconds);
    if (!first) return tl::unexpected(std::move(first.error()));
    if (!show(std::move(*first), false)) return stopped();
  }
  const double start = settings.size > kCoarse ? 0.1 : 0.0;
  auto last = draw(plot, window, settings, [&progress, start](double done, std::string_view step) {
    return !progress || progress(start + (1 - start) * done, step);
  });
  if (!last) return tl::unexpected(std::move(last.error()));
  if (!show(std::move(*last), true)) return stopped();
  return {};
}

}  // namespace nazori::functions
