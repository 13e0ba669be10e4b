// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/plot_hand.h"

#include "nazori/functions/tablet_curves.h"
#include "nazori/geometry/point.h"

namespace nazori::practice {
namespace {

constexpr double kSlide_m = 2.5e-3;  ///< farther than a step: the stylus is lifted on the way
constexpr double kMoved_m = 1.5e-3;  ///< farther: the stylus was moved away from where the keys put it

}  // namespace

std::optional<geometry::TabletPoint> PlotHand::put() {
  const auto from = put_;
  const auto& drawing = *explorer_.drawing();
  put_ = functions::tablet_place(explorer_.location()->at, drawing.picture.plate.heights.size(),
                                 tablet_.tablet()->shape());
  const bool slides = from && geometry::distance(*from, *put_) < kSlide_m;
  tablet_.move_stylus(*put_, slides);
  return slides ? std::nullopt : put_;
}

void PlotHand::press(geometry::TabletPoint at) {
  if (put_ && *put_ == at) tablet_.move_stylus(at, true);
}

std::optional<PlotHand::Feeling> PlotHand::follow() {
  const auto& sample = tablet_.latest();
  const geometry::TabletPoint tip{sample.proxy_m.x, sample.proxy_m.y};
  if (put_) {
    if (geometry::distance(tip, *put_) < kMoved_m || !tablet_.is_pressed()) return std::nullopt;
    // Either a hand moved the stylus, or it has not arrived yet where the keys sent it.
    const geometry::TabletPoint wanted{sample.device_m.x, sample.device_m.y};
    if (geometry::distance(wanted, *put_) < kMoved_m) return std::nullopt;
  }
  const auto& drawing = explorer_.drawing();
  if (!sample.touching || !drawing || !drawing->final) {
    if (put_) return std::nullopt;
    return Feeling{};
  }
  put_.reset();
  const auto at =
      functions::plate_place(tip, drawing->picture.plate.heights.size(), tablet_.tablet()->shape());
  return Feeling{explorer_.touch(at), at};
}

}  // namespace nazori::practice
