// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace nazori::devices {

/// Times counted in steps of 2 %, so that the largest thousandth can be computed without storing all.
/// Real-time-safe: yes.
class TickDurations {
 public:
  void add(double seconds) noexcept {
    const double octaves = std::log2(std::max(seconds, kShortest_s) / kShortest_s);
    const auto bin = static_cast<std::size_t>(octaves * kPerOctave);
    ++counts_[std::min(bin, counts_.size() - 1)];
    ++all_;
  }
  /// The time that `share` of the times do not exceed; 0 where there are none.
  [[nodiscard]] double quantile_s(double share) const noexcept {
    std::uint64_t seen = 0;
    for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
      seen += counts_[bin];
      if (all_ > 0 && static_cast<double>(seen) >= share * static_cast<double>(all_))
        return kShortest_s * std::exp2(static_cast<double>(bin + 1) / kPerOctave);
    }
    return 0;
  }

 private:
  static constexpr double kShortest_s = 1e-9;
  static constexpr int kPerOctave = 32;
  std::array<std::uint64_t, std::size_t{32} * kPerOctave> counts_{};  // up to 4 s
  std::uint64_t all_ = 0;
};

}  // namespace nazori::devices
