// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace nazori::brush {

/// Energy, moment and stiffness of a part of a joint.
struct Resistance {
  double energy;
  double moment;
  double stiffness;
};

/// A spring with stiffness `k` whose zero follows `angle` at a distance of `yield`, but not beyond `most`
/// from the angle `rest`.
inline Resistance keeping(double angle, double kept, double k, double yield, double most,
                          double rest) noexcept {
  const double e = angle - kept;
  const double size = std::abs(e);
  if (most <= 0 || size <= yield) return {0.5 * k * e * e, k * e, k};
  const double side = e > 0 ? 1.0 : -1.0;
  const double flow = std::max(0.0, side * (rest - kept) + most);  // way that the zero may still go
  const double beyond = size - yield;
  if (beyond <= flow) return {k * yield * (0.5 * yield + beyond), side * k * yield, 0};
  const double stretched = size - flow;
  return {k * yield * flow + 0.5 * k * stretched * stretched, side * k * stretched, k};
}

/// A spring with stiffness `k` that slips at the stretch `slip`.
inline Resistance slipping(double stretch, double k, double slip) noexcept {
  const double size = std::abs(stretch);
  if (size < slip) return {0.5 * k * stretch * stretch, k * stretch, k};
  return {k * slip * (size - 0.5 * slip), stretch > 0 ? k * slip : -k * slip, 0};
}

}  // namespace nazori::brush
