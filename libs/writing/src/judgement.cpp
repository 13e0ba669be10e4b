// SPDX-License-Identifier: Apache-2.0
#include "judgement.h"

#include <algorithm>
#include <cmath>

namespace nazori::writing {

// The weights are those of a logistic regression that tells strokes of real writing from strange strokes put
// in their places, rounded; docs/writing.md names the data and the figures.
Judgement judge(const StrokeDifference& d, const Placement& placement) {
  constexpr double kLimit = 6.3;
  const double length = static_cast<double>(d.model_length);
  // 1 for a dot, 0 for a long stroke: the direction of a dot varies more, and it hardly has a shape.
  const double dot = std::exp(-(length / 17) * (length / 17));
  const auto squared = [](float x, float y) { return static_cast<double>(x * x + y * y); };
  const double place =
      (1.1 * squared(d.offset_x, d.offset_y) + (1.1 - 0.75 * dot) * squared(placement.x, placement.y)) / 100;
  // Quick dots fall steeper than the model's; hardly any is flatter.
  const double steeper = std::clamp(static_cast<double>(d.steeper), -0.3, 0.3);
  const double freedom = static_cast<double>(d.freedom) * (1 + 0.5 * dot * steeper);
  const double size = static_cast<double>(d.shape) / (freedom * (1.45 + 0.058 * length));
  const double proportion = static_cast<double>(d.proportion) / (0.1 * freedom);
  // A dot may be as short as a touch.
  const double free_length = std::exp(-std::pow(length / 14, 4));
  const double stretch = std::min(std::abs(static_cast<double>(d.length_log)), 1.2);
  const double size_part = 2.2 * size * size / 4 + 3.6 * (1 - free_length) * stretch * stretch;
  const double shape_part = (4.0 * (1 - dot) + 2.3 * dot) * proportion * proportion / 4;
  Judgement j;
  j.place = place / kLimit;
  j.deviation = (place + size_part + shape_part) / kLimit;
  if (place > size_part + shape_part)
    j.most = Deviation::place;
  else if (size_part > shape_part)
    j.most = Deviation::length;
  else
    j.most = Deviation::shape;
  return j;
}

double deviation_limit(double strictness) {
  constexpr double kAtLenient = 1.7;
  constexpr double kAtStrict = 1 / 1.7;
  return kAtLenient * std::pow(kAtStrict / kAtLenient, std::clamp(strictness, 0.0, 1.0));
}

}  // namespace nazori::writing
