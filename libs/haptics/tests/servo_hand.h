// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/haptics/servo.h"

namespace nazori::haptics::test {

/// A servo and its clock: each call is one tick later.
class Hand {
 public:
  explicit Hand(const DeviceDescription& device = {}) : servo(device), period_s_(1 / device.rate_hz) {}
  Vec3 at(const Vec3& p, bool present = true) {
    time_s += period_s_;
    return servo.tick({time_s, p, 0, present});
  }
  Vec3 rest(const Vec3& p, int ticks) {
    Vec3 force(0);
    for (int i = 0; i < ticks; ++i) force = at(p);
    return force;
  }
  Vec3 go(const Vec3& from, const Vec3& to, int ticks) {
    Vec3 force(0);
    for (int i = 1; i <= ticks; ++i) force = at(from + (to - from) * (static_cast<double>(i) / ticks));
    return force;
  }
  [[nodiscard]] bool saw(ServoEvent e) { return (servo.latest().events & static_cast<unsigned>(e)) != 0; }

  Servo servo;
  double time_s = 0;

 private:
  double period_s_;
};

inline constexpr Vec3 kAbove{0, 0, 0.005};

}  // namespace nazori::haptics::test
