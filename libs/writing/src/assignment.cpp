// SPDX-License-Identifier: Apache-2.0
#include "assignment.h"

#include "nazori/base/assignment.h"

namespace nazori::writing {

// Here and not in a header: this file is compiled for sums in any order.
std::vector<std::size_t> assign(std::span<const float> costs, std::size_t size) {
  return base::cheapest_assignment(costs, size);
}

}  // namespace nazori::writing
