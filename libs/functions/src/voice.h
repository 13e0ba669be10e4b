// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "nazori/functions/sound.h"

namespace nazori::functions {

struct StereoSample {
  double left = 0;
  double right = 0;
};

/// Constant-power panning from left (-1) to right (1).
[[nodiscard]] StereoSample panned(double value, double pan) noexcept;

/// One continuous tone with harmonics, partly noise, that glides to the set values. Does not allocate.
class Voice {
 public:
  explicit Voice(int sample_rate) noexcept;
  /// The next sample. @param trembles  for dense bands.
  [[nodiscard]] StereoSample next(const Cue& target, bool trembles) noexcept;

 private:
  double rate_;
  double ease_;
  double phase_ = 0;
  double tremolo_phase_ = 0;
  double hertz_ = 0;
  double pan_ = 0;
  double noise_ = 0;
  double loudness_ = 0;
  std::uint32_t seed_ = 20'050'401;
};

/// The earcon of a point of interest: two short tones. Does not allocate.
class Earcon {
 public:
  static constexpr double kSeconds = 0.12;

  Earcon(PointKind kind, double pan, int sample_rate) noexcept;
  [[nodiscard]] bool is_over() const noexcept { return at_ >= count_; }
  [[nodiscard]] StereoSample next() noexcept;

 private:
  double rate_;
  double first_hz_;
  double second_hz_;
  double pan_;
  std::size_t at_ = 0;
  std::size_t count_;
};

}  // namespace nazori::functions
