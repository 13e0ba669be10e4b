// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "link_exchange.h"

namespace nazori::devices::inverse {

using Clock = std::chrono::steady_clock;

/// The last state of the arm that the link received.
struct ArmPose {
  std::uint64_t number = 0;           ///< counts up
  haptics::Vec3 position_m{0, 0, 0};  ///< device frame: x right, y up, z towards the learner
  std::uint32_t buttons = 0;
  haptics::DeviceState state = haptics::DeviceState::paused;
  haptics::DeviceTrouble trouble = haptics::DeviceTrouble::not_ready;  ///< none: the arm can be used
  double delay_s = 0;                                                  ///< from pose to force, as measured
  Clock::time_point at;
};

/// What the servo answers.
struct ArmForce {
  std::uint64_t answers = 0;       ///< number of the pose
  haptics::Vec3 force_n{0, 0, 0};  ///< device frame
  Clock::time_point at;
};

/// The servo's side of an Inverse3: a clock thread calls tick(), which exchanges only newest values with the
/// communication thread. Real-time-safe.
class ArmServo {
 public:
  /// @param planned_delay_s  the delay for which the limits of the device were computed.
  ArmServo(ServoLink& link, double planned_delay_s) : link_(link), planned_delay_s_(planned_delay_s) {}

  /// Before the first tick. Thread: interface, while nothing ticks.
  void start() noexcept { exchange.reset(); }
  /// Thread: servo.
  void tick() noexcept;
  /// The arm was set to zero force while forces were not allowed. Thread: the link's.
  void confirm_no_force() noexcept { link_.confirm_no_force(); }

  LinkExchange<ArmPose, ArmForce> exchange;

 private:
  ServoLink& link_;
  const double planned_delay_s_;
};

}  // namespace nazori::devices::inverse
