// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/axis_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nazori::functions {
namespace {

/// Nearer to an edge of the plate than this share of its side there is the frame, and no room for a number.
constexpr double kFrame = 0.03;
/// An axis nearer to an edge than this has its numbers on the other side.
constexpr double kRoom = 0.1;
constexpr int kMostDigits = 5;

struct Axis {
  double low, high;
  double step = tick_step(low, high);
};

geometry::TabletPoint place(double u, double v, const geometry::TabletShape& shape) {
  return {(u - 0.5) * shape.width_m, (v - 0.5) * shape.width_m};
}

bool is_on_plate(double share) { return share > kFrame && share < 1 - kFrame; }

}  // namespace

std::string tick_text(double value, double step) {
  if (std::abs(value) < step / 2) return "0";
  // A multiple of 1, 2 or 5 times a power of ten has no digits behind that power.
  const int power = static_cast<int>(std::floor(std::log10(step) + 1e-9));
  const int decimals = std::max(0, -power);
  std::string plain = fmt::format("{:.{}f}", value, decimals);
  const auto digits = std::count_if(plain.begin(), plain.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (digits <= kMostDigits) return plain;
  const int own = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
  std::string mantissa = fmt::format("{:.{}f}", value / std::pow(10.0, own), std::max(0, own - power));
  if (mantissa.find('.') != std::string::npos) {
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.back() == '.') mantissa.pop_back();
  }
  std::string with_power = mantissa + "e" + std::to_string(own);
  return with_power.size() < plain.size() ? with_power : plain;
}

std::vector<geometry::Label> axis_labels(const Window& window, const Layers& layers,
                                         const geometry::TabletShape& shape) {
  std::vector<geometry::Label> labels;
  if (!layers.ticks) return labels;
  const Axis x{window.x0, window.x1};
  const Axis y{window.y0, window.y1};
  // As the ticks are carved: those of an axis outside the window are on the nearest side of the frame.
  const double axis_u = std::clamp(window.u(0), 0.0, 1.0);
  const double axis_v = std::clamp(window.v(0), 0.0, 1.0);
  const bool cross = is_on_plate(window.u(0)) && is_on_plate(window.v(0));
  const double below = axis_v < kRoom ? 1 : -1;
  const double beside = axis_u < kRoom ? 1 : -1;
  for (double k = std::ceil(x.low / x.step); k * x.step <= x.high; ++k) {
    const double u = window.u(k * x.step);
    if (!is_on_plate(u) || (cross && k == 0)) continue;
    labels.push_back({tick_text(k * x.step, x.step), place(u, axis_v, shape), 0, below});
  }
  for (double k = std::ceil(y.low / y.step); k * y.step <= y.high; ++k) {
    const double v = window.v(k * y.step);
    if (!is_on_plate(v) || (cross && k == 0)) continue;
    labels.push_back({tick_text(k * y.step, y.step), place(axis_u, v, shape), beside, 0});
  }
  if (cross)
    labels.push_back({"0", place(axis_u, axis_v, shape), beside * std::sqrt(0.5), below * std::sqrt(0.5)});
  return labels;
}

}  // namespace nazori::functions
