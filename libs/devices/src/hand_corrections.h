// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "nazori/haptics/haptic_device.h"

namespace nazori::devices {

/// Visual correction: notices when the tip has slipped into a crossing groove, and makes the hand lift it and
/// put it down at the right point. Real-time-safe: yes.
class HandSight {
 public:
  /// How much higher than planned the hand aims.
  /// @param off_m  distance of the tip from the line, as seen from above.  @param to_target_m  distance of
  ///   the tip from the hand's target, as seen from above.  @param following  whether a stroke is being
  ///   followed.
  double lift_m(double off_m, double to_target_m, bool following, double elapsed_s) noexcept;
  /// Since the last call.
  int take_slips() noexcept { return std::exchange(slips_, 0); }

 private:
  double astray_s_ = 0;
  double lift_ = 0;
  bool lifting_ = false;
  int slips_ = 0;
};

/// Tactile correction: when friction holds the tip back, the hand pulls harder until the tip follows; when
/// the tip drifts aside, the hand pushes back as far as it notices. Real-time-safe: yes.
class HandPull {
 public:
  /// By how much the hand aims beyond its plan, seen from above.
  /// @param wrong_m  from the tip to where it should be on the line.  @param along  unit vector along the
  ///   line.
  /// @param movement  with another one the pull restarts from zero, because its direction differs.
  haptics::Vec3 lead_m(const haptics::Vec3& wrong_m, const haptics::Vec3& along, int movement,
                       double elapsed_s) noexcept;

 private:
  double ahead_ = 0;
  double aside_ = 0;
  int movement_ = -1;
};

}  // namespace nazori::devices
