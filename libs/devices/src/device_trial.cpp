// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/device_trial.h"

#include <linux/capability.h>
#include <sys/resource.h>
#include <sys/utsname.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>

namespace nazori::devices {

using haptics::Vec3;

Vec3 DeviceTrial::tick(const haptics::DeviceSample& sample) noexcept {
  if (found_.ticks++ == 0) {
    first_s_ = sample.time_s;
  } else {
    const double late = sample.time_s - last_s_ - period_s_;
    std::size_t bin = 0;
    while (bin < TrialResult::kEdges_s.size() && late > TrialResult::kEdges_s[bin]) ++bin;
    ++found_.lateness[bin];
    found_.max_lateness_s = std::max(found_.max_lateness_s, late);
  }
  last_s_ = sample.time_s;
  found_.buttons_seen |= sample.buttons;
  if (!sample.present) {
    ++found_.absent;
    in_window_ = 0;
    return Vec3(0);
  }
  if (in_window_ == 0) {
    origin_ = sample.position_m;  // keeps sums exact, because the numbers are small
    sum_ = Vec3(0);
    sum_squares_ = 0;
  }
  const Vec3 from = sample.position_m - origin_;
  sum_ += from;
  sum_squares_ += glm::dot(from, from);
  if (++in_window_ == kRestTicks) {
    const Vec3 mean = sum_ / static_cast<double>(kRestTicks);
    const double noise = std::sqrt(std::max(0.0, sum_squares_ / kRestTicks - glm::dot(mean, mean)));
    found_.rest_noise_m = found_.rest_noise_m < 0 ? noise : std::min(found_.rest_noise_m, noise);
    in_window_ = 0;
  }
  return Vec3(0);
}

TrialResult DeviceTrial::result() const {
  TrialResult result = found_;
  result.seconds = found_.ticks > 0 ? last_s_ - first_s_ : 0;
  if (result.seconds > 0) result.rate_hz = static_cast<double>(found_.ticks - 1) / result.seconds;
  return result;
}

RealTimeReadiness real_time_readiness() {
  const auto limit = [](auto which) {
    rlimit l{};
    if (getrlimit(which, &l) != 0) return 0L;
    return l.rlim_cur == RLIM_INFINITY ? -1L : static_cast<long>(l.rlim_cur);
  };
  utsname name{};
  (void)uname(&name);
  std::ifstream in("/proc/self/status");
  const std::string about_process{std::istreambuf_iterator<char>(in), {}};
  return real_time_readiness(limit(RLIMIT_RTPRIO), limit(RLIMIT_MEMLOCK), name.release, name.version,
                             effective_capabilities(about_process));
}

std::uint64_t effective_capabilities(std::string_view proc_status) {
  constexpr std::string_view kName = "CapEff:";
  const std::size_t at = proc_status.find(kName);
  if (at == std::string_view::npos) return 0;
  std::string_view rest = proc_status.substr(at + kName.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  std::uint64_t bits = 0;
  (void)std::from_chars(rest.data(), rest.data() + rest.size(), bits, 16);
  return bits;
}

RealTimeReadiness real_time_readiness(long priority_limit, long locked_bytes, std::string_view kernel_release,
                                      std::string_view kernel_version, std::uint64_t capabilities) {
  constexpr long kPriority = 40;  // of RtThread
  constexpr long kLocked = 64L << 20;
  const auto has = [&](unsigned capability) { return (capabilities >> capability & 1U) != 0; };
  RealTimeReadiness r;
  if (has(CAP_SYS_NICE)) priority_limit = -1;
  if (has(CAP_IPC_LOCK)) locked_bytes = -1;
  r.priority_limit = priority_limit;
  r.locked_bytes = locked_bytes;
  r.kernel = std::string(kernel_release) + " " + std::string(kernel_version);
  r.kernel_preempts = kernel_version.find("PREEMPT") != std::string_view::npos;
  if (priority_limit >= 0 && priority_limit < kPriority)
    r.advice.emplace_back("real-time priority is limited to " + std::to_string(priority_limit) +
                          ": put '@audio - rtprio 95' into /etc/security/limits.d/nazori.conf, run sudo "
                          "usermod -aG audio $USER, log out and in");
  if (locked_bytes >= 0 && locked_bytes < kLocked)
    r.advice.emplace_back("locked memory is limited to " + std::to_string(locked_bytes / 1024) +
                          " KiB: put '@audio - memlock unlimited' into /etc/security/limits.d/nazori.conf");
  if (!r.kernel_preempts)
    r.advice.emplace_back(
        "the kernel is not preemptible: use a preemptible one (Debian linux-image-rt-amd64, Ubuntu "
        "linux-lowlatency)");
  return r;
}

}  // namespace nazori::devices
