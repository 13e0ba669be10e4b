// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/stroke_constraint.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nazori::haptics {

void StrokeConstraint::let_go() noexcept {
  if (stroke_ != 0) ceiling_ = glm::length(force_);
  stroke_ = 0;
  segment_ = -1;
}

void StrokeConstraint::forget() noexcept {
  stroke_ = 0;
  segment_ = -1;
  weight_ = ceiling_ = 0;
  force_ = Vec3(0);
}

void StrokeConstraint::update(const StrokeIndex& index, const Settings& settings, const Vec3& device_m,
                              double period_s) noexcept {
  if (index.empty()) {
    let_go();
  } else if (stroke_ != 0) {
    hit_ = index.follow(device_m, segment_);
    const double release = std::max(settings.release_distance_m, settings.snap_distance_m);
    if (hit_.squared_m2 > release * release) {
      let_go();
    } else {
      segment_ = hit_.segment;
      anchor_ = hit_.point;
    }
  }
  if (stroke_ == 0) {
    const StrokeIndex::Hit hit = index.nearest(device_m, settings.snap_distance_m);
    // While one pull fades out, no other may begin: the two would add up to a step.
    if (hit.segment >= 0 && (weight_ == 0 || glm::length(hit.point - anchor_) < 1e-3)) {
      hit_ = hit;
      segment_ = hit.segment;
      stroke_ = index.stroke(hit.segment);
      anchor_ = hit.point;
    }
  }

  const Vec3 spring = settings.stiffness_n_m * (anchor_ - device_m);
  const double pull = glm::length(spring);
  const double step = std::min(period_s / kBlend_s, pull > 0 ? kMostStep_n / pull : 1.0);
  if (stroke_ != 0) {
    weight_ = std::min(1.0, weight_ + step);
    force_ = weight_ * spring;
  } else if (weight_ > 0) {
    weight_ = std::max(0.0, weight_ - step);
    const double most = weight_ * ceiling_;
    force_ = pull > 0 ? spring * std::min(weight_, most / pull) : Vec3(0);
  }
}

}  // namespace nazori::haptics
