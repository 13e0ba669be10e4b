// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/relief.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "inside.h"

namespace nazori::paint {
namespace {

/// Pigment of every layer in each cell, in kOne, row by row.
std::vector<float> thickness_of(const Sheet& sheet) {
  const auto size = static_cast<std::size_t>(sheet.size());
  std::vector<float> thickness(size * size);
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      const Tile& tile = sheet.inside().tile_at(static_cast<int>(column), static_cast<int>(row));
      const std::size_t cell = Sheet::Inside::cell_at(static_cast<int>(column), static_cast<int>(row));
      TotalAmount sum = tile.ground ? tile.ground->covered[cell] : 0;
      for (std::size_t k = 0; k < kSlots; ++k) sum += TotalAmount{tile.moving[k][cell]} + tile.fixed[k][cell];
      thickness[row * size + column] = static_cast<float>(to_fraction(sum));
    }
  }
  return thickness;
}

/// The mean over `reach` values to each side; beyond the end there is no paint.
void level(std::vector<float>& values, std::size_t first, std::size_t stride, std::size_t count, int reach) {
  std::vector<double> sums(count + 1);
  for (std::size_t i = 0; i < count; ++i)
    sums[i + 1] = sums[i] + static_cast<double>(values[first + i * stride]);
  for (std::size_t i = 0; i < count; ++i) {
    const auto before = static_cast<std::size_t>(std::max(static_cast<int>(i) - reach, 0));
    const auto after = std::min(i + static_cast<std::size_t>(reach) + 1, count);
    values[first + i * stride] = static_cast<float>((sums[after] - sums[before]) / (2 * reach + 1));
  }
}

}  // namespace

surface::HeightMap relief_of(const Sheet& sheet, const ReliefOptions& options) {
  constexpr double kMostSmooth_m = 0.002;
  const auto size = static_cast<std::size_t>(sheet.size());
  std::vector<float> thickness = thickness_of(sheet);
  const int reach =
      static_cast<int>(std::lround(std::clamp(options.smooth_m, 0.0, kMostSmooth_m) / (2 * sheet.cell_m())));
  for (std::size_t i = 0; reach > 0 && i < size; ++i) level(thickness, i * size, 1, size, reach);
  for (std::size_t i = 0; reach > 0 && i < size; ++i) level(thickness, i, size, size, reach);
  auto map = surface::HeightMap::create(sheet.size()).value();
  for (int row = 0; row < sheet.size(); ++row) {
    for (int column = 0; column < sheet.size(); ++column) {
      const Tile& tile = sheet.inside().tile_at(column, row);
      const auto at = sheet.inside().paper_at(column, row);
      const double paint =
          options.per_filling *
          static_cast<double>(
              thickness[static_cast<std::size_t>(row) * size + static_cast<std::size_t>(column)]);
      // As much paint as the grain is high fills its hollows.
      const double bare = options.tooth > 0 ? std::max(1 - paint / options.tooth, 0.0) : 0;
      const double grain = options.tooth * bare * (tile.height[at] / 65535.0 - 1);
      map.set(column, row, static_cast<float>(options.paper + paint + grain));
    }
  }
  return map;
}

}  // namespace nazori::paint
