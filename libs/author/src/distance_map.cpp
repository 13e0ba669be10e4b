// SPDX-License-Identifier: Apache-2.0
#include "distance_map.h"

#include <cmath>
#include <limits>

namespace nazori::author {

DistanceMap distance_map(const std::vector<std::uint8_t>& ink, int side) {
  DistanceMap map;
  map.side = side;
  map.distance.resize(ink.size());
  map.nearest.resize(ink.size());

  // Down each column: the row of the nearest pixel without ink, with rows -1 and `side` outside.
  std::vector<int> row_of(ink.size());
  for (int x = 0; x < side; ++x) {
    int last = -1;
    for (int y = 0; y < side; ++y) {
      if (ink[map.index(x, y)] == 0) last = y;
      row_of[map.index(x, y)] = last;
    }
    last = side;
    for (int y = side - 1; y >= 0; --y) {
      if (ink[map.index(x, y)] == 0) last = y;
      int& row = row_of[map.index(x, y)];
      if (last - y < y - row) row = last;
    }
  }

  // Along each row: the lowest of the parabolas that stand on the columns, with columns -1 and `side`
  // outside.
  const auto count = static_cast<std::size_t>(side) + 2;
  std::vector<int> stands(count);
  std::vector<double> begins(count + 1);
  for (int y = 0; y < side; ++y) {
    const auto height = [&](int x) {
      if (x < 0 || x >= side) return 0.0;
      const double d = row_of[map.index(x, y)] - y;
      return d * d;
    };
    std::size_t top = 0;
    stands[0] = -1;
    begins[0] = -std::numeric_limits<double>::infinity();
    begins[1] = std::numeric_limits<double>::infinity();
    for (int x = 0; x <= side; ++x) {
      const auto meets = [&](int other) {
        return (height(x) + static_cast<double>(x) * x - height(other) - static_cast<double>(other) * other) /
               (2.0 * (x - other));
      };
      double from = meets(stands[top]);
      while (from <= begins[top]) from = meets(stands[--top]);
      ++top;
      stands[top] = x;
      begins[top] = from;
      begins[top + 1] = std::numeric_limits<double>::infinity();
    }
    std::size_t at = 0;
    for (int x = 0; x < side; ++x) {
      while (begins[at + 1] < x) ++at;
      const int column = stands[at];
      const double d = x - column;
      const std::size_t i = map.index(x, y);
      map.distance[i] = static_cast<float>(std::sqrt(d * d + height(column)));
      map.nearest[i] = {column, column < 0 || column >= side ? y : row_of[map.index(column, y)]};
    }
  }
  return map;
}

}  // namespace nazori::author
