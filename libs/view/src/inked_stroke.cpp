// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/inked_stroke.h"

#include <algorithm>
#include <cmath>

namespace nazori::view {
namespace {

constexpr double kThinnestInk_m = 0.0004;
constexpr double kWidestInk_m = 0.0020;
constexpr double kLaidFlat = 0.6;  // of its width more, of a brush on its side

}  // namespace

double ink_half_width_m(const geometry::WrittenPoint<geometry::TabletFrame>& point) {
  const double pressure = std::clamp(point.pressure.value_or(0), 0.0, 1.0);
  const double upright_m = kThinnestInk_m + (kWidestInk_m - kThinnestInk_m) * pressure;
  return upright_m * (1 + kLaidFlat * std::sin(point.lean_rad.value_or(0)));
}

InkedStroke inked(const geometry::WrittenStroke<geometry::TabletFrame>& stroke, Verdict verdict) {
  InkedStroke drawn;
  drawn.verdict = verdict;
  drawn.points.reserve(stroke.size());
  for (const auto& point : stroke)
    if (drawn.points.empty() || drawn.points.back().at != point.at) drawn.points.push_back(point);
  return drawn;
}

}  // namespace nazori::view
