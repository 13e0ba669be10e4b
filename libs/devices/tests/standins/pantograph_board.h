// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace nazori::devices::standin {

/// A Haply board with the arms of a 2diy of version 3, at a pseudo-terminal. It behaves like the firmware
/// (HaplyHaptics/Haply-Arduino-Firmware-Versions, M0 0.3 and M3 1.5, read, not run), including its
/// weaknesses: commands have no end mark, so extra bytes are the next command; it reads the head of a command
/// without waiting and waits for torques for up to a second; before it is set up it answers a torque command
/// only with its id; it counts steps from the position of the arms when it is set up; it keeps every torque
/// until the next one, even after a reset.
class PantographBoard {
 public:
  enum class Fault : std::uint8_t {
    none,
    silent,         ///< accepts torques and does not answer
    half,           ///< stops in the middle of an answer
    wrong_id,       ///< answers as another device
    no_number,      ///< an angle that is not a number
    answers_twice,  ///< an older answer before each
    answers_later,  ///< once: the answer again 0.3 ms later
    forgets,        ///< loses its parameters, as after a loss of power; then continues
  };

  /// @param runs  false: run() is called later, once a child process uses the port.
  explicit PantographBoard(bool runs = true);
  ~PantographBoard();
  PantographBoard(const PantographBoard&) = delete;
  PantographBoard& operator=(const PantographBoard&) = delete;
  void run();
  [[nodiscard]] const std::string& path() const;  ///< of the port
  void unplug();

  static constexpr double kMostTorque_n_m = 0.123;

  // Written by the test. Index 0 is port 1, the left arm; 1 is port 2, the right one.
  std::array<std::atomic<double>, 2> arm_deg{12, 168};  ///< of the inner arms; this is rest
  std::atomic<double> knocked_deg{0};  ///< by how much a hand turns both arms once the board was set up
  /// Reports other_deg in every second answer; the program must push only at arm_deg.
  std::atomic<bool> swings{false};
  std::array<std::atomic<double>, 2> other_deg{12, 168};
  std::atomic<double> a2{4095};  ///< level of the analogue input
  std::atomic<Fault> fault{Fault::none};
  std::atomic<int> delay_ms{0};
  std::atomic<int> piece{64};  ///< number of bytes of an answer that come at a time
  // The board writes.
  std::array<std::atomic<double>, 2> torque_n_m{0, 0};  ///< as the motors have them, cut off
  std::atomic<int> setups{0}, resets{0}, questions{0}, zeros{0};
  std::atomic<int> in_time{0};     ///< while angles alternate: torques that match the newest angles
  std::atomic<int> late{0};        ///< ... and older ones
  std::atomic<int> idle{0};        ///< increases while nothing is left to be read
  std::atomic<int> unknown{0};     ///< bytes that are not a command
  std::atomic<int> incomplete{0};  ///< incomplete commands

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::devices::standin
