// SPDX-License-Identifier: Apache-2.0
// What guidance wants the tip to feel.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "guidance.h"

namespace nazori::haptics {
namespace {

constexpr double kWall = 0.75;      // part of the cap that resists going back
constexpr double kDownwards = 0.4;  // part of the cap that presses into the groove
constexpr double kOver = 0.25;  // part of the reach of a start: within it the tip is pulled all the way down
constexpr double kClear_m =
    0.003;  // above the plateau: from this height on it is carried across with full force
constexpr double kAhead_m = 0.001;  // the pull aims this far ahead; otherwise it would stick at corners
constexpr double kOverrun_m =
    0.003;  // the target goes beyond the end; otherwise friction would stop the tip before it
constexpr double kLeastWait_m = 0.003, kMostWait_m = 0.008;  // lag at which the target waits

// Resisting: hardly moving under a pull, or moving against it.
constexpr double kLoad = 0.8, kStill_m_s = 0.005;
constexpr double kBackLoad = 0.25, kBack_m_s = 0.02, kBackPatience_s = 0.03;
constexpr double kLeadPatience_s = 0.15, kCarryPatience_s = 0.4;
constexpr double kComeAlong_m = 0.002;
constexpr double kHoldRise_s = 0.1, kLeadRise_s = 0.3, kCarryRise_s = 0.5;

double smooth(double t) noexcept {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Vec3 within(const Vec3& v, double most) noexcept {
  const double size = glm::length(v);
  return size > most ? v * (most / size) : v;
}

}  // namespace

/// Unit direction in which the line continues, including the rise of its groove; zero for a dot.
Vec3 Guidance::ahead(const GuidancePlan& plan) const noexcept {
  const StrokeIndex::Hit next = plan.lines().at_length(stroke_, arc_ + kAhead_m);
  Vec3 way = next.point - hit_.point;
  const double across = glm::length(way);
  if (across < 0.1 * kAhead_m) return plan.lines().direction(hit_.segment);
  // Beyond 45 degrees the tip would be lifted rather than led.
  way.z = std::clamp(plan.depth_m(next) - plan.depth_m(hit_), -across, across);
  return glm::normalize(way);
}

/// Stops the force when the learner resists, until the remaining distance has become shorter again. Then the
/// force rises gradually.
Vec3 Guidance::yield(const Vec3& wanted, const Vec3& velocity_m_s, double most_n, double patience_s,
                     double rise_s, double period_s) noexcept {
  if (!(most_n > 0)) return Vec3(0);
  if (stopped_) {
    stopped_at_ = std::max(stopped_at_, to_go_);
    if (to_go_ > stopped_at_ - kComeAlong_m) return Vec3(0);
    stopped_ = false;
    new_way_ = true;
    gain_ = 0;
    mark(ServoEvent::resumed);
  }
  gain_ = std::min(1.0, gain_ + period_s / rise_s);
  const Vec3 given = gain_ * wanted;
  const double size = glm::length(given);
  const double along = glm::dot(velocity_m_s, given);  // speed along the pull, times its size
  resisted_s_ = size > kLoad * most_n && along < kStill_m_s * size ? resisted_s_ + period_s : 0;
  pulled_back_s_ = size > kBackLoad * most_n && along < -kBack_m_s * size ? pulled_back_s_ + period_s : 0;
  if (resisted_s_ <= patience_s && pulled_back_s_ <= kBackPatience_s) return given;
  stop();
  return Vec3(0);
}

Vec3 Guidance::write(const GuidancePlan& plan, const Settings& settings, const Input& in) noexcept {
  const double stiffness = settings.stiffness_n_m * settings.strength;
  const double cap = settings.cap_n * settings.strength;
  guide_ = {hit_.point.x, hit_.point.y, plan.depth_m(hit_)};
  Vec3 wanted = stiffness * (guide_ - in.device_m);
  // A writing tip is pulled down only: where a shallow stroke runs over a deeper groove, the force must not
  // lift the tip off the surface. A led tip is also taken up a hook.
  wanted.z =
      std::clamp(wanted.z, -kDownwards * cap, settings.mode == GuidingMode::lead ? kDownwards * cap : 0);
  if (new_way_) {
    new_way_ = false;
    allowance_ = cap * kLeave_m;
  }
  if (settings.mode == GuidingMode::lead) {
    wanted += lead(plan, settings, in);
    return yield(wanted, in.velocity_m_s, std::min(cap, stiffness * kMostWait_m), kLeadPatience_s,
                 kLeadRise_s, in.period_s);
  }
  const double back = wall_ - kSlack_m - arc_;
  if (back > 0) {
    wanted += std::min(stiffness * back, kWall * cap) * ahead(plan);
  }
  gain_ = std::min(1.0, gain_ + in.period_s / kHoldRise_s);
  return gain_ * wanted;
}

/// The pull along the line, towards a target that goes at the teacher's speed and waits for the tip.
Vec3 Guidance::lead(const GuidancePlan& plan, const Settings& settings, const Input& in) noexcept {
  const double stiffness = settings.stiffness_n_m * settings.strength;
  const double cap = settings.cap_n * settings.strength;
  const double length = plan.length_m(stroke_);
  to_go_ = length - arc_;
  target_ = std::max(target_, arc_);
  if (!(stiffness > 0)) return Vec3(0);
  const double wait = std::clamp(cap / stiffness, kLeastWait_m, kMostWait_m);
  if (!stopped_) {
    const double go = std::clamp(4 * (1 - (target_ - arc_) / wait), 0.0, 1.0);
    const double step = std::min(go * plan.speed_m_s(stroke_, target_) * in.period_s,
                                 std::max(0.0, length + kOverrun_m - target_));
    target_ += step;
    allowance_ += cap * step;
  }
  const StrokeIndex::Hit at = plan.lines().at_length(stroke_, target_);
  guide_ = {at.point.x, at.point.y, plan.depth_m(at)};
  return std::min(stiffness * (target_ - arc_), cap) * ahead(plan);
}

/// Up, across, down. In a wrong place: a soft wall fills the groove until the tip is lifted.
Vec3 Guidance::carry(const GuidancePlan& plan, const Settings& settings, const Input& in) noexcept {
  const double stiffness = settings.stiffness_n_m * settings.strength;
  const double cap = settings.cap_n * settings.strength;
  const Vec3& p = in.device_m;
  const StrokeIndex::Hit entry = plan.lines().at_length(stroke_, reached_);
  const Vec3 across{entry.point.x - p.x, entry.point.y - p.y, 0};
  // Moves down only within reach of the start, so that the tip does not land beside it.
  const double near = start_reach_m(plan.length_m(stroke_));
  const double over = must_lift_ ? 0.0 : smooth((near - glm::length(across)) / ((1 - kOver) * near));
  const double bottom = plan.depth_m(entry);
  guide_ = {entry.point.x, entry.point.y, kHover_m + over * (bottom - kHover_m)};
  const double most = kCarry * cap;
  to_go_ = glm::length(guide_ - p);
  if (new_way_) {
    new_way_ = false;
    allowance_ = most * (glm::length(across) + std::abs(kHover_m - p.z) + kHover_m - bottom);
  }
  if (astray_) return {0, 0, std::min(stiffness * std::max(0.0, -p.z), cap)};
  const double freed = std::max(over, smooth(p.z / kClear_m));
  const Vec3 wanted = within(stiffness * (freed * across + Vec3(0, 0, guide_.z - p.z)), most) -
                      settings.damping_n_s_m * settings.strength * in.velocity_m_s;
  return yield(wanted, in.velocity_m_s, most, kCarryPatience_s, kCarryRise_s, in.period_s);
}

}  // namespace nazori::haptics
