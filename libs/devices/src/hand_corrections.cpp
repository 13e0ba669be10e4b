// SPDX-License-Identifier: Apache-2.0
#include "hand_corrections.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace nazori::devices {
namespace {

using haptics::Vec3;

// Of the sight.
constexpr double kAstray_m = 0.0035;  // beyond the edge of the groove
constexpr double kBack_m = 0.0015;
constexpr double kReaction_s = 0.2;
constexpr double kHeight_m = 0.022;  // from below the deepest groove to above the plateau
constexpr double kLiftSpeed_m_s = 0.15;

// Of the pull.
constexpr double kPerSecond = 6;
constexpr double kMostAhead_m = 0.006;
constexpr double kMostAside_m = 0.003;

}  // namespace

double HandSight::lift_m(double off_m, double to_target_m, bool following, double elapsed_s) noexcept {
  astray_s_ = following && off_m > kAstray_m ? astray_s_ + elapsed_s : 0;
  if (!lifting_ && astray_s_ > kReaction_s) {
    lifting_ = true;
    ++slips_;
  }
  if (lifting_ && (to_target_m < kBack_m || !following)) lifting_ = false;
  const double step = kLiftSpeed_m_s * elapsed_s;
  lift_ += std::clamp((lifting_ ? kHeight_m : 0.0) - lift_, -step, step);
  return lift_;
}

Vec3 HandPull::lead_m(const Vec3& wrong_m, const Vec3& along, int movement, double elapsed_s) noexcept {
  if (movement != movement_) ahead_ = aside_ = 0;
  movement_ = movement;
  const Vec3 across{-along.y, along.x, 0};
  const double step = kPerSecond * elapsed_s;
  ahead_ = std::clamp(ahead_ + step * glm::dot(wrong_m, along), 0.0, kMostAhead_m);
  aside_ = std::clamp(aside_ + step * glm::dot(wrong_m, across), -kMostAside_m, kMostAside_m);
  return ahead_ * along + aside_ * across;
}

}  // namespace nazori::devices
