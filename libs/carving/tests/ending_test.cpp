// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nazori/carving/carve.h"
#include "test_strokes.h"

namespace nazori::carving {
namespace {

using namespace test;

constexpr int kSize = 1091;  // ten samples a glyph unit

/// Width of the groove across x = `x` where it is half as deep as the brush goes, in glyph units.
double width_at(const surface::HeightMap& map, double x, double y) {
  double width = 0;
  for (double d = -12; d <= 12; d += 0.02)
    if (height_at(map, {x, y + d}) < 0.5) width += 0.02;
  return width;
}

surface::HeightMap level_stroke(StrokeEnding ending, bool endings = true) {
  Brush brush = plain_brush(7);
  brush.endings = endings;
  return carved({stroke({{15, 50}, {90, 50}}, ending)}, kSize, brush);
}

TEST(StrokeEnding, AStopKeepsItsFullDepthToTheEndAndIsWiderThanTheBody) {
  const auto map = level_stroke(StrokeEnding::stop);
  for (double x = 15; x <= 90; x += 0.5) EXPECT_LT(height_at(map, {x, 50}), 0.001) << x;
  EXPECT_GT(width_at(map, 90, 50), 1.1 * width_at(map, 52, 50));
  // Blunt: from the floor to the plateau within the brush's own half width.
  EXPECT_EQ(height_at(map, {90 + 4.2, 50}), 1);
  EXPECT_GT(height_at(map, {90 + 3.0, 50}), 0.6);
}

TEST(StrokeEnding, TheBodyIsEvenAndTheEntryIsPressed) {
  const auto map = level_stroke(StrokeEnding::stop);
  const double body = width_at(map, 50, 50);
  for (double x = 25; x <= 78; x += 1) EXPECT_NEAR(width_at(map, x, 50), body, 0.05) << x;
  EXPECT_GT(width_at(map, 15.5, 50), 1.05 * body);
}

TEST(StrokeEnding, ATaperNarrowsAndRisesToNothingOverItsLastThird) {
  const auto map = level_stroke(StrokeEnding::taper);
  for (double x = 15; x <= 64.5; x += 0.5) EXPECT_LT(height_at(map, {x, 50}), 0.001) << x;
  double height = 0;
  double width = width_at(map, 60, 50);
  for (double x = 65; x <= 90; x += 0.5) {
    EXPECT_GE(height_at(map, {x, 50}), height - 1e-4) << x;
    EXPECT_LE(width_at(map, x, 50), width + 0.05) << x;
    height = height_at(map, {x, 50});
    width = width_at(map, x, 50);
  }
  EXPECT_NEAR(height_at(map, {77.5, 50}), 0.5, 0.01);  // halfway along, the brush is half lifted
  EXPECT_GT(height_at(map, {89, 50}), 0.98);
  EXPECT_EQ(height_at(map, {90.5, 50}), 1);
  // No step anywhere along the line: the tip meets the plateau level.
  for (double x = 60; x < 92; x += 0.1)
    EXPECT_LT(std::abs(height_at(map, {x + 0.1, 50}) - height_at(map, {x, 50})), 0.01) << x;
}

TEST(StrokeEnding, AHookStopsInFullAndThenKicksAThinRisingTail) {
  const auto line = stroke({{60, 10}, {60, 80}, {53, 75}}, StrokeEnding::hook);
  EXPECT_NEAR(hook_length(line), std::hypot(7, 5), 1e-9);
  const auto map = carved({line}, kSize, plain_brush(7));
  for (double y = 10; y <= 80; y += 0.5) EXPECT_LT(height_at(map, {60, y}), 0.001) << y;
  EXPECT_EQ(height_at(map, {60, 84.5}), 1);
  EXPECT_GT(width_at(map, 60, 80), 0);
  // Along the tail the groove rises without a step from the floor to the plateau.
  double height = 0;
  for (double t = 0; t <= 1; t += 0.02) {
    const double now = height_at(map, {60 - 7 * t, 80 - 5 * t});
    EXPECT_GE(now, height - 1e-4) << t;
    EXPECT_LT(now - height, 0.08) << t;
    height = now;
  }
  EXPECT_GT(height, 0.99);
  // The tail reaches beyond the round end of the stop (half width 4).
  EXPECT_LT(height_at(map, {60 - 7 * 0.6, 80 - 5 * 0.6}), 0.6);
  // A stop at the same point has no tail there.
  const auto stop = carved({stroke({{60, 10}, {60, 80}})}, kSize, plain_brush(7));
  EXPECT_GT(height_at(stop, {60 - 7 * 0.6, 80 - 5 * 0.6}), 0.95);
}

TEST(StrokeEnding, WithEndingsOffAllEndAlike) {
  const auto stop = level_stroke(StrokeEnding::stop, false);
  for (const auto ending : {StrokeEnding::hook, StrokeEnding::taper, StrokeEnding::either})
    EXPECT_EQ(level_stroke(ending, false), stop);
  EXPECT_NEAR(width_at(stop, 16, 50), width_at(stop, 89, 50), 0.03);
}

TEST(StrokeEnding, EitherIsCarvedAsAStop) {
  EXPECT_EQ(level_stroke(StrokeEnding::either), level_stroke(StrokeEnding::stop));
}

TEST(BrushAt, TellsTheDepthOfTheCarvedCentreLine) {
  for (const auto ending : {StrokeEnding::stop, StrokeEnding::taper, StrokeEnding::either}) {
    const auto map = level_stroke(ending);
    for (double s = 0; s <= 75; s += 0.25) {
      EXPECT_NEAR(1 - height_at(map, {15 + s, 50}), brush_at(plain_brush(7), ending, s, 75).depth, 0.004)
          << s << ' ' << static_cast<int>(ending);
    }
  }
}

TEST(BrushAt, HoldsPlacesBeyondTheStrokeAtItsEnds) {
  const Brush brush = plain_brush();
  EXPECT_EQ(brush_at(brush, StrokeEnding::taper, 99, 50).depth,
            brush_at(brush, StrokeEnding::taper, 50, 50).depth);
  EXPECT_EQ(brush_at(brush, StrokeEnding::stop, -3, 50).half_width,
            brush_at(brush, StrokeEnding::stop, 0, 50).half_width);
  EXPECT_EQ(brush_at(brush, StrokeEnding::stop, 0, 0).depth, 1);
}

TEST(HookLength, IsThePartAfterTheLastSharpTurnOnly) {
  EXPECT_EQ(hook_length(stroke({{10, 10}, {60, 10}, {60, 80}, {53, 75}})), 0) << "not a hook";
  EXPECT_NEAR(hook_length(stroke({{10, 10}, {60, 10}, {60, 80}, {53, 75}}, StrokeEnding::hook)), 8.602, 1e-3);
  EXPECT_NEAR(hook_length(stroke({{10, 10}, {60, 10}}, StrokeEnding::hook)), 7, 1e-9) << "no turn";
  EXPECT_EQ(hook_length(stroke({{10, 10}}, StrokeEnding::hook)), 0);
}

TEST(HookLength, AKickWithARoundFootBeginsInTheMiddleOfTheFoot) {
  // Measured over 4 units to both sides the bend turns by 40 degrees, which is not a hook yet; over 6 units
  // by 60.
  constexpr double kRadius = 5.7;
  constexpr double kTurn = 2 * std::numbers::pi / 3;
  constexpr double kTail = 5;
  StrokeLine line = stroke({{60, 10}}, StrokeEnding::hook);
  constexpr int kSteps = 24;
  for (int i = 0; i <= kSteps; ++i) {
    const double a = kTurn * i / kSteps;
    line.points.push_back({60 - kRadius + kRadius * std::cos(a), 70 + kRadius * std::sin(a)});
  }
  line.points.push_back(line.points.back() + GlyphPoint{-std::sin(kTurn), std::cos(kTurn)} * kTail);
  EXPECT_NEAR(hook_length(line), kRadius * kTurn / 2 + kTail, 0.6);
}

TEST(HookLength, FindsTheKicksThatKanjiVgDraws) {
  // 永: horizontal, turn, vertical, hook; 水: vertical, hook. Both hooks are 6 to 10 units long.
  for (const auto& [character, number] : {std::pair{"永", 1}, std::pair{"水", 0}}) {
    const auto strokes = kanjivg(character);
    const StrokeLine& line = strokes[static_cast<std::size_t>(number)];
    ASSERT_EQ(line.ending, StrokeEnding::hook);
    EXPECT_GT(hook_length(line), 5) << character;
    EXPECT_LT(hook_length(line), 12) << character;
  }
}

}  // namespace
}  // namespace nazori::carving
