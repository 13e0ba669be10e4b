// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace nazori::devices::standin {

/// A Haply board with the arms of a 2diy of version 3, at a pseudo-terminal. It does what the firmware does
/// (HaplyHaptics/Haply-Arduino-Firmware-Versions, M0 0.3 and M3 1.5, read, not run), the awkward sides
/// included: it knows no end of a command, so what is too much of one is the next; reads the head of a
/// command without waiting and torques for up to a second; answers a question for torques with its id alone
/// before it was set up; counts steps from where the arms are when it is set up; holds every torque until it
/// is told another, after a reset too.
class PantographBoard {
 public:
  enum class Fault : std::uint8_t {
    none,
    silent,         ///< takes torques and does not answer
    half,           ///< stops in the middle of an answer
    wrong_id,       ///< answers as another device
    no_number,      ///< an angle that is not a number
    answers_twice,  ///< an older answer before each
    answers_later,  ///< once: the answer again 0.3 ms later
    forgets,        ///< loses its parameters, as after a loss of power; then goes on
  };

  /// @param runs  false: run() is called later, once there is a child that uses the port.
  explicit PantographBoard(bool runs = true);
  ~PantographBoard();
  PantographBoard(const PantographBoard&) = delete;
  PantographBoard& operator=(const PantographBoard&) = delete;
  void run();
  [[nodiscard]] const std::string& path() const;  ///< of the port
  void unplug();

  static constexpr double kMostTorque_n_m = 0.123;

  // The test writes. Index 0 is port 1, the left arm; 1 is port 2, the right one.
  std::array<std::atomic<double>, 2> arm_deg{12, 168};  ///< of the inner arms; this is rest
  /// Tells other_deg in every second answer; the program is to push at arm_deg and only there.
  std::atomic<bool> swings{false};
  std::array<std::atomic<double>, 2> other_deg{12, 168};
  std::atomic<double> a2{4095};  ///< level of the analogue input
  std::atomic<Fault> fault{Fault::none};
  std::atomic<int> delay_ms{0};
  std::atomic<int> piece{64};  ///< so many bytes of an answer come at a time
  // The board writes.
  std::array<std::atomic<double>, 2> torque_n_m{0, 0};  ///< as the motors have them, cut off
  std::atomic<int> setups{0}, resets{0}, questions{0}, zeros{0};
  std::atomic<int> in_time{0};     ///< where it swings: torques that answer the newest angles
  std::atomic<int> late{0};        ///< ... and older ones
  std::atomic<int> idle{0};        ///< counts on while nothing is left to be read
  std::atomic<int> unknown{0};     ///< bytes that are no command
  std::atomic<int> incomplete{0};  ///< commands whose rest did not come

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::devices::standin
