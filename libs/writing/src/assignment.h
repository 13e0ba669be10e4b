// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace nazori::writing {

/// Column of each row so that the sum of costs is smallest; each column is used once.
/// @param costs  size * size, row by row.
/// @source H. W. Kuhn, "The Hungarian method for the assignment problem", 1955, in the form with potentials,
/// O(size^3).
[[nodiscard]] std::vector<std::size_t> assign(std::span<const float> costs, std::size_t size);

}  // namespace nazori::writing
