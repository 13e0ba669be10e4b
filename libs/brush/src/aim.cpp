// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/aim.h"

#include <algorithm>
#include <cmath>

namespace nazori::brush {
namespace {

/// From the foot to the middle of the sections that touch [m].
double reach_m(const Tuft& tuft) {
  const auto sections = tuft.sections();
  const geometry::PaperPoint tip = sections.back().at, root = sections.front().at;
  return std::max(geometry::distance(root, tip) - tuft.patch_m() / 2, 0.0);
}

}  // namespace

geometry::PaperPoint Aim::foot(geometry::PaperPoint pen, const Tuft& tuft) {
  if (before_) {
    // Over this way a hand's direction counts.
    constexpr double kWay_m = 0.002;
    const double x = pen.x - before_->x, y = pen.y - before_->y;
    const double rest = std::exp(-std::hypot(x, y) / kWay_m);
    const double way = std::max(std::hypot(x, y), 1e-12);
    ahead_.x = rest * ahead_.x + (1 - rest) * x / way;
    ahead_.y = rest * ahead_.y + (1 - rest) * y / way;
  }
  before_ = pen;
  // At touch-down the tuft will bend as far as in the stroke before.
  constexpr double kFirstReach = 0.2;
  if (tuft.touching()) {
    lead_m_ = reach_m(tuft);
  } else if (lead_m_ <= 0) {
    lead_m_ = kFirstReach * tuft.form().hair_m;
  }
  const double length = std::max(std::hypot(ahead_.x, ahead_.y), 1e-3);
  return {pen.x + lead_m_ * ahead_.x / length, pen.y + lead_m_ * ahead_.y / length};
}

void Aim::lift(double points_to_rad) {
  before_.reset();
  ahead_ = {-std::cos(points_to_rad), -std::sin(points_to_rad)};
}

}  // namespace nazori::brush
