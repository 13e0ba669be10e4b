// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "alignment.h"

namespace nazori::writing {

/// A stroke that was drawn in the wrong order.
struct OutOfTurn {
  int drawn = 0;   ///< the stroke drawn too early
  int before = 0;  ///< the drawn stroke that should have come before it
  std::vector<int>
      misplaced;  ///< drawn strokes in the wrong position: the two exchanged ones, or the one that was moved
};

/// The smallest set of strokes whose moving corrects the order. Empty where the order is the model's.
[[nodiscard]] std::vector<OutOfTurn> strokes_out_of_turn(std::span<const Link> links);

}  // namespace nazori::writing
