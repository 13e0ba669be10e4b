// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "nazori/haptics/haptic_device.h"

namespace nazori::haptics {

/// A force in the plane of the plateau that looks random, changes smoothly, and is the same for the same
/// seed: the sum of kTones sines for each axis, their frequencies and phases drawn from the seed. It has no
/// mean and nothing outside kLowest_hz..kHighest_hz, and is never longer than 1.
///
/// @source noise-like disturbance in training: J. Lee, S. Choi, Effects of haptic guidance and disturbance on
/// motor learning, IEEE Haptics Symposium 2010. Sines instead of filtered noise, for the hard bound: own
/// design. Thread-safe: no. Real-time-safe: all but the constructor.
class Disturbance {
 public:
  static constexpr std::size_t kTones = 4;
  static constexpr double kLowest_hz = 0.4;   ///< slower changes are felt as a constant pull
  static constexpr double kHighest_hz = 3.0;  ///< faster ones are filtered out by the hand

  Disturbance() = default;
  Disturbance(std::uint64_t seed, double period_s);

  /// One period on.
  void advance() noexcept;
  /// Length at most 1, z = 0.
  [[nodiscard]] Vec3 value() const noexcept;

 private:
  struct Tone {
    double cos = 1, sin = 0;            // now
    double step_cos = 1, step_sin = 0;  // rotation per period
  };
  std::array<std::array<Tone, kTones>, 2> axes_{};
};

}  // namespace nazori::haptics
