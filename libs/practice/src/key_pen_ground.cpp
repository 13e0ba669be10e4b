// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/key_pen_ground.h"

#include <algorithm>
#include <cmath>

namespace nazori::practice {
namespace {

// A pen pressed this firmly touches the bottom of the deepest groove.
constexpr double kPressure = 0.8;

}  // namespace

geometry::TabletShape TabletGround::shape() const {
  return tablet_.tablet() ? tablet_.tablet()->shape() : geometry::TabletShape{};
}

double TabletGround::side_m() const { return shape().width_m; }

KeyPenGround::Line TabletGround::line(int number) const {
  Line line;
  for (const geometry::GlyphPoint p : tablet_.tablet()->lines()[static_cast<std::size_t>(number - 1)].points)
    line.push_back(geometry::glyph_to_tablet(p, shape()));
  return line;
}

double TabletGround::depth(geometry::TabletPoint at) const {
  if (!tablet_.tablet()) return 0;
  const surface::SmoothSurface& surface = *tablet_.tablet()->surface();
  const auto grid = geometry::tablet_to_grid(at, surface.size(), shape());
  return std::clamp(1 - surface.at(grid.x, grid.y).height, 0.0, 1.0);
}

void TabletGround::move_pen(geometry::TabletPoint at, bool is_down) {
  tablet_.move_stylus(at, is_down, is_down ? kPressure : 0);
}

bool SheetGround::press_harder(int steps) {
  // In whole steps, so that none is lost by rounding.
  const double now = std::round(pressure_ / kPressureStep);
  const double wanted = std::clamp(now + steps, 1.0, 1 / kPressureStep);
  if (wanted == now) return false;
  pressure_ = wanted * kPressureStep;
  if (is_down_) write_(at_, true, pressure_);
  return true;
}

void SheetGround::move_pen(geometry::TabletPoint at, bool is_down) {
  at_ = at;
  is_down_ = is_down;
  write_(at, is_down, is_down ? pressure_ : 0);
}

}  // namespace nazori::practice
