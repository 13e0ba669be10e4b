// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace nazori::haptics {

/// Parts of a surface that are rougher or smoother than its material says, so that a groove can be told from
/// another by friction alone. Immutable once it is in a scene.
struct FrictionZones {
  /// Samples a side, as the surface has them: from edge to edge, row 0 at the top.
  int size = 0;
  /// Of each sample: 0 the material alone, n added[n - 1] besides.
  std::vector<std::uint8_t> zone;
  /// Coefficients, >= 0, added to the material's static and dynamic friction.
  std::vector<double> added;
};

}  // namespace nazori::haptics
