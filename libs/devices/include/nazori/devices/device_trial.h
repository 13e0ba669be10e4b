// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/haptics/haptic_device.h"

namespace nazori::devices {

/// What a trial without force found.
struct TrialResult {
  /// Upper edges of the first bins of `lateness`, beyond the nominal period; the last bin has none.
  static constexpr std::array<double, 7> kEdges_s{0.00005, 0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005};

  std::uint64_t ticks = 0;
  std::uint64_t absent = 0;  ///< ticks without a stylus
  double seconds = 0;        ///< from the first tick to the last
  double rate_hz = 0;
  std::array<std::uint64_t, kEdges_s.size() + 1> lateness{};  ///< ticks by how late they came
  double max_lateness_s = 0;
  /// Root of the mean square distance from the mean over the quietest kRestTicks in a row; negative: too few.
  double rest_noise_m = -1;
  std::uint32_t buttons_seen = 0;  ///< every button that was down at some time
};

/// A servo that feels nothing and measures: rate, lateness, noise of the pose at rest.
/// tick() is real-time-safe; result() is for after the device has stopped.
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

/// Whether this machine lets a servo keep time.
struct RealTimeReadiness {
  long priority_limit = 0;  ///< rtprio; 0 none, -1 no limit
  long locked_bytes = 0;    ///< memlock; -1 no limit
  std::string kernel;       ///< "6.1.0-28-amd64 #1 SMP PREEMPT_DYNAMIC ..."
  bool kernel_preempts = false;
  std::vector<std::string> advice;  ///< one sentence for each thing to change; empty: ready
};

/// Of this process.
[[nodiscard]] RealTimeReadiness real_time_readiness();
/// Of such a machine. @param kernel_version  what uname -v says. @param capabilities  of the process, as
/// bits: CAP_SYS_NICE and CAP_IPC_LOCK, which root has, lift the limits.
[[nodiscard]] RealTimeReadiness real_time_readiness(long priority_limit, long locked_bytes,
                                                    std::string_view kernel_release,
                                                    std::string_view kernel_version,
                                                    std::uint64_t capabilities = 0);
/// The effective capabilities in the text of /proc/self/status; 0 where it tells none.
[[nodiscard]] std::uint64_t effective_capabilities(std::string_view proc_status);

}  // namespace nazori::devices
