// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/aim.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace nazori::brush {

Aim::Aim(const TuftForm& form) : step_m_(Tuft::kMostDepth * form.hair_m / kSteps) {
  constexpr int kBristles = 40;
  constexpr int kMoves = 12;
  Tuft tuft(form, kBristles);
  std::vector<geometry::BristleSegment> swept;
  HolderPose pose;
  for (std::size_t i = 1; i <= kSteps; ++i) {
    pose.depth_m = static_cast<double>(i) * step_m_;
    // Drawn over its own length it has settled.
    for (int move = 0; move < kMoves; ++move) {
      pose.time_s += 0.01;
      pose.at.x += form.hair_m / kMoves;
      swept.clear();
      tuft.move_to(pose, swept);
    }
    reach_m_[i] = std::max(reach_m_[i - 1], tuft.reach_m());
  }
}

double Aim::usual_reach_m(double depth_m) const {
  const double at = std::clamp(depth_m / step_m_, 0.0, static_cast<double>(kSteps));
  const auto below = std::min(static_cast<std::size_t>(at), kSteps - 1);
  return reach_m_[below] + (at - static_cast<double>(below)) * (reach_m_[below + 1] - reach_m_[below]);
}

void Aim::lead(HolderPose& pose, const Tuft& tuft) {
  if (pose.depth_m > 0)
    pose.at = foot(pose.at, pose.depth_m, tuft);
  else
    before_.reset();
}

geometry::PaperPoint Aim::foot(geometry::PaperPoint pen, double depth_m, const Tuft& tuft) {
  if (!tuft.touching()) {
    ahead_rad_ = tuft.points_to_rad() + std::numbers::pi;
    depth_m_ = 0;
  }
  if (before_) {
    // The foot swings around the ink; over this way a hand's direction counts.
    constexpr double kWay_m = 0.002;
    constexpr double kMends = 0.5;  // of what the ink missed the pen by
    const geometry::PaperPoint moved = pen - *before_;
    const geometry::PaperPoint missed = tuft.touching() ? *before_ - tuft.patch_at() : geometry::PaperPoint{};
    const geometry::PaperPoint to = moved + missed * kMends;
    const double turn = std::remainder(std::atan2(to.y, to.x) - ahead_rad_, 2 * std::numbers::pi);
    ahead_rad_ += (1 - std::exp(-geometry::length(moved) / kWay_m)) * turn;
  }
  before_ = pen;
  // The hair bends further, or less, as the depth changes.
  const double lead_m = std::max(
      0.0, (tuft.touching() ? tuft.reach_m() : 0.0) + usual_reach_m(depth_m) - usual_reach_m(depth_m_));
  depth_m_ = depth_m;
  return {pen.x + lead_m * std::cos(ahead_rad_), pen.y + lead_m * std::sin(ahead_rad_)};
}

}  // namespace nazori::brush
