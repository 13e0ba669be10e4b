// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "shape.h"

namespace nazori::writing {

/// A drawn stroke and the model stroke it is matched with.
struct FitPair {
  const Samples* drawn = nullptr;
  const Samples* model = nullptr;
  bool reversed = false;
  double weight = 1;
};

/// The least-squares map from the drawn strokes to those of the model. Size and position are free. Aspect and
/// slant are restrained, the more the fewer strokes there are, so that a single stroke cannot be turned or
/// squeezed into another. `expected_scale` decides where nothing else does.
[[nodiscard]] Affine fit(std::span<const FitPair> pairs, double expected_scale);

/// Maps drawn samples so that place and size of all ink agree with the model's: no correspondence needed.
[[nodiscard]] Affine fit_by_moments(std::span<const Shape> drawn, std::span<const Shape> model);

}  // namespace nazori::writing
