// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>

#include "nazori/model/plate.h"

namespace nazori::model {

/// Hills and valleys of up to `depth_mm` that end before the edge.
inline surface::HeightMap hills(int size) {
  auto map = surface::HeightMap::create(size).value();
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const double u = 2.0 * column / (size - 1) - 1;
      const double v = 2.0 * row / (size - 1) - 1;
      const double fade = std::max(0.0, 1 - u * u) * std::max(0.0, 1 - v * v);
      map.set(column, row,
              static_cast<float>(1 - fade * (0.5 + 0.5 * std::sin(9 * u) * std::cos(7 * v + u))));
    }
  }
  return map;
}

/// Every sample at random, also on the rim: the worst relief there is.
inline surface::HeightMap noise(int size, unsigned seed) {
  auto map = surface::HeightMap::create(size).value();
  std::mt19937 random(seed);
  for (float& height : map.samples()) height = static_cast<float>(random() % 1000) / 1000.0F;
  return map;
}

/// Volume under the plate's samples, cell by cell, with holes.
inline double volume_of_samples(const Plate& plate) {
  double sum = 0;
  for (int row = 0; row + 1 < plate.rows(); ++row) {
    for (int column = 0; column + 1 < plate.columns(); ++column)
      sum += (plate.at(column, row) + plate.at(column + 1, row) + plate.at(column, row + 1) +
              plate.at(column + 1, row + 1)) /
             4.0;
  }
  return sum * plate.step_mm() * plate.step_mm();
}

}  // namespace nazori::model
