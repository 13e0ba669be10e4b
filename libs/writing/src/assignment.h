// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace nazori::writing {

/// base::cheapest_assignment.
[[nodiscard]] std::vector<std::size_t> assign(std::span<const float> costs, std::size_t size);

}  // namespace nazori::writing
