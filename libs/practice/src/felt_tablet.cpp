// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/felt_tablet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nazori/surface/ball_surface.h"

namespace nazori::practice {

void FeltTablet::set_tablet(Tablet tablet) {
  if (preparing_) preparing_->cancel();
  tablet_ = std::move(tablet);
  felt_ = tablet_;
  prepare();
}

void FeltTablet::set_radius(double radius_m) {
  const double within = std::isfinite(radius_m) ? std::clamp(radius_m, 0.0, surface::kLargestBall_m) : 0;
  if (within == radius_m_) return;
  radius_m_ = within;
  prepare();
  if (radius_m_ > 0 || felt_ == tablet_) return;
  felt_ = tablet_;
  changed();
}

void FeltTablet::prepare() {
  if (radius_m_ == 0 || !tablet_) {
    if (preparing_) preparing_->cancel();
    return;
  }
  if (!preparing_)
    preparing_.emplace(
        "ball", inbox_,
        [](const Request& request, const auto&) {
          auto made = request.tablet->with_tip(request.radius_m);
          // A ball that is too large for a small tablet: that is felt with a point.
          return made ? std::move(*made) : request.tablet;
        },
        [this](const Tablet& made) {
          felt_ = made;
          changed();
        });
  preparing_->request({tablet_, radius_m_});
}

}  // namespace nazori::practice
