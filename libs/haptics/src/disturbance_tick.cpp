// SPDX-License-Identifier: Apache-2.0
#include "disturbance.h"

namespace nazori::haptics {

void Disturbance::advance() noexcept {
  for (auto& axis : axes_)
    for (Tone& t : axis) {
      const double c = t.cos * t.step_cos - t.sin * t.step_sin;
      const double s = t.cos * t.step_sin + t.sin * t.step_cos;
      const double shrink = 1.5 - 0.5 * (c * c + s * s);  // keeps rounding from letting it grow over hours
      t.cos = c * shrink;
      t.sin = s * shrink;
    }
}

Vec3 Disturbance::value() const noexcept {
  constexpr double kShare = 0.7071067811865475 / static_cast<double>(kTones);
  double sums[2] = {0, 0};
  for (std::size_t a = 0; a < 2; ++a)
    for (const Tone& t : axes_[a]) sums[a] += t.sin;
  return {kShare * sums[0], kShare * sums[1], 0};
}

}  // namespace nazori::haptics
