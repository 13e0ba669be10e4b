// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <stop_token>

#include "link_thread.h"
#include "pantograph_serial.h"
#include "pantograph_servo.h"

namespace nazori::devices::pantograph {

/// Time without an answer after which the servo gives no more force.
constexpr auto kAnswerWait = std::chrono::milliseconds(20);

/// The result of a request.
enum class Answer : std::uint8_t {
  reading,
  nothing,  ///< no answer, or an incomplete one
  garbage,  ///< an answer of another device, or an invalid one
  gone,     ///< the port is gone
};

/// Reads the answer to the last written torques, in any number of parts.
[[nodiscard]] Answer read_answer(SerialPort& port, const BoardSetup& setup, Reading& reading,
                                 std::chrono::milliseconds wait) noexcept;

/// All communication with the board of a running device: a thread that writes the servo's newest torques and
/// reads the angles, once per tick of the servo. The board has no watchdog: it keeps the last torques. So the
/// last command is zero, repeated until the board confirms it. Torques are sent only while a servo ticks,
/// answers come and forces are allowed.
class BoardLink {
 public:
  BoardLink(std::shared_ptr<SerialPort> port, const BoardSetup& setup, double give_up_s, ServoLink& feeling,
            BoardServo& servo);
  ~BoardLink();
  BoardLink(const BoardLink&) = delete;
  BoardLink& operator=(const BoardLink&) = delete;

  /// Thread: interface. Before the servo's clock starts.
  [[nodiscard]] base::Result<void> start();
  /// After the servo's clock has stopped. Returns when the board has confirmed a torque of zero, or after
  /// about 0.1 s without a confirmation.
  void stop() noexcept;
  [[nodiscard]] bool is_running() const noexcept { return thread_.is_running(); }

  /// Writes zero without this object's thread. Safe in signal handlers. @param link  a BoardLink.
  static void write_zero_at_end(void* link) noexcept;
  static constexpr ForceGuard::Off kWriteZero = &write_zero_at_end;

 private:
  void run(const std::stop_token& stop) noexcept;
  void turn() noexcept;
  /// Writes `torques_`, or zero where forces are not allowed. @return false where the port is gone.
  [[nodiscard]] bool ask() noexcept;
  void publish(haptics::DeviceState state, haptics::DeviceTrouble trouble, const Reading& reading) noexcept;
  /// The servo's torques for the last published pose; zero where the servo does not tick.
  [[nodiscard]] PerJoint await_torques() noexcept;
  /// Sends zero until the board confirms it.
  void rest_at_zero() noexcept;

  const std::shared_ptr<SerialPort> port_;
  const BoardSetup setup_;
  const double give_up_s_;
  const Packet zero_;
  ServoLink& feeling_;
  BoardServo& servo_;
  // Its own thread.
  PerJoint torques_{0, 0};
  bool held_ = false;  // whether forces were suspended at the last check
  haptics::DeviceTrouble why_lost_ = haptics::DeviceTrouble::none;
  Clock::time_point asked_at_, last_good_;
  std::uint64_t poses_ = 0;
  double delay_s_ = 0;
  LinkThread thread_;  // declared last, so that it ends before the other members are destroyed
};

}  // namespace nazori::devices::pantograph
