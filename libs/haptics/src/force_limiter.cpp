// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/force_limiter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nazori::haptics {

Vec3 ForceLimiter::limit(const Vec3& wanted_n, double period_s) noexcept {
  const double squared = glm::dot(wanted_n, wanted_n);
  if (!(squared < 1e12)) {  // NaN, infinite or absurd
    drop();
    return last_;
  }
  const double full = limits_.continuous_force_n * limits_.continuous_force_n;
  double most = limits_.max_force_n;
  if (most > limits_.continuous_force_n && full > 0) {
    const double spare = std::clamp((full - mean_square_) / (0.2 * full), 0.0, 1.0);
    most = limits_.continuous_force_n + spare * (most - limits_.continuous_force_n);
  }
  ramp_ = std::min(1.0, ramp_ + period_s / kRamp_s);
  Vec3 force = ramp_ * wanted_n;
  const double size = glm::length(force);
  if (size > most) force *= most / size;

  const Vec3 change = force - last_;
  const double step = glm::length(change);
  const double most_step = limits_.max_slew_n_s * period_s;
  if (step > most_step) force = last_ + change * (most_step / step);

  last_ = force;
  mean_square_ += (glm::dot(force, force) - mean_square_) * std::min(1.0, period_s / kThermal_s);
  return force;
}

void ForceLimiter::drop() noexcept {
  last_ = Vec3(0);
  ramp_ = 0;
}

double ForceLimiter::heat() const noexcept {
  const double full = limits_.continuous_force_n * limits_.continuous_force_n;
  return full > 0 ? mean_square_ / full : 0;
}

Passivity::Passivity(const DeviceLimits& limits, double period_s)
    : own_damping_(limits.own_damping_n_s_m),
      most_damping_(limits.max_damping_n_s_m),
      delay_(limits.delay_s > 0 ? static_cast<std::size_t>(std::min(limits.delay_s / period_s + 0.5,
                                                                    static_cast<double>(kMostDelay)))
                                : 0) {}

void Passivity::forget() noexcept {
  energy_ = 0;
  commanded_.fill(Vec3(0));
}

void Passivity::observe(const Vec3& moved_m, const Vec3& commanded_n, double period_s,
                        double stored_j) noexcept {
  newest_ = (newest_ + 1) % commanded_.size();
  commanded_[newest_] = commanded_n;
  const Vec3& acted_n = commanded_[(newest_ + commanded_.size() - delay_) % commanded_.size()];
  energy_ -= glm::dot(acted_n, moved_m);
  energy_ += own_damping_ * glm::dot(moved_m, moved_m) / period_s;
  energy_ = std::clamp(energy_, -kMostDebt_j, stored_j);
}

Vec3 Passivity::correction(const Vec3& moved_m, double period_s) const noexcept {
  if (energy_ >= 0) return Vec3(0);
  const Vec3 velocity = moved_m / period_s;
  const double squared = glm::dot(velocity, velocity);
  if (squared < 1e-10) return Vec3(0);
  return -std::min(most_damping_, -energy_ / (squared * period_s)) * velocity;
}

double passive_stiffness_n_m(double damping_n_s_m, double wall_damping_n_s_m, double period_s,
                             double delay_s) noexcept {
  return std::max(0.0, (damping_n_s_m - std::abs(wall_damping_n_s_m)) / (period_s / 2 + delay_s));
}

}  // namespace nazori::haptics
