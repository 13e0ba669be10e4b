// SPDX-License-Identifier: Apache-2.0
#include "judgement.h"

#include <algorithm>
#include <cmath>

namespace nazori::writing {

// The weights, rounded, separate strokes of real writing best from wrong strokes in their places;
// docs/writing.md names the data and the figures.
Judgement judge(const StrokeDifference& d, const Placement& placement, const Residue& residue, float touch) {
  constexpr double kLimit = 6.3;
  const double length = static_cast<double>(d.model_length);
  const double shortness = 1 / (length + 3);
  // 1 for a dot, 0 for a long stroke: the position of a dot varies more.
  const double dot = std::exp(-(length / 17) * (length / 17));
  const auto square = [](auto v) { return static_cast<double>(v * v); };
  const double off = square(d.offset_x) + square(d.offset_y);
  const double off_beside = square(placement.x) + square(placement.y);
  const double place = (0.51 * off + (2.0 - 1.73 * dot) * off_beside) / 100;
  // Quick dots fall steeper than the model's; hardly any is flatter.
  const double steeper = std::clamp(static_cast<double>(d.steeper), -0.5, 0.5);
  const double freedom = static_cast<double>(d.freedom) * (1 + 0.46 * dot * steeper);
  const double proportion = static_cast<double>(d.proportion) / (freedom * (0.074 + 0.21 * shortness));
  const double turn =
      std::min(std::abs(static_cast<double>(residue.turn_rad)), 1.5) / (freedom * (1.44 + 4.0 * shortness));
  const double bend = static_cast<double>(residue.bend) / (0.07 + 1.05 * shortness);
  const double end = static_cast<double>(residue.nearer_end) / 10;
  // A dot may be as short as a touch.
  const double free_length = std::exp(-std::pow(length / static_cast<double>(touch), 4));
  const double stretch = std::min(std::abs(static_cast<double>(d.length_log)), 1.2);
  // An intended stroke is hardly ever only half as long as it should be.
  const double beyond = std::clamp(-static_cast<double>(placement.length_log) - 0.7, 0.0, 0.5);
  const double size_part =
      (1 - free_length) * (3.0 * square(stretch) + 40.0 * square(beyond) * (1 - free_length));
  const double shape_part = square(proportion) + square(turn) + square(bend) + 0.28 * square(end);
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

bool is_level_or_upright(const Samples& model, float turn_rad) {
  constexpr float kMostTurn = 0.95F;  // radians; a dot that is drawn backwards is turned further
  constexpr float kOff = 0.14F;       // sine of what a level or upright line may be off
  if (std::abs(turn_rad) > kMostTurn) return false;
  const float dx = model.x.back() - model.x.front();
  const float dy = model.y.back() - model.y.front();
  const float across = dx * std::cos(turn_rad) - dy * std::sin(turn_rad);
  const float down = dx * std::sin(turn_rad) + dy * std::cos(turn_rad);
  return std::min(std::abs(across), std::abs(down)) <= kOff * std::hypot(dx, dy);
}

void ignore_slant(const Samples& model, StrokeDifference& difference, Residue& residue) {
  constexpr float kStraight = 0.05F;
  if (residue.bend > kStraight || !is_level_or_upright(model, residue.turn_rad)) return;
  difference.proportion = std::min(difference.proportion, residue.bend);
  residue.turn_rad = 0;
}

double deviation_limit(double strictness) {
  constexpr double kAtLenient = 1.7;
  constexpr double kAtStrict = 1 / 1.7;
  return kAtLenient * std::pow(kAtStrict / kAtLenient, strictness);
}

}  // namespace nazori::writing
