// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <stop_token>
#include <string>

#include "inverse_connection.h"
#include "inverse_messages.h"
#include "inverse_servo.h"
#include "link_thread.h"
#include "nazori/devices/inverse_service.h"

namespace nazori::devices::inverse {

constexpr auto kConnectWait = std::chrono::milliseconds(500);
constexpr auto kSendWait = std::chrono::milliseconds(50);
/// After this time without a message the connection counts as lost.
constexpr auto kSilence = std::chrono::milliseconds(1000);

/// The service: x right, y forward, z up. Devices: x right, y up, z towards the learner.
inline haptics::Vec3 to_device_frame(const haptics::Vec3& v) noexcept { return {v.x, v.z, -v.y}; }
inline haptics::Vec3 to_service_frame(const haptics::Vec3& v) noexcept { return {v.x, -v.z, v.y}; }

/// The arm and the settings of the connection to its service.
struct ArmAddress {
  std::string device_id;
  Dialect dialect;
  haptics::Vec3 centre_m{0, 0, 0};  ///< middle of its workspace, in the frame of the service
};

/// All communication with the service: a thread that connects, reads the newest state of the arm and sends
/// the servo's newest force, once per tick of the servo. It reconnects automatically until the arm has been
/// missing for too long. Forces are sent only while a servo ticks and the arm has no fault.
class ArmLink {
 public:
  /// The service takes the force off when the session ends.
  static constexpr ForceGuard::Off kWriteZero = nullptr;

  ArmLink(InverseServiceSettings settings, ArmAddress arm, ArmServo& servo);
  ~ArmLink();
  ArmLink(const ArmLink&) = delete;
  ArmLink& operator=(const ArmLink&) = delete;

  /// Thread: interface. Before the servo's clock starts.
  [[nodiscard]] base::Result<void> start();
  /// After the servo's clock has stopped. The last message sets zero force; then the session ends, and with
  /// it any force.
  void stop() noexcept;
  [[nodiscard]] bool is_running() const noexcept { return thread_.is_running(); }

 private:
  void run(const std::stop_token& stop) noexcept;
  void talk(const std::stop_token& stop);
  void connect(const std::stop_token& stop);
  void turn();
  /// Reads the newest message. @return why the arm cannot be used.
  haptics::DeviceTrouble read();
  void publish(haptics::DeviceTrouble trouble, const ArmState* arm);
  /// The servo's force for the last published pose; none where the servo does not tick.
  [[nodiscard]] haptics::Vec3 await_force();
  void send(const haptics::Vec3& service_n);
  void disconnect(haptics::DeviceTrouble why);
  /// Whether the arm obeys commands; if not, tries the other spelling once.
  bool obeys(const ArmState& arm);

  const InverseServiceSettings settings_;
  ArmAddress arm_;
  ArmServo& servo_;
  // Its own thread.
  std::unique_ptr<Connection> connection_;
  TickMessage tick_message_;
  std::string message_;
  ServiceState state_;
  haptics::DeviceTrouble trouble_ = haptics::DeviceTrouble::service_gone;  // published last
  bool key_changed_ = false, lost_ = false, session_begun_ = false;
  Clock::duration retry_{};
  Clock::time_point next_try_, last_good_, asked_at_, heard_at_, doubted_since_;
  haptics::Vec3 commanded_n_{0, 0, 0};
  std::uint64_t poses_ = 0;
  double delay_s_ = 0;
  int bad_messages_ = 0;
  LinkThread thread_;  // declared last, so that it ends before the other members are destroyed
};

}  // namespace nazori::devices::inverse
