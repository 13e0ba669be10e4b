// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "shape.h"

namespace nazori::writing {

/// A drawn stroke and the model stroke it is taken for.
struct FitPair {
  const Samples* drawn = nullptr;
  const Samples* model = nullptr;
  bool reversed = false;
  double weight = 1;
};

/// The map that lays the drawn strokes on those of the model in the least squares sense. Size and place are
/// free; aspect and slant are held back the more, the fewer strokes speak for them, so that a single stroke
/// can neither turn nor be squeezed into another. `expected_scale` decides where nothing else does.
[[nodiscard]] Affine fit(std::span<const FitPair> pairs, double expected_scale);

/// Maps drawn samples so that place and size of all ink agree with the model's: no correspondence needed.
[[nodiscard]] Affine fit_by_moments(std::span<const Shape> drawn, std::span<const Shape> model);

}  // namespace nazori::writing
