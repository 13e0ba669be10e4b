// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/soft_contact.h"

#include <algorithm>
#include <cmath>

namespace nazori::haptics {
namespace {

constexpr double kTurns_per_m = 1000;  // the cone follows the direction of the way over a millimetre

}  // namespace

double SoftTipTable::push_n(double depth_m) const noexcept {
  if (!(depth_m > 0) || push_.empty()) return 0;
  const double at = depth_m * per_m_;
  const std::size_t last = push_.size() - 1;
  if (!(at < static_cast<double>(last))) return push_[last];
  const auto i = static_cast<std::size_t>(at);
  const double t = at - static_cast<double>(i);
  return push_[i] + t * (push_[i + 1] - push_[i]);
}

double SoftTipTable::stored_j(double depth_m) const noexcept {
  if (!(depth_m > 0) || push_.empty()) return 0;
  const double at = depth_m * per_m_;
  const std::size_t last = push_.size() - 1;
  if (!(at < static_cast<double>(last)))
    return stored_[last] + push_[last] * (depth_m - step_ * static_cast<double>(last));
  const auto i = static_cast<std::size_t>(at);
  const double t = at - static_cast<double>(i);
  return stored_[i] + step_ * t * (push_[i] + 0.5 * t * (push_[i + 1] - push_[i]));
}

void SoftContact::forget() noexcept {
  force_ = Vec3(0);
  stored_ = 0;
  pull_x_ = pull_y_ = 0;
  cone_ = 1;
  touching_ = false;
}

void SoftContact::update(const SoftTipTable& tip, const Vec3& device_m) noexcept {
  if (!tip.exists() || device_m.z >= 0) {
    forget();
    return;
  }
  if (!touching_) {
    touching_ = true;
    x_ = device_m.x;
    y_ = device_m.y;
    tow_x_ = tow_y_ = 0;
  }
  const double dx = device_m.x - x_, dy = device_m.y - y_;
  x_ = device_m.x;
  y_ = device_m.y;
  const double moved2 = dx * dx + dy * dy;
  if (moved2 > 0) {
    const double moved = std::sqrt(moved2);
    const double towed = std::sqrt(tow_x_ * tow_x_ + tow_y_ * tow_y_);
    const double trails = -(dx * tow_x_ + dy * tow_y_);
    const double along = trails > 0 ? std::min(1.0, trails / (moved * towed)) : 0.0;
    const double narrow = 1 - tip.along_hair() * along * along;
    cone_ += (narrow - cone_) * std::min(1.0, moved * kTurns_per_m);
    tow_x_ -= dx;
    tow_y_ -= dy;
    const double length2 = tow_x_ * tow_x_ + tow_y_ * tow_y_;
    if (length2 > tip.tow_m() * tip.tow_m()) {
      const double part = tip.tow_m() / std::sqrt(length2);
      tow_x_ *= part;
      tow_y_ *= part;
    }
  }
  const double depth = -device_m.z;
  const double push = tip.push_n(depth);
  const double longest = tip.friction() * cone_ * push / tip.sideways_n_m();
  pull_x_ += dx;
  pull_y_ += dy;
  double pull2 = pull_x_ * pull_x_ + pull_y_ * pull_y_;
  if (pull2 > longest * longest) {
    const double part = longest / std::sqrt(pull2);
    pull_x_ *= part;
    pull_y_ *= part;
    pull2 = longest * longest;
  }
  force_ = {-tip.sideways_n_m() * pull_x_, -tip.sideways_n_m() * pull_y_, push};
  stored_ = tip.stored_j(depth) + 0.5 * tip.sideways_n_m() * pull2;
}

}  // namespace nazori::haptics
