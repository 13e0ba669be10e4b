// SPDX-License-Identifier: Apache-2.0
// Ink that is known by a formula, for the tests of the tracing.
#pragma once

#include <vector>

#include "ink_map.h"

namespace nazori::author::test {

/// @param level  of the sample (x, y): how dark it is, 1 at the rim.
template <class Level>
InkMap ink_with(Level level) {
  InkMap map;
  for (int y = 0; y < kInkSide; ++y)
    for (int x = 0; x < kInkSide; ++x) {
      const auto value = static_cast<float>(level(static_cast<double>(x), static_cast<double>(y)));
      map.level.push_back(value);
      map.ink.push_back(value > 1 ? 1 : 0);
    }
  map.depth.assign(map.level.size(), 1.0F);
  map.distance = distance_map(map.ink, kInkSide);
  return map;
}

}  // namespace nazori::author::test
