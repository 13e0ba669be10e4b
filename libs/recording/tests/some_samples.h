// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include "nazori/haptics/servo.h"

namespace nazori::recording::test {

/// Samples with every member set, the same each time.
inline std::vector<haptics::ServoSample> some_samples(std::size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.1, 0.1);
  std::vector<haptics::ServoSample> samples(count);
  for (std::size_t i = 0; i < count; ++i) {
    haptics::ServoSample& s = samples[i];
    s.tick = i;
    s.time_s = 0.001 * static_cast<double>(i);
    for (int axis = 0; axis < 3; ++axis) {
      s.device_m[axis] = place(random);
      s.proxy_m[axis] = place(random);
      s.force_n[axis] = place(random);
      s.guide_m[axis] = place(random);
    }
    s.touching = i % 2 == 1;
    s.stroke = static_cast<std::int32_t>(i % 5);
    s.progress_m = place(random);
    s.off_m = place(random);
    s.guided_stroke = static_cast<std::int32_t>(i % 7);
    s.done_stroke = static_cast<std::int32_t>(i % 3);
    s.buttons = static_cast<std::uint32_t>(random());
    s.events = static_cast<std::uint16_t>(i % 2048);
  }
  return samples;
}

inline bool same(const haptics::ServoSample& a, const haptics::ServoSample& b) {
  return a.tick == b.tick && a.time_s == b.time_s && a.device_m == b.device_m && a.proxy_m == b.proxy_m &&
         a.force_n == b.force_n && a.guide_m == b.guide_m && a.progress_m == b.progress_m &&
         a.off_m == b.off_m && a.guided_stroke == b.guided_stroke && a.done_stroke == b.done_stroke &&
         a.touching == b.touching && a.stroke == b.stroke && a.buttons == b.buttons && a.events == b.events;
}

}  // namespace nazori::recording::test
