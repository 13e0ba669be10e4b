// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/brush_widths.h"

#include <gtest/gtest.h>

#include "nazori/brush/pen.h"
#include "nazori/calligraphy/brush_stroke.h"

namespace nazori::calligraphy {
namespace {

TEST(BrushWidths, PressureGrowsWithTheWidthAndHasLimits) {
  const BrushWidths widths(brush::tuft_form(6).value());
  EXPECT_EQ(widths.pressure_for(0), 0);
  EXPECT_EQ(widths.pressure_for(1), 1);
  double before = 0;
  for (const double half_m : {0.0005, 0.001, 0.0015, 0.002}) {
    const double pressure = widths.pressure_for(half_m);
    EXPECT_GT(pressure, before) << half_m;
    EXPECT_LT(pressure, 1) << half_m;
    before = pressure;
  }
}

TEST(BrushWidths, AThickerBrushNeedsLessPressure) {
  const BrushWidths thin(brush::tuft_form(6).value()), thick(brush::tuft_form(1).value());
  EXPECT_LT(thick.pressure_for(0.002), thin.pressure_for(0.002));
}

TEST(BrushWidths, AStrokeWithThatPressureIsAsBroad) {
  const brush::TuftForm form = brush::tuft_form(4).value();
  const double half_m = 0.0023;
  const double pressure = BrushWidths(form).pressure_for(half_m);
  // Downwards and in other steps than those with which the widths were found.
  brush::Tuft tuft(form);
  brush::PenToHolder holder(form, {});
  BrushStroke stroke;
  for (int i = 0; i <= 90; ++i) {
    brush::PenSample sample;
    sample.time_s = 0.008 * i;
    sample.at = {0, -0.0004 * i};
    sample.pressure = pressure;
    std::vector<geometry::BristleSegment> swept;
    tuft.move_to(holder.next(sample), swept);
    add_point(stroke, sample, swept);
  }
  EXPECT_NEAR(stroke.back().half_width_m, half_m, 0.12 * half_m);
}

}  // namespace
}  // namespace nazori::calligraphy
