// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>

#include "nazori/haptics/device_status.h"
#include "nazori/haptics/latest_value.h"
#include "servo_link.h"

namespace nazori::devices {

/// Of a servo that a clock thread of this program drives.
constexpr double kLinkPeriod_s = 0.001;
/// No force is given for an older pose, because the hand has moved on.
constexpr double kTooSlow_s = 0.020;

/// What a servo and the thread that communicates with its device pass to each other: only newest values.
/// @tparam Pose  `number` counts up; `at`, `delay_s` (from pose to force, as measured), `state`, `trouble`
///   (none: the device can be used).
/// @tparam Command  what the servo answers; `answers` is the number of the pose, `at` the time. A default one
/// is without force.
template <class Pose, class Command>
class LinkExchange {
 public:
  using Clock = std::chrono::steady_clock;

  /// Forgets what a run before left. Thread: interface, while nothing ticks.
  void reset() noexcept {
    lost_ = false;
    poses.back() = {};
    poses.publish();
    commands.back() = {};
    commands.publish();
  }

  /// The newest pose is of a device that was lost: nothing is left to do. Thread: servo.
  [[nodiscard]] bool is_lost() const noexcept { return lost_; }

  /// Pauses the servo where the device cannot be used, or its pose is too old for a force. Thread: servo.
  /// @return whether it did.
  [[nodiscard]] bool pauses(ServoLink& link, const Pose& pose, Clock::time_point now,
                            std::uint32_t buttons) noexcept {
    if (pose.trouble != haptics::DeviceTrouble::none) {
      lost_ = pose.state == haptics::DeviceState::lost;
      link.pause(pose.state, pose.trouble, 0, buttons);
      return true;
    }
    const bool is_old = std::chrono::duration<double>(now - pose.at).count() > kTooSlow_s;
    if (!is_old && !(pose.delay_s > kTooSlow_s)) return false;
    link.pause(haptics::DeviceState::paused, haptics::DeviceTrouble::too_slow, 0, buttons);
    return true;
  }

  /// The servo's command for a pose; one without force where the servo does not tick. Thread: the link's.
  [[nodiscard]] Command await(std::uint64_t pose) noexcept {
    using std::chrono::duration_cast;
    constexpr auto kPeriod = duration_cast<Clock::duration>(std::chrono::duration<double>(kLinkPeriod_s));
    constexpr auto kAfterTick = std::chrono::microseconds(100);  // a tick takes a few microseconds
    constexpr auto kServoWait = std::chrono::milliseconds(20);
    const auto end = Clock::now() + kServoWait;
    for (;;) {
      const Command& command = commands.latest();
      if (command.answers == pose) return command;
      const auto now = Clock::now();
      if (now > end) return {};
      // Just after the next tick, so that its command is sent at once.
      std::this_thread::sleep_until(std::max(command.at + kPeriod, now) + kAfterTick);
    }
  }

  haptics::LatestValue<Pose> poses{Pose{}};           ///< written by the link, read by the servo
  haptics::LatestValue<Command> commands{Command{}};  ///< the other way

 private:
  bool lost_ = false;  // the servo thread's
};

}  // namespace nazori::devices
