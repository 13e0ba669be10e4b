// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shape.h"

namespace nazori::writing {

/// How the direction of a drawn stroke differs from the model's, as it goes along.
struct Course {
  float chord_turn = 0;  ///< radians between the lines from start to end, by how straight the less straight
                         ///< of the two is: 0 where either is closed
  float along = 0;       ///< mean of 1 - cos of the difference of the directions, 0..2, once both are aligned
};

/// The courses of two strokes, in the direction of the model. They are aligned step by step: a corner that
/// comes a little earlier or later is no difference of its own.
/// @source dynamic time warping in a band: H. Sakoe and S. Chiba, "Dynamic programming algorithm optimization
/// for spoken word recognition", IEEE Trans. ASSP 26 (1978).
[[nodiscard]] Course course(const Samples& drawn, const Samples& model, bool reversed);

}  // namespace nazori::writing
