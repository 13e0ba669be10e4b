// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "nazori/geometry/bristle_segment.h"

namespace nazori::brush {

/// The shares of bristles whose way is their speed times each of some times.
inline std::vector<double> shares(const std::vector<geometry::BristleSegment>& swept,
                                  const std::vector<double>& seconds) {
  std::vector<double> found(seconds.size());
  double moving = 0;
  for (const geometry::BristleSegment& s : swept) {
    const double way = geometry::distance(s.from, s.to);
    if (way < 2e-6) continue;
    ++moving;
    for (std::size_t i = 0; i < seconds.size(); ++i)
      if (std::abs(way - s.speed_m_s * seconds[i]) < 1e-9) ++found[i];
  }
  for (double& share : found) share /= moving;
  return found;
}

}  // namespace nazori::brush
