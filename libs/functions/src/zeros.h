// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// The zeros of `f` between `low` and `high`, each factor for itself, so that touching zeros are found as
/// exactly as others. Without those in gaps of `f`; rising.
[[nodiscard]] std::vector<double> zeros_of(const Expression& f, Variable v, double low, double high,
                                           int most_boxes = 60'000);

}  // namespace nazori::functions
