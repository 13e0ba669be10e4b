// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace nazori::base {

/// Column of each row so that the sum of costs is smallest; each column is used once.
/// @param costs  size * size, row by row; finite.
/// @source H. W. Kuhn, "The Hungarian method for the assignment problem", 1955, in the form with potentials,
/// O(size^3).
template <class Cost>
[[nodiscard]] std::vector<std::size_t> cheapest_assignment(std::span<const Cost> costs, std::size_t size) {
  assert(costs.size() == size * size);
  constexpr Cost kMost = std::numeric_limits<Cost>::max();
  // Rows and columns count from 1; 0 means none.
  const std::size_t places = size + 1;
  std::vector<Cost> row_potential(places), column_potential(places), least;
  std::vector<std::size_t> row_of(places), before(places);
  std::vector<char> used;
  for (std::size_t row = 1; row <= size; ++row) {
    row_of[0] = row;
    std::size_t column = 0;
    least.assign(places, kMost);
    used.assign(places, 0);
    do {
      used[column] = 1;
      const std::size_t from = row_of[column];
      Cost step = kMost;
      std::size_t next = 0;
      for (std::size_t j = 1; j <= size; ++j) {
        if (used[j] != 0) continue;
        const Cost reduced = costs[(from - 1) * size + j - 1] - row_potential[from] - column_potential[j];
        if (reduced < least[j]) {
          least[j] = reduced;
          before[j] = column;
        }
        if (least[j] < step) {
          step = least[j];
          next = j;
        }
      }
      for (std::size_t j = 0; j <= size; ++j) {
        if (used[j] != 0) {
          row_potential[row_of[j]] += step;
          column_potential[j] -= step;
        } else {
          least[j] -= step;
        }
      }
      column = next;
    } while (row_of[column] != 0);
    do {
      const std::size_t previous = before[column];
      row_of[column] = row_of[previous];
      column = previous;
    } while (column != 0);
  }
  std::vector<std::size_t> result(size);
  for (std::size_t j = 1; j <= size; ++j) result[row_of[j] - 1] = j - 1;
  return result;
}

}  // namespace nazori::base
