// SPDX-License-Identifier: Apache-2.0
// Advice on what the simulated brush writes, from the pen to the ink.
#include <gtest/gtest.h>

#include "nazori/calligraphy/sheet_editor.h"
#include "writing_under_test.h"

namespace nazori::calligraphy::test {
namespace {

/// Writes the strokes with a pen whose pressure makes the brush about as broad as they are.
std::unique_ptr<SheetEditor> write(const std::vector<BrushStroke>& strokes, double pressure = 0.85) {
  auto e = std::make_unique<SheetEditor>(std::move(SheetEditor::create("hanshi", 512).value()));
  for (const BrushStroke& stroke : strokes) {
    double broadest = 1e-9;
    for (const auto& point : stroke) broadest = std::max(broadest, point.half_width_m);
    for (const auto& point : stroke) {
      brush::PenSample sample;
      sample.time_s = point.time_s;
      sample.at = point.pen;
      sample.pressure = pressure * point.half_width_m / broadest;
      e->move_pen(sample);
    }
    e->lift_pen();
    e->dip_in_ink();
  }
  return e;
}

CharacterAdvice advice_on(const SheetEditor& e, const SheetModel& model) {
  return advise(e.written(), ink_on(e.sheet()), std::vector{model}).front();
}

TEST(AdviceOnBrush, ACarefulPenGetsNoAdvice) {
  const SheetModel model{three(), only_square()};
  const auto e = write(exactly(model));
  const auto result = advice_on(*e, model);
  EXPECT_EQ(names(result), std::vector<std::string>{});
  EXPECT_TRUE(result.is_comparable);
  EXPECT_GT(result.covered, 0.75);
  EXPECT_LT(result.outside, 0.25);
}

TEST(AdviceOnBrush, SweepsAreSeenInTheInkAndMissedWhereThePressureStays) {
  const SheetModel model{rest(), only_square()};
  auto strokes = exactly(model);
  const auto good = write(strokes);
  const auto fine = advice_on(*good, model);
  EXPECT_FALSE(has(fine, "flat_width"));
  EXPECT_FALSE(has(fine, "no_sweep@0"));
  for (auto& stroke : strokes)
    for (auto& point : stroke) point.half_width_m = 0.0026;
  const auto flat = write(strokes);
  const auto result = advice_on(*flat, model);
  EXPECT_TRUE(has(result, "no_sweep@0")) << ::testing::PrintToString(names(result));
  EXPECT_TRUE(has(result, "flat_width")) << ::testing::PrintToString(names(result));
}

TEST(AdviceOnBrush, ATimidPenIsTooThin) {
  const SheetModel model{three(), only_square()};
  const auto e = write(exactly(model), 0.35);
  EXPECT_TRUE(has(advice_on(*e, model), "thin@1")) << ::testing::PrintToString(names(advice_on(*e, model)));
}

TEST(AdviceOnBrush, AMouseAtItsUsualSpeedIsNotTooThin) {
  const SheetModel model{three(), only_square()};
  for (const bool guesses : {true, false}) {
    auto e = std::make_unique<SheetEditor>(std::move(SheetEditor::create("hanshi", 512).value()));
    brush::Handling handling;
    handling.guess_pressure = guesses;
    handling.steady_pressure = 0.2;
    e->set_handling(handling);
    constexpr double kMouse_m_s = 0.25;
    for (BrushStroke stroke : exactly(model)) {
      pace(stroke, [](double) { return kMouse_m_s; });
      for (const auto& point : stroke) {
        brush::PenSample sample;
        sample.time_s = point.time_s;
        sample.at = point.pen;
        e->move_pen(sample);
      }
      e->lift_pen();
      e->dip_in_ink();
    }
    ASSERT_EQ(e->written().size(), 3U);
    EXPECT_EQ(width_from(e->written()[0]), guesses ? WidthFrom::speed : WidthFrom::nothing);
    const auto result = advice_on(*e, model);
    for (const char* width : {"thin@0", "thin@1", "thin@2", "flat_width", "uncovered"})
      EXPECT_FALSE(has(result, width)) << ::testing::PrintToString(names(result));
  }
}

TEST(AdviceOnBrush, TheHeightOfADeviceIsAsGoodAsThePressureOfAPen) {
  BrushStroke stroke;
  brush::PenSample sample;
  const std::vector<geometry::BristleSegment> swept(1);
  add_point(stroke, sample, swept);
  EXPECT_EQ(stroke.back().width_from, WidthFrom::speed);
  add_point(stroke, sample, swept, false);
  EXPECT_EQ(stroke.back().width_from, WidthFrom::nothing);
  sample.height_m = -0.001;
  add_point(stroke, sample, swept, false);
  EXPECT_EQ(stroke.back().width_from, WidthFrom::hand);
  sample.height_m = {};
  sample.pressure = 0.5;
  add_point(stroke, sample, swept);
  EXPECT_EQ(stroke.back().width_from, WidthFrom::hand);
  EXPECT_EQ(width_from(stroke), WidthFrom::hand) << "of most points";
}

}  // namespace
}  // namespace nazori::calligraphy::test
