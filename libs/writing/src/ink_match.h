// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "stroke_picture.h"

namespace nazori::writing {

inline constexpr std::size_t kInkPoints = 64;

/// A drawing as points at equal steps along its ink, with the slant of the ink as the cosine and sine of
/// twice its angle: number, order and direction of the strokes do not show. Centred, with the mean square of
/// the points 1.
struct InkPoints {
  alignas(32) std::array<float, kInkPoints> x{};
  alignas(32) std::array<float, kInkPoints> y{};
  alignas(32) std::array<float, kInkPoints> cosine{};
  alignas(32) std::array<float, kInkPoints> sine{};
};

[[nodiscard]] InkPoints ink_points(std::span<const FlatLine> strokes);

/// How far the ink of one lies from the nearest ink of the other with a similar slant, on average: 0 for the
/// same, at most 1.
struct InkDistance {
  float drawn = 0;  ///< drawn ink that the model does not have
  float model = 0;  ///< ink of the model that was not drawn
};

/// The distances after `drawn` was slanted and stretched a little to fit.
/// @source the chamfer distance of H. G. Barrow et al., "Parametric correspondence and chamfer matching",
/// IJCAI 1977, with directions as in M.-Y. Liu et al., "Fast directional chamfer matching", CVPR 2010.
[[nodiscard]] InkDistance ink_distance(const InkPoints& drawn, const InkPoints& model);

}  // namespace nazori::writing
