// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nazori::view {

/// 0 up to `low`, 1 from `high` on, and a smooth step between.
[[nodiscard]] inline float smooth_step(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

/// A fixed pseudo-random number in [0, 1) for a lattice point: the same on every machine.
[[nodiscard]] inline float lattice_random(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8DA6B343U ^
                    static_cast<std::uint32_t>(y) * 0xD8163841U ^ seed * 0xCB1AB31FU;
  h ^= h >> 15;
  h *= 0x2C1B3C6DU;
  h ^= h >> 12;
  h *= 0x297A2D39U;
  h ^= h >> 15;
  return static_cast<float>(h >> 8) * (1.0F / 16777216.0F);
}

/// Smooth value noise in [0, 1), one random value per unit square.
[[nodiscard]] inline float value_noise(float x, float y, std::uint32_t seed) {
  const float column = std::floor(x);
  const float row = std::floor(y);
  const auto i = static_cast<std::int32_t>(column);
  const auto j = static_cast<std::int32_t>(row);
  float u = x - column;
  float v = y - row;
  u = u * u * (3 - 2 * u);
  v = v * v * (3 - 2 * v);
  const float a = lattice_random(i, j, seed);
  const float b = lattice_random(i + 1, j, seed);
  const float c = lattice_random(i, j + 1, seed);
  const float d = lattice_random(i + 1, j + 1, seed);
  return a + (b - a) * u + (c - a + (a - b - c + d) * u) * v;
}

/// value_noise along a line of one y, whose random values are drawn once. It costs a quarter of the time.
class NoiseLine {
 public:
  /// @param low,high  where most values will be asked for.
  NoiseLine(float y, std::uint32_t seed, float low = -8, float high = 55)
      : seed_(seed), first_(static_cast<std::int32_t>(std::floor(low))) {
    const std::int32_t count = static_cast<std::int32_t>(std::floor(high)) - first_ + 2;
    knots_.resize(static_cast<std::size_t>(count));
    set_y(y);
  }
  /// Moves the line.
  void set_y(float y) {
    y_ = y;
    const float row = std::floor(y);
    const auto j = static_cast<std::int32_t>(row);
    float v = y - row;
    v = v * v * (3 - 2 * v);
    std::int32_t i = first_;
    for (float& knot : knots_) {
      const float above = lattice_random(i, j, seed_);
      knot = above + (lattice_random(i, j + 1, seed_) - above) * v;
      ++i;
    }
  }
  /// Beyond `low` and `high` it costs what value_noise costs.
  [[nodiscard]] float at(float x) const {
    const float past = x - static_cast<float>(first_);
    if (past < 0 || past >= static_cast<float>(knots_.size() - 1)) return value_noise(x, y_, seed_);
    const auto knot = static_cast<std::size_t>(past);
    float u = past - static_cast<float>(knot);
    u = u * u * (3 - 2 * u);
    const float* ends = knots_.data() + knot;
    return ends[0] + (ends[1] - ends[0]) * u;
  }

 private:
  float y_ = 0;
  std::uint32_t seed_;
  std::int32_t first_;
  std::vector<float> knots_;
};

}  // namespace nazori::view
