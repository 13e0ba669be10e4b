// SPDX-License-Identifier: Apache-2.0
// What makes a Disturbance; its tick is in disturbance_tick.cpp.
#include "disturbance.h"

#include <cmath>
#include <numbers>

namespace nazori::haptics {
namespace {

/// @source S. Vigna, splitmix64 (public domain).
std::uint64_t next_random(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

double unit(std::uint64_t& state) { return static_cast<double>(next_random(state) >> 11U) * 0x1p-53; }

}  // namespace

Disturbance::Disturbance(std::uint64_t seed, double period_s) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (auto& axis : axes_)
    for (std::size_t i = 0; i < kTones; ++i) {
      // One tone in each of kTones equal parts of the band, so that none is missing.
      const double part = (static_cast<double>(i) + unit(seed)) / static_cast<double>(kTones);
      const double step = kTurn * (kLowest_hz + part * (kHighest_hz - kLowest_hz)) * period_s;
      const double phase = kTurn * unit(seed);
      axis[i] = {std::cos(phase), std::sin(phase), std::cos(step), std::sin(step)};
    }
}

}  // namespace nazori::haptics
