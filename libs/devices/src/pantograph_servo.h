// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "link_exchange.h"
#include "pantograph_model.h"

namespace nazori::devices::pantograph {

using Clock = std::chrono::steady_clock;

/// The last state of the board that the link received.
struct BoardPose {
  std::uint64_t number = 0;  ///< counts up
  PerJoint angle_deg{0, 0};
  bool pressed = false;
  haptics::DeviceState state = haptics::DeviceState::paused;
  haptics::DeviceTrouble trouble = haptics::DeviceTrouble::not_ready;  ///< none: the board can be used
  double delay_s = 0;                                                  ///< from pose to torque, as measured
  Clock::time_point at;
};

/// What the servo answers.
struct BoardTorques {
  std::uint64_t answers = 0;  ///< number of the pose
  PerJoint torque_n_m{0, 0};
  Clock::time_point at;
};

/// The servo's side of a pantograph: a clock thread calls tick(), which exchanges only newest values with the
/// communication thread. Real-time-safe.
class BoardServo {
 public:
  /// @param planned_delay_s  the delay for which the limits of the device were computed.
  /// @param half_width_m  of the tablet, tablet frame.  @param depth_m  of its deepest groove.
  BoardServo(ServoLink& link, const Model& model, double planned_delay_s, double half_width_m, double depth_m)
      : link_(link),
        linkage_(model.linkage),
        has_button_(model.setup.has_button),
        planned_delay_s_(planned_delay_s),
        half_width_m_(half_width_m),
        depth_m_(depth_m) {}

  /// Before the first tick. Thread: interface, while nothing ticks.
  void start() noexcept;
  /// Thread: servo.
  void tick() noexcept;

  LinkExchange<BoardPose, BoardTorques> exchange;

 private:
  /// Position of the tip, device frame. The plane has no depth, so the button presses the tip down; without a
  /// button the tip is down everywhere within the tablet's edges.
  [[nodiscard]] haptics::Vec3 tip(const LinkagePose& pose, bool pressed) noexcept;

  ServoLink& link_;
  const Linkage linkage_;
  const bool has_button_;
  const double planned_delay_s_, half_width_m_, depth_m_;
  double halfway_m_ = 0, height_m_ = 0;  // of the tip above the plateau, tablet frame
};

}  // namespace nazori::devices::pantograph
