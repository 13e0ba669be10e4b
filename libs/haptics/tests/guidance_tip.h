// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "../src/guidance.h"

namespace nazori::haptics::test {

inline constexpr double kTick_s = 0.001;
inline constexpr double kDepth_m = 0.01;
inline constexpr double kLength_m = 0.06;

/// A level stroke of 6 cm along x, and a second one 3 cm above its end.
inline GuidancePlan two_strokes() {
  std::vector<StrokePath> strokes(2);
  for (int i = 0; i <= 60; ++i) {
    strokes[0].points.emplace_back(0.001 * i, 0, -kDepth_m);
    strokes[1].points.emplace_back(0.001 * i, 0.03, -kDepth_m);
  }
  return {strokes, 0.05};
}

/// One level stroke along x.
inline GuidancePlan line_of(double length_m) {
  std::vector<StrokePath> strokes(1);
  for (int i = 0; i <= 60; ++i) strokes[0].points.emplace_back(length_m * i / 60, 0, -kDepth_m);
  return {strokes, 0.05};
}

/// Guidance with a tip that the test positions.
class Tip {
 public:
  explicit Tip(GuidingMode mode, GuidancePlan of = two_strokes()) : plan(std::move(of)) {
    settings.mode = mode;
    settings.strength = 1;
    settings.cap_n = 2;
    settings.stiffness_n_m = 100;
    settings.damping_n_s_m = 0;
    guidance.begin(plan, 1, Disturbance());
  }
  void at(const Vec3& p, const Vec3& velocity_m_s = Vec3(0), bool touching = true) {
    guidance.update(plan, settings, {p, velocity_m_s, touching, kTick_s, Guidance::kMostStep_n});
    granted_j += guidance.granted_j();
  }
  [[nodiscard]] bool saw(ServoEvent event) const {
    return (guidance.events() & static_cast<std::uint16_t>(event)) != 0;
  }
  /// Moves the tip down onto the line at `x`, and along it.
  void write(double from_x, double to_x) {
    at({from_x, 0, 0.005}, Vec3(0), false);
    for (double x = from_x; x < to_x; x += 5e-5) at({x, 0, -kDepth_m}, {0.05, 0, 0});
    at({to_x, 0, -kDepth_m}, {0.05, 0, 0});
  }

  GuidancePlan plan;
  Guidance::Settings settings;
  Guidance guidance;
  double granted_j = 0;
};

}  // namespace nazori::haptics::test
