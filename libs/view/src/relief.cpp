// SPDX-License-Identifier: Apache-2.0
#include "relief.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace nazori::view {
namespace {

/// For each new sample the old ones that make it up, from first[i] on, and their weights (which sum to 1).
struct Taps {
  std::size_t each = 0;  ///< old samples for a new one; some have the weight 0
  std::vector<std::size_t> first;
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
Taps make_taps(int from, int to) {
  const double step = static_cast<double>(from - 1) / (to - 1);
  const double width = std::max(step, 1.0);
  const double reach = step > 1 ? width : 2;
  Taps taps;
  taps.each = static_cast<std::size_t>(std::min(2 * static_cast<int>(std::ceil(reach)) + 1, from));
  taps.weights.reserve(static_cast<std::size_t>(to) * taps.each);
  std::vector<double> weights(taps.each);
  for (int i = 0; i < to; ++i) {
    const double centre = i * step;
    const int low = static_cast<int>(std::ceil(centre - reach));
    const int high = static_cast<int>(std::floor(centre + reach));
    const int first = std::clamp(low, 0, from - static_cast<int>(taps.each));
    std::fill(weights.begin(), weights.end(), 0.0);
    double sum = 0;
    for (int k = low; k <= high; ++k) {
      const double weight = step > 1 ? tent((k - centre) / width) : catmull_rom(k - centre);
      weights[static_cast<std::size_t>(std::clamp(k, 0, from - 1) - first)] += weight;
      sum += weight;
    }
    taps.first.push_back(static_cast<std::size_t>(first));
    for (const double weight : weights) taps.weights.push_back(static_cast<float>(weight / sum));
  }
  return taps;
}

/// The new row `row`, of the old width. @param out  as wide as the old rows.
void mix_rows(std::span<const float> samples, const Taps& taps, std::size_t row, std::span<float> out) {
  std::fill(out.begin(), out.end(), 0.0F);
  const float* source = samples.data() + taps.first[row] * out.size();
  for (std::size_t k = 0; k < taps.each; ++k, source += out.size()) {
    const float weight = taps.weights[row * taps.each + k];
    for (std::size_t column = 0; column < out.size(); ++column) out[column] += source[column] * weight;
  }
}

}  // namespace

Relief resampled(const surface::HeightMap& map, int size) {
  const auto samples = map.samples();
  if (map.size() == size) return {size, {samples.begin(), samples.end()}};
  const Taps taps = make_taps(map.size(), size);
  const auto to = static_cast<std::size_t>(size);
  std::vector<float> mixed(static_cast<std::size_t>(map.size()));
  Relief relief{size, std::vector<float>(to * to)};
  for (std::size_t row = 0; row < to; ++row) {
    mix_rows(samples, taps, row, mixed);
    float* target = relief.heights.data() + row * to;
    const float* weights = taps.weights.data();
    for (std::size_t column = 0; column < to; ++column, weights += taps.each) {
      const float* source = mixed.data() + taps.first[column];
      float sum = 0;
      for (std::size_t k = 0; k < taps.each; ++k) sum += source[k] * weights[k];
      target[column] = std::clamp(sum, 0.0F, 1.0F);
    }
  }
  return relief;
}

}  // namespace nazori::view
