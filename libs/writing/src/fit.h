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

/// Means over the samples of a drawn stroke (x, y) and of the model's (u, v): of both, and of their products
/// about those.
struct PairMoments {
  double x = 0, y = 0, u = 0, v = 0;
  double xx = 0, xy = 0, yy = 0, xu = 0, yu = 0, xv = 0, yv = 0;
};

[[nodiscard]] PairMoments moments_of(const FitPair& pair);

/// What a fit needs to know of pairs. Pairs can be added and taken away again.
struct FitSums {
  double weight = 0;
  PairMoments sum;  ///< of products about the origin

  void add(const PairMoments& pair, double weight);
  void add(const FitSums& other, double times = 1);
};

/// The least-squares map from the drawn strokes to those of the model. Size and position are free. Aspect and
/// slant are restrained, the more the fewer strokes there are, so that a single stroke cannot be turned or
/// squeezed into another. `expected_scale` decides where nothing else does.
[[nodiscard]] Affine fit(std::span<const FitPair> pairs, double expected_scale);
/// The same of sums; most exact where the origin lies near the strokes.
[[nodiscard]] Affine fit(const FitSums& sums, double expected_scale);

/// Maps drawn samples so that place and size of all ink agree with the model's: no correspondence needed.
[[nodiscard]] Affine fit_by_moments(std::span<const Shape> drawn, std::span<const Shape> model);

}  // namespace nazori::writing
