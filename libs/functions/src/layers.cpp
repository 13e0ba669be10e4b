// SPDX-License-Identifier: Apache-2.0
#include "layers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace nazori::functions {
namespace {

// Heights and half widths of the ridges, in plate units; an axis is broader and higher than a grid line.
constexpr double kAxisTop = 0.97;
constexpr double kAxisHalfWidth = 0.0045;
constexpr double kTickLength = 0.014;
constexpr double kGridTop = 0.925;
constexpr double kGridHalfWidth = 0.0025;
constexpr double kRimWidth = 0.012;
constexpr double kOriginRadius = 0.009;

double bump(double distance, double half_width) {
  if (distance >= half_width) return 0;
  return 0.5 * (1 + std::cos(std::numbers::pi * distance / half_width));
}

/// Positions of the ticks in plate units.
std::vector<double> tick_places(double low, double high) {
  const double step = tick_step(low, high);
  std::vector<double> places;
  for (double k = std::ceil(low / step); k * step <= high; ++k)
    places.push_back((k * step - low) / (high - low));
  return places;
}

}  // namespace

double tick_step(double low, double high) {
  const double rough = (high - low) / 10;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * power >= rough * (1 - 1e-12)) return m * power;
  }
  return 10 * power;
}

std::vector<double> tick_distances(double low, double high, int n, bool downwards) {
  std::vector<double> d(static_cast<std::size_t>(n), 10.0);
  const std::vector<double> places = tick_places(low, high);
  for (int i = 0; i < n; ++i) {
    const double c = downwards ? 1 - (i + 0.5) / n : (i + 0.5) / n;
    for (const double p : places)
      d[static_cast<std::size_t>(i)] = std::min(d[static_cast<std::size_t>(i)], std::abs(c - p));
  }
  return d;
}

void add_layers(Plate& plate, const Window& window, const PlateSettings& settings,
                const std::function<float(std::size_t)>& distance) {
  const Layers& layers = settings.layers;
  if (!layers.any()) return;
  const int n = settings.size;
  const std::vector<double> across = tick_distances(window.x0, window.x1, n, false);
  const std::vector<double> up = tick_distances(window.y0, window.y1, n, true);
  // The ticks of an axis outside the window are on the nearest side of the frame.
  const double axis_u = std::clamp(window.u(0), 0.0, 1.0);
  const double axis_v = std::clamp(window.v(0), 0.0, 1.0);
  const bool has_y_axis = window.x0 <= 0 && window.x1 >= 0;
  const bool has_x_axis = window.y0 <= 0 && window.y1 >= 0;
  const double clear = settings.half_width * (1 + kClearance);
  const std::span<float> heights = plate.heights.samples();
  for (int row = 0; row < n; ++row) {
    const double v = 1 - (row + 0.5) / n;
    const double to_tick_v = up[static_cast<std::size_t>(row)];
    for (int column = 0; column < n; ++column) {
      const double u = (column + 0.5) / n;
      const double to_tick_u = across[static_cast<std::size_t>(column)];
      double height = kPlateauUnderLayers;
      const auto raise = [&height](double top, double share) {
        height = std::max(height, kPlateauUnderLayers + (top - kPlateauUnderLayers) * share);
      };
      if (layers.grid) raise(kGridTop, bump(std::min(to_tick_u, to_tick_v), kGridHalfWidth));
      const double to_x_axis = std::abs(v - axis_v);
      const double to_y_axis = std::abs(u - axis_u);
      if (layers.axes) {
        if (has_x_axis) raise(kAxisTop, bump(to_x_axis, kAxisHalfWidth));
        if (has_y_axis) raise(kAxisTop, bump(to_y_axis, kAxisHalfWidth));
        if (has_x_axis && has_y_axis) raise(1.0, bump(std::hypot(to_x_axis, to_y_axis), kOriginRadius));
      }
      if (layers.ticks) {
        if (to_x_axis < kTickLength) raise(kAxisTop, bump(to_tick_u, kAxisHalfWidth));
        if (to_y_axis < kTickLength) raise(kAxisTop, bump(to_tick_v, kAxisHalfWidth));
      }
      const std::size_t i =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(n) + static_cast<std::size_t>(column);
      if (height > kPlateauUnderLayers && distance(i) > clear && plate.mask[i] == 0)
        heights[i] = static_cast<float>(height);
      // The rim is above everything, to keep the tip on the plate.
      if (layers.rim && std::min(std::min(u, 1 - u), std::min(v, 1 - v)) < kRimWidth && plate.mask[i] == 0)
        heights[i] = 1.0F;
    }
  }
}

}  // namespace nazori::functions
