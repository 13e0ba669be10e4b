// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "inside.h"

namespace nazori::paint {
namespace {

/// A number in 0..1 for a point of a lattice. @source the finaliser of SplitMix64.
double random_at(std::int64_t column, std::int64_t row, std::uint64_t seed) {
  std::uint64_t z = seed * 0x9E3779B97F4A7C15ULL +
                    static_cast<std::uint64_t>(column) * 0xD1B54A32D192ED03ULL +
                    static_cast<std::uint64_t>(row) * 0x8CB92BA72F3D8DD7ULL;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  z ^= z >> 31U;
  return static_cast<double>(z >> 11U) * 0x1p-53;
}

/// Random values at the points of a lattice of unit width, and smooth between them.
double noise_at(double x, double y, std::uint64_t seed) {
  const double i = std::floor(x), j = std::floor(y);
  const double u = x - i, v = y - j;
  const double s = u * u * (3 - 2 * u), t = v * v * (3 - 2 * v);
  const auto column = static_cast<std::int64_t>(i), row = static_cast<std::int64_t>(j);
  const double upper = std::lerp(random_at(column, row, seed), random_at(column + 1, row, seed), s);
  const double lower = std::lerp(random_at(column, row + 1, seed), random_at(column + 1, row + 1, seed), s);
  return std::lerp(upper, lower, t);
}

/// Fibres that lie in one direction: long in it and thin across.
double fibres_at(double x_m, double y_m, double angle_rad, double thickness_m, std::uint64_t seed) {
  constexpr double kLengthPerThickness = 9;
  const double along = x_m * std::cos(angle_rad) + y_m * std::sin(angle_rad);
  const double across = y_m * std::cos(angle_rad) - x_m * std::sin(angle_rad);
  return noise_at(along / (kLengthPerThickness * thickness_m), across / thickness_m, seed);
}

/// The rank of each value, spread evenly over 0..65535: so every share of the cells is met exactly.
std::vector<std::uint16_t> ranked(const std::vector<double>& values) {
  std::vector<std::uint64_t> order(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    order[i] = static_cast<std::uint64_t>(values[i] * 0x1p40) << 20U | i;
  std::sort(order.begin(), order.end());
  std::vector<std::uint16_t> ranks(values.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank)
    ranks[order[rank] & 0xFFFFFU] = static_cast<std::uint16_t>((rank << 16U) / order.size());
  return ranks;
}

}  // namespace

Grain make_grain(int size, double grain_m, std::uint32_t seed) {
  constexpr double kPi = 3.14159265358979323846;
  constexpr std::array kDirections{0.35, 0.35 + kPi / 3, 0.35 + 2 * kPi / 3};
  const double cell_m = Sheet::kSide_m / size;
  const auto cells = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  std::vector<double> height(cells), density(cells);
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const double x = (column + 0.5) * cell_m, y = (row + 0.5) * cell_m;
      const std::size_t cell =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
      double web = 0;
      for (std::size_t i = 0; i < kDirections.size(); ++i)
        web += fibres_at(x, y, kDirections[i], grain_m, seed * 8ULL + i);
      web /= kDirections.size();
      const double fine = noise_at(x / (0.5 * grain_m), y / (0.5 * grain_m), seed * 8ULL + 3);
      const double coarse = noise_at(x / (12 * grain_m), y / (12 * grain_m), seed * 8ULL + 4);
      height[cell] = 0.55 * web + 0.45 * fine;
      density[cell] = 0.7 * web + 0.3 * coarse;
    }
  }
  return {ranked(height), ranked(density)};
}

}  // namespace nazori::paint
