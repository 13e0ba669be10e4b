// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/slope_gain.h"

#include <algorithm>
#include <cmath>

namespace nazori::devices {
namespace {

constexpr double kStep_m = 0.0003;  // finer than a groove's wall
constexpr int kMostSteps = 512;

}  // namespace

double SlopeGain::gain(double slope) {
  const double divisor = 1 + slope;
  return divisor <= 1 / kMost ? kMost : std::clamp(1 / divisor, kLeast, kMost);
}

geometry::TabletPoint SlopeGain::follow(geometry::TabletPoint pointer,
                                        const haptics::TabletSurface& surface) {
  if (!pointer_ || !surface.exists()) {
    pointer_ = stylus_ = pointer;
    return stylus_;
  }
  const double x = pointer.x - pointer_->x;
  const double y = pointer.y - pointer_->y;
  const double way_m = std::hypot(x, y);
  pointer_ = pointer;
  if (!(way_m > 0)) return stylus_;
  const int steps = std::clamp(static_cast<int>(std::ceil(way_m / kStep_m)), 1, kMostSteps);
  for (int i = 0; i < steps; ++i) {
    const auto place = surface.at(stylus_.x, stylus_.y);
    const double g = gain((place.zx * x + place.zy * y) / way_m) / steps;
    stylus_.x += g * x;
    stylus_.y += g * y;
  }
  const double off_x = stylus_.x - pointer.x;
  const double off_y = stylus_.y - pointer.y;
  const double off_m = std::hypot(off_x, off_y);
  if (off_m > kStray_m) {
    stylus_.x = pointer.x + off_x * (kStray_m / off_m);
    stylus_.y = pointer.y + off_y * (kStray_m / off_m);
  }
  return stylus_;
}

}  // namespace nazori::devices
