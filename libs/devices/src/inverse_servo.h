// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "nazori/haptics/latest_value.h"
#include "servo_link.h"

namespace nazori::devices::inverse {

using Clock = std::chrono::steady_clock;

constexpr double kPeriod_s = 0.001;
/// No force is given for an older position, because the hand has moved on.
constexpr double kTooSlow_s = 0.020;

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
  void start() noexcept;
  /// Thread: servo.
  void tick() noexcept;
  /// The arm was set to zero force while forces were not allowed. Thread: the link's.
  void confirm_no_force() noexcept { link_.confirm_no_force(); }

  haptics::LatestValue<ArmPose> poses{ArmPose{}};     ///< written by the link, read by the servo
  haptics::LatestValue<ArmForce> forces{ArmForce{}};  ///< the other way

 private:
  ServoLink& link_;
  const double planned_delay_s_;
  bool lost_ = false;
};

}  // namespace nazori::devices::inverse
