// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/brush/tuft.h"

namespace nazori::brush {

/// A pen, mouse, finger or device at one moment.
struct PenSample {
  double time_s = 0;  ///< after the sample before
  geometry::PaperPoint at;
  bool down = true;                     ///< on the paper; ignored where height_m is given
  std::optional<double> pressure = {};  ///< 0..1, of a pen
  std::optional<double> height_m =
      {};                  ///< of a force-feedback device's tip above the paper; it wins over `pressure`
  double lean_rad = 0;     ///< of the holder from upright
  double lean_to_rad = 0;  ///< side to which its upper end leans, from x to y
  double twist_rad = 0;    ///< of the holder about its axis

  /// @return whether it is on the paper: by its height where that is known.
  [[nodiscard]] bool is_down() const noexcept { return height_m ? *height_m < 0 : down; }
  /// The same pen above the paper, whatever its height was.
  [[nodiscard]] PenSample lifted() const noexcept {
    PenSample up = *this;
    up.down = false;
    up.height_m.reset();
    return up;
  }
};

/// How a pen becomes a brush.
struct Handling {
  double full_depth = 0.35;      ///< depth at full pressure [length of the hair], 0..Tuft::kMostDepth
  double lifted_m = 0.005;       ///< how far a pen that is not down is above the paper
  bool guess_pressure = true;    ///< where there is no pressure: from the speed; otherwise `steady_pressure`
  double steady_pressure = 0.5;  ///< without pressure, where none is guessed
  double slow_m_s = 0.02;        ///< up to this speed the guessed pressure is kSlowPressure
  double fast_m_s = 0.40;        ///< from this speed on it is kFastPressure
  double settles_s = 0.06;       ///< time constant with which the guessed pressure follows the speed
};

/// Guessed pressures: a slow hand presses, a fast one sweeps, and each sets the brush down first.
inline constexpr double kTouchPressure = 0.3;
inline constexpr double kSlowPressure = 0.75;
inline constexpr double kFastPressure = 0.15;

/// Turns the samples of a pen into poses of a brush, one after the other. The guessed pressure follows the
/// speed with a time constant, so it does not depend on how often the pen is reported. It begins at
/// kTouchPressure where the pen comes down and falls to zero nowhere by itself. Thread-safe: no.
class PenToHolder {
 public:
  PenToHolder(const TuftForm& form, const Handling& handling);
  /// The pose for the next sample.
  [[nodiscard]] HolderPose next(const PenSample& sample) noexcept;

 private:
  double hair_m_;
  Handling handling_;
  std::optional<PenSample> before_;
  double guessed_ = 0;
};

}  // namespace nazori::brush
