// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/print_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "dashes.h"
#include "distance_grid.h"
#include "layers.h"

namespace nazori::functions {
namespace {

constexpr double kCurveMm = 1.6;
constexpr double kAxisMm = 0.7;
constexpr double kTickMm = 3.0;
constexpr double kFrameMm = 0.5;
constexpr double kClearMm = 2.0;
constexpr double kHatchMm = 3.0;
// Lengths of dash and gap alternately; none: a solid line.
const std::array<std::vector<double>, 4> kStylesMm{{{}, {6, 3}, {1.7, 3.2}, {7, 3, 1.7, 3}}};

}  // namespace

base::Result<surface::HeightMap> print_picture(const Tracing& tracing, const PrintSettings& s) {
  if (!(s.side_mm >= 50 && s.side_mm <= 400) || s.dots_per_inch < 72 || s.dots_per_inch > 600) {
    return base::fail(base::Errc::bad_argument, "the size of the print is out of range", "print",
                      "give 50 to 400 mm and 72 to 600 dots an inch");
  }
  const int size = std::min(4096, static_cast<int>(std::lround(s.side_mm / 25.4 * s.dots_per_inch)));
  auto picture = surface::HeightMap::create(size, 1.0F);
  if (!picture) return picture;
  const double mm = 1 / s.side_mm;
  const double curve = kCurveMm / 2 * mm;
  const double reach = curve + kClearMm * mm;
  DistanceGrid whole(size, reach);
  DistanceGrid inked(size, curve);
  const auto style_of = [mm](int statement, bool strict) {
    const std::size_t k = strict ? 1 : static_cast<std::size_t>(statement) % kStylesMm.size();
    std::vector<double> lengths = kStylesMm[k];
    for (double& l : lengths) l *= mm;
    return lengths;
  };
  for (const Branch& b : tracing.branches) {
    whole.add_line(b.points, b.closed, b.statement);
    const std::vector<double> style = style_of(b.statement, b.strict);
    if (style.empty()) {
      inked.add_line(b.points, b.closed, b.statement);
    } else {
      add_dashes(inked, b, style);
    }
  }
  for (const Bar& b : tracing.bars) {
    whole.add_segment(b.from, b.to, b.statement);
    inked.add_segment(b.from, b.to, b.statement);
  }
  for (const Dot& d : tracing.dots) {
    whole.add_segment(d.at, d.at, d.statement);
    inked.add_segment(d.at, d.at, d.statement);
  }
  const std::vector<std::uint8_t> regions = regions_of(tracing, size);
  const Window& w = tracing.window;
  const std::vector<double> ticks_u = tick_distances(w.x0, w.x1, size, false);
  const std::vector<double> ticks_v = tick_distances(w.y0, w.y1, size, true);
  const double axis_u = std::clamp(w.u(0), 0.0, 1.0);
  const double axis_v = std::clamp(w.v(0), 0.0, 1.0);
  const bool has_y_axis = w.x0 <= 0 && w.x1 >= 0;
  const bool has_x_axis = w.y0 <= 0 && w.y1 >= 0;
  const double axis = kAxisMm / 2 * mm;
  for (int row = 0; row < size; ++row) {
    const double v = 1 - (row + 0.5) / size;
    for (int column = 0; column < size; ++column) {
      const double u = (column + 0.5) / size;
      const std::size_t i =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
      bool black = inked.distance(i) <= curve;
      if (!black && !regions.empty() && regions[i] != 0)
        black = std::fmod((u + v) / (kHatchMm * mm), 1.0) < 0.3;
      if (!black && s.axes && whole.distance(i) > reach) {
        const double to_x = std::abs(v - axis_v);
        const double to_y = std::abs(u - axis_u);
        black = (has_x_axis && to_x <= axis) || (has_y_axis && to_y <= axis) ||
                (to_x <= kTickMm / 2 * mm && ticks_u[static_cast<std::size_t>(column)] <= axis) ||
                (to_y <= kTickMm / 2 * mm && ticks_v[static_cast<std::size_t>(row)] <= axis);
      }
      black = black || std::min(std::min(u, 1 - u), std::min(v, 1 - v)) <= kFrameMm * mm;
      if (black) picture->samples()[i] = 0.0F;
    }
  }
  return picture;
}

}  // namespace nazori::functions
