// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

namespace nazori::devices::standin {

/// An Inverse Service on a free loopback port: one full inventory on connection, then a state for each
/// message, or more where the test says so; /version over HTTP; the origin at the base of the arm until a
/// preset moves it; commands that do not follow the documentation are counted.
class InverseService {
 public:
  enum class Answer : std::uint8_t { state, garbage, wrong_types, huge, nothing };

  /// @param port  0: any free one.
  explicit InverseService(std::uint16_t port = 0);
  ~InverseService();
  InverseService(const InverseService&) = delete;
  InverseService& operator=(const InverseService&) = delete;
  [[nodiscard]] std::uint16_t port() const;

  /// The middle of the workspace of a right-handed Inverse3, measured from its base.
  static constexpr double kCentre_m[3] = {0.0186, -0.153, 0.151};

  // Written by the test. Metres from the middle of the workspace, in the service's frame: x right, y forward,
  // z up.
  std::atomic<double> x_m{0}, y_m{-0.02}, z_m{0};
  std::atomic<bool> plugged{true}, calibrated{true}, ready{true}, button_a{false}, button_b{false};
  std::atomic<bool> takes_vector{true};  ///< else "values"; the other spelling is ignored
  std::atomic<bool> reports_force{true};
  std::atomic<bool> reports_no_other_than_zero{false};  ///< whatever the force is
  std::atomic<const char*> version{"v3.5.1"};           ///< null: /version is not there
  std::atomic<bool> knows_presets{true};                ///< from 3.5 on; before, a preset is ignored
  std::atomic<const char*> type{"inverse3"};
  std::atomic<bool> left_handed{false};
  std::atomic<int> states_for_a_message{1};
  std::atomic<Answer> answer{Answer::state};
  std::atomic<int> delay_ms{0};
  std::atomic<bool> garbles_inventory{false};  ///< of the next sessions
  std::atomic<bool> hang_up{false};            ///< ends the connection once
  // The service writes.
  std::atomic<double> force_x_n{0}, force_y_n{0}, force_z_n{0};
  std::atomic<double> last_command_n{-1};  ///< size of the last commanded force, of any session
  std::atomic<int> sessions{0}, malformed{0}, messages{0};
  std::atomic<int> spelling_changes{0};    ///< from "vector" to "values" or back
  std::atomic<int> most_after_garbled{0};  ///< messages in a session whose inventory was garbled

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::devices::standin
