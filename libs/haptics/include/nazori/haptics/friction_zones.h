// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace nazori::haptics {

/// Parts of a surface with more friction than its material has, so that grooves can be told apart by friction
/// alone. Immutable once it is in a scene.
struct FrictionZones {
  /// Samples per side, the same as of the surface: from edge to edge, row 0 at the top.
  int size = 0;
  /// For each sample: 0 the material alone, n the material plus added[n - 1].
  std::vector<std::uint8_t> zone;
  /// Coefficients, >= 0, added to the material's static and dynamic friction.
  std::vector<double> added;
};

}  // namespace nazori::haptics
