// SPDX-License-Identifier: Apache-2.0
#include "relief.h"

#include <algorithm>
#include <cmath>

namespace nazori::view {
namespace {

/// The samples, from `first` on, that make up one new sample, and their weights (which sum to 1).
struct Taps {
  int first = 0;
  std::vector<float> weights;
};

double catmull_rom(double x) {
  x = std::abs(x);
  if (x < 1) return (1.5 * x - 2.5) * x * x + 1;
  if (x < 2) return ((-0.5 * x + 2.5) * x - 4) * x + 2;
  return 0;
}

double tent(double x) { return std::max(0.0, 1 - std::abs(x)); }

/// Samples beyond the edge have the value of the edge.
std::vector<Taps> make_taps(int from, int to) {
  const double step = static_cast<double>(from - 1) / (to - 1);
  const double width = std::max(step, 1.0);
  const double reach = step > 1 ? width : 2;
  std::vector<Taps> all(static_cast<std::size_t>(to));
  for (int i = 0; i < to; ++i) {
    const double centre = i * step;
    const int low = static_cast<int>(std::ceil(centre - reach));
    const int high = static_cast<int>(std::floor(centre + reach));
    Taps& taps = all[static_cast<std::size_t>(i)];
    taps.first = std::clamp(low, 0, from - 1);
    taps.weights.assign(static_cast<std::size_t>(std::clamp(high, 0, from - 1) - taps.first) + 1, 0.0F);
    double sum = 0;
    std::vector<double> weights(taps.weights.size(), 0.0);
    for (int k = low; k <= high; ++k) {
      const double weight = step > 1 ? tent((k - centre) / width) : catmull_rom(k - centre);
      weights[static_cast<std::size_t>(std::clamp(k, 0, from - 1) - taps.first)] += weight;
      sum += weight;
    }
    for (std::size_t k = 0; k < weights.size(); ++k) taps.weights[k] = static_cast<float>(weights[k] / sum);
  }
  return all;
}

}  // namespace

Relief resampled(const surface::HeightMap& map, int size) {
  const auto samples = map.samples();
  if (map.size() == size) return {size, {samples.begin(), samples.end()}};
  const auto taps = make_taps(map.size(), size);
  const auto from = static_cast<std::size_t>(map.size());
  const auto to = static_cast<std::size_t>(size);
  std::vector<float> rows(from * to);
  for (std::size_t row = 0; row < from; ++row) {
    const float* source = samples.data() + row * from;
    for (std::size_t column = 0; column < to; ++column) {
      const Taps& tap = taps[column];
      float sum = 0;
      for (std::size_t k = 0; k < tap.weights.size(); ++k)
        sum += source[static_cast<std::size_t>(tap.first) + k] * tap.weights[k];
      rows[row * to + column] = sum;
    }
  }
  Relief relief{size, std::vector<float>(to * to, 0.0F)};
  for (std::size_t row = 0; row < to; ++row) {
    float* target = relief.heights.data() + row * to;
    for (std::size_t k = 0; k < taps[row].weights.size(); ++k) {
      const float weight = taps[row].weights[k];
      const float* source = rows.data() + (static_cast<std::size_t>(taps[row].first) + k) * to;
      for (std::size_t column = 0; column < to; ++column) target[column] += source[column] * weight;
    }
    for (std::size_t column = 0; column < to; ++column)
      target[column] = std::clamp(target[column], 0.0F, 1.0F);
  }
  return relief;
}

}  // namespace nazori::view
