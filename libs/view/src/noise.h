// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

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
  NoiseLine(float y, std::uint32_t seed) : y_(y), seed_(seed) {
    for (std::size_t i = 0; i < kKnots; ++i)
      knots_[i] = value_noise(static_cast<float>(static_cast<int>(i) + kFirst), y, seed);
  }
  /// Beyond -8..55 it costs what value_noise costs.
  [[nodiscard]] float at(float x) const {
    const float column = std::floor(x);
    const int knot = static_cast<int>(column) - kFirst;
    if (knot < 0 || knot + 1 >= static_cast<int>(kKnots)) return value_noise(x, y_, seed_);
    float u = x - column;
    u = u * u * (3 - 2 * u);
    const float* ends = knots_.data() + knot;
    return ends[0] + (ends[1] - ends[0]) * u;
  }

 private:
  static constexpr std::size_t kKnots = 64;
  static constexpr int kFirst = -8;
  float y_;
  std::uint32_t seed_;
  std::array<float, kKnots> knots_{};
};

}  // namespace nazori::view
