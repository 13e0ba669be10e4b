// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "nazori/haptics/servo.h"

namespace nazori::recording {

/// Statistics of a series of samples.
class SampleStatistics {
 public:
  static constexpr int kEventBits = 16;

  /// Adds the next sample in order.
  void add(const haptics::ServoSample& sample);

  std::uint64_t samples = 0;
  std::uint64_t touching = 0;  ///< samples in contact
  std::uint64_t held = 0;      ///< samples in which a stroke attracted the stylus or was being written
  double first_s = 0;          ///< time of the first and of the last sample
  double last_s = 0;
  double peak_force_n = 0;
  double max_depth_m = 0;       ///< largest distance from the proxy to the device while in contact
  double longest_period_s = 0;  ///< between two samples
  std::array<std::uint64_t, kEventBits> events{};  ///< how often each bit of ServoEvent was set

  [[nodiscard]] double duration_s() const { return last_s - first_s; }
  [[nodiscard]] double mean_force_n() const;  ///< over all samples
  /// Mean over the samples in contact.
  [[nodiscard]] double mean_contact_force_n() const;
  /// Work between hand and tablet, computed as the force of one sample times the displacement to the next:
  /// given by the hand, returned to it, and kept by the tablet (dissipated, or stored in its spring if the
  /// series ends in contact).
  [[nodiscard]] double put_in_j() const { return put_in_j_; }
  [[nodiscard]] double got_back_j() const { return got_back_j_; }
  [[nodiscard]] double dissipated_j() const { return put_in_j_ - got_back_j_; }

 private:
  double force_sum_ = 0, contact_force_sum_ = 0;
  double put_in_j_ = 0, got_back_j_ = 0;
  haptics::Vec3 last_m_{0, 0, 0}, last_n_{0, 0, 0};
};

}  // namespace nazori::recording
