// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "nazori/haptics/haptic_device.h"

namespace nazori::devices {

/// The eye that watches the hand: sees when the tip has gone astray, into a groove that crosses, and has the
/// hand lift it and put it down again where it should be. Real-time-safe: yes.
class HandSight {
 public:
  /// How much higher than planned the hand wants the tip.
  /// @param off_m  of the tip from the line, seen from above.  @param to_target_m  of the tip from where the
  /// hand wants it, seen from above.  @param following  whether a stroke is being followed.
  double lift_m(double off_m, double to_target_m, bool following, double elapsed_s) noexcept;
  /// Since the last call.
  int take_slips() noexcept { return std::exchange(slips_, 0); }

 private:
  double astray_s_ = 0;
  double lift_ = 0;
  bool lifting_ = false;
  int slips_ = 0;
};

/// The hand that feels the tip hang behind, held back by friction, and pulls harder until it comes along; and
/// that leans against its drifting aside, as far as it notices. Real-time-safe: yes.
class HandPull {
 public:
  /// By how much the hand aims beyond its plan, seen from above.
  /// @param wrong_m  from the tip to where it should be on the line.  @param along  unit vector along the
  /// line.
  /// @param movement  with another one the pull begins again from nothing: it has another direction.
  haptics::Vec3 lead_m(const haptics::Vec3& wrong_m, const haptics::Vec3& along, int movement,
                       double elapsed_s) noexcept;

 private:
  double ahead_ = 0;
  double aside_ = 0;
  int movement_ = -1;
};

}  // namespace nazori::devices
