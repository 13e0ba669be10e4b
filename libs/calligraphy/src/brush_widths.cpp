// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/brush_widths.h"

#include <algorithm>

#include "nazori/brush/held_brush.h"
#include "nazori/calligraphy/brush_stroke.h"

namespace nazori::calligraphy {
namespace {

/// Half of the width of a straight stroke at its end, where the hair lies along it.
double drawn_half_width_m(brush::HeldBrush brush, double pressure) {
  constexpr double kLength_m = 0.02;
  constexpr int kMoves = 40;
  BrushStroke stroke;
  for (int i = 0; i <= kMoves; ++i) {
    brush::PenSample sample;
    sample.time_s = 0.01 * (i + 1);
    sample.at = {kLength_m * i / kMoves, 0};
    sample.pressure = pressure;
    add_point(stroke, sample, brush.move(sample, brush.tuft().wetness()));
  }
  return stroke.empty() ? 0 : stroke.back().half_width_m;
}

}  // namespace

BrushWidths::BrushWidths(const brush::TuftForm& form) {
  const brush::HeldBrush brush(form);
  for (std::size_t i = 1; i < half_width_m_.size(); ++i)
    half_width_m_[i] =
        std::max(half_width_m_[i - 1], drawn_half_width_m(brush, static_cast<double>(i) / kSteps));
}

double BrushWidths::pressure_for(double half_width_m) const {
  const auto above = std::lower_bound(half_width_m_.begin(), half_width_m_.end(), half_width_m);
  if (above == half_width_m_.begin()) return 0;
  if (above == half_width_m_.end()) return 1;
  const double low = *(above - 1);
  const auto steps = static_cast<double>(above - half_width_m_.begin() - 1);
  return (steps + (half_width_m - low) / (*above - low)) / kSteps;
}

}  // namespace nazori::calligraphy
