// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/haptics/haptic_device.h"

namespace nazori::devices {

/// The result of a trial without force.
struct TrialResult {
  /// Upper edges of the first bins of `lateness`, beyond the nominal period; the last bin has none.
  static constexpr std::array<double, 7> kEdges_s{0.00005, 0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005};

  std::uint64_t ticks = 0;
  std::uint64_t absent = 0;  ///< ticks without a stylus
  double seconds = 0;        ///< from the first tick to the last
  double rate_hz = 0;
  std::array<std::uint64_t, kEdges_s.size() + 1> lateness{};  ///< number of ticks in each bin of lateness
  double max_lateness_s = 0;
  /// Root-mean-square distance from the mean position over the quietest kRestTicks in a row; negative: too
  /// few ticks.
  double rest_noise_m = -1;
  std::uint32_t buttons_seen = 0;  ///< every button that was down at some time
};

/// A servo that gives no force and measures: rate, lateness, noise of the position at rest. tick() is
/// real-time-safe; call result() after the device has stopped.
class DeviceTrial final : public haptics::ServoCallback {
 public:
  static constexpr int kRestTicks = 250;

  /// @param rate_hz  nominal, > 0.
  explicit DeviceTrial(double rate_hz) : period_s_(1 / rate_hz) {}
  haptics::Vec3 tick(const haptics::DeviceSample& sample) noexcept override;
  [[nodiscard]] TrialResult result() const;

 private:
  double period_s_;
  TrialResult found_;
  double first_s_ = 0, last_s_ = 0;
  int in_window_ = 0;
  haptics::Vec3 origin_{0, 0, 0}, sum_{0, 0, 0};
  double sum_squares_ = 0;
};

/// Whether this machine can run a servo on time.
struct RealTimeReadiness {
  long priority_limit = 0;  ///< the limit rtprio; 0 none, -1 unlimited
  long locked_bytes = 0;    ///< memlock; -1 no limit
  std::string kernel;       ///< "6.1.0-28-amd64 #1 SMP PREEMPT_DYNAMIC ..."
  bool kernel_preempts = false;
  std::vector<std::string> advice;  ///< one sentence for each change to make; empty: ready
};

/// Of this process.
[[nodiscard]] RealTimeReadiness real_time_readiness();
/// The readiness of a machine with these properties. @param kernel_version  the output of uname -v. @param
/// capabilities  of the process, as bits: CAP_SYS_NICE and CAP_IPC_LOCK, which root has, lift the limits.
[[nodiscard]] RealTimeReadiness real_time_readiness(long priority_limit, long locked_bytes,
                                                    std::string_view kernel_release,
                                                    std::string_view kernel_version,
                                                    std::uint64_t capabilities = 0);
/// The effective capabilities in the text of /proc/self/status; 0 where it contains none.
[[nodiscard]] std::uint64_t effective_capabilities(std::string_view proc_status);

}  // namespace nazori::devices
