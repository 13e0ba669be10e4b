// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/functions/tracing.h"

namespace nazori::functions {

struct Meeting {
  PlatePoint at;
  double first = 0;  ///< parameters of the two pieces there, where they have any
  double second = 0;
};

/// Where the drawn pieces of two statements cross, or where those of one cross each other (a == b); each
/// point once. At most 400.
[[nodiscard]] std::vector<Meeting> crossings_of(const Tracing& tracing, int a, int b);

}  // namespace nazori::functions
