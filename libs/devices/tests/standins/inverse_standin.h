// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

namespace nazori::devices::standin {

/// An Inverse Service on a free loopback port: one full inventory on connection, then exactly one state for
/// each message; /version over HTTP; commands that do not follow the documentation are counted.
class InverseService {
 public:
  enum class Answer : std::uint8_t { state, garbage, wrong_types, huge, nothing };

  /// @param port  0: any free one.
  explicit InverseService(std::uint16_t port = 0);
  ~InverseService();
  InverseService(const InverseService&) = delete;
  InverseService& operator=(const InverseService&) = delete;
  [[nodiscard]] std::uint16_t port() const;

  // The test writes. Metres in the service's frame: x right, y forward, z up.
  std::atomic<double> x_m{0}, y_m{-0.02}, z_m{0};
  std::atomic<bool> plugged{true}, calibrated{true}, ready{true}, button_a{false}, button_b{false};
  std::atomic<bool> takes_vector{true};  ///< else "values"; the other spelling is passed over
  std::atomic<bool> reports_force{true};
  std::atomic<const char*> version{"v3.5.1"};
  std::atomic<Answer> answer{Answer::state};
  std::atomic<int> delay_ms{0};
  std::atomic<bool> hang_up{false};  ///< ends the connection once
  // The service writes.
  std::atomic<double> force_x_n{0}, force_y_n{0}, force_z_n{0};
  std::atomic<int> sessions{0}, malformed{0}, messages{0};

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::devices::standin
