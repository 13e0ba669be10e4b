// SPDX-License-Identifier: Apache-2.0
#include "stroke_measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "nazori/geometry/polyline.h"

namespace nazori::devices {
namespace {

using geometry::TabletFrame;

// A tip further from the line than this does not follow it.
constexpr double kFollows_m = 0.003;

}  // namespace

double StrokeMeasures::off_m(geometry::TabletPoint from_above) const noexcept {
  return geometry::nearest_point<TabletFrame>(line_, from_above).distance;
}

void StrokeMeasures::add(int stroke, geometry::TabletPoint aimed, int slips,
                         const haptics::ServoSample& sample, const haptics::Vec3& force_n) noexcept {
  const double aim_m = off_m(aimed);
  // Anywhere on the line: the distance does not depend on the path of the tip.
  const auto tip =
      geometry::nearest_point<TabletFrame>(line_, geometry::TabletPoint{sample.proxy_m.x, sample.proxy_m.y});
  ++ticks_;
  touching_ += sample.touching ? 1 : 0;
  snapped_ += sample.stroke == stroke ? 1 : 0;
  slips_ += slips;
  aim_squared_ += aim_m * aim_m;
  aim_max_ = std::max(aim_max_, aim_m);
  if (sample.touching) {
    tip_squared_ += tip.distance * tip.distance;
    tip_max_ = std::max(tip_max_, tip.distance);
    depth_ -= sample.proxy_m.z;
  }
  const double strength = glm::length(force_n);
  force_ += strength;
  force_max_ = std::max(force_max_, strength);
  if (sample.touching && tip.distance < kFollows_m) followed_m_ = std::max(followed_m_, tip.arc_length);
}

void StrokeMeasures::report_to(FollowedStroke& followed) const {
  if (ticks_ == 0) return;
  const auto ticks = static_cast<double>(ticks_);
  const double touching = std::max(1.0, static_cast<double>(touching_));
  followed.aim_rms_m = std::sqrt(aim_squared_ / ticks);
  followed.aim_max_m = aim_max_;
  followed.tip_rms_m = std::sqrt(tip_squared_ / touching);
  followed.tip_max_m = tip_max_;
  followed.mean_force_n = force_ / ticks;
  followed.peak_force_n = force_max_;
  followed.contact_share = static_cast<double>(touching_) / ticks;
  followed.snapped_share = static_cast<double>(snapped_) / ticks;
  followed.slips = slips_;
  followed.mean_depth_m = depth_ / touching;
  followed.followed_share =
      followed.length_m > 0 ? std::min(1.0, followed_m_ / followed.length_m) : (touching_ > 0 ? 1.0 : 0.0);
}

}  // namespace nazori::devices
