// SPDX-License-Identifier: Apache-2.0
#include "residue.h"

#include <algorithm>
#include <cmath>

namespace nazori::writing {

Residue residue(const Shape& drawn, const Shape& model, const StrokeDifference& difference,
                const Placement& placement) {
  // Includes hooks, because comparing without them hides much else.
  const Samples& d = drawn.whole;
  const Samples& m = model.whole;
  const float fd = 1 / std::max(d.length, 1e-3F);
  const float fm = 1 / std::max(m.length, 1e-3F);
  float own = 0;
  float along = 0;
  float across = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const std::size_t j = difference.reversed ? kSamples - 1 - k : k;
    const float dx = (d.x[j] - d.centre_x) * fd;
    const float dy = (d.y[j] - d.centre_y) * fd;
    const float mx = (m.x[k] - m.centre_x) * fm;
    const float my = (m.y[k] - m.centre_y) * fm;
    own += dx * dx + dy * dy + mx * mx + my * my;
    along += dx * mx + dy * my;
    across += mx * dy - my * dx;
  }
  Residue r;
  r.turn_rad = std::atan2(across, along);
  const float left = own - 2 * std::sqrt(along * along + across * across);
  r.bend = std::sqrt(std::max(left, 0.0F) / static_cast<float>(kSamples));
  // An offset that the neighbours share is not a deviation of this stroke.
  const float shared_x = difference.offset_x - placement.x;
  const float shared_y = difference.offset_y - placement.y;
  const auto off = [&](std::size_t j, std::size_t k) {
    const float x = d.x[j] - m.x[k] - shared_x;
    const float y = d.y[j] - m.y[k] - shared_y;
    return std::sqrt(x * x + y * y);
  };
  constexpr std::size_t kLast = kSamples - 1;
  r.nearer_end =
      difference.reversed ? std::min(off(kLast, 0), off(0, kLast)) : std::min(off(0, 0), off(kLast, kLast));
  return r;
}

}  // namespace nazori::writing
