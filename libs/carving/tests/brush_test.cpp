// SPDX-License-Identifier: Apache-2.0
#include "../src/brush.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "test_strokes.h"

namespace nazori::carving {
namespace {

using namespace test;

constexpr double kWidth = 10;
constexpr double kLength = 80;

BrushMark mark(StrokeEnding ending, double s, double hook = 0, double length = kLength) {
  return brush_at(plain_brush(kWidth), ending, s, length, hook);
}

/// By how much the brush is wider than its body.
double press(StrokeEnding ending, double s, double hook = 0) {
  return mark(ending, s, hook).half_width / (kWidth / 2) - 1;
}

TEST(Press, AtTheEntryIsOverNineTenthsOfAWidthFurtherOn) {
  EXPECT_NEAR(press(StrokeEnding::stop, 0), 0.08, 1e-12);
  // Level at both ends, (1 - t^2)^2 between them.
  for (const double t : {0.1, 0.25, 0.5, 0.75, 0.99})
    EXPECT_NEAR(press(StrokeEnding::stop, 9 * t), 0.08 * (1 - t * t) * (1 - t * t), 1e-12) << t;
  for (const double s : {9.0, 9.1, 20.0, 40.0, 68.0, 68.9}) EXPECT_EQ(press(StrokeEnding::stop, s), 0) << s;
}

TEST(Press, AtAStopGrowsOverElevenTenthsOfAWidth) {
  EXPECT_NEAR(press(StrokeEnding::stop, kLength), 0.15, 1e-12);
  for (const double t : {0.1, 0.25, 0.5, 0.75, 0.99})
    EXPECT_NEAR(press(StrokeEnding::stop, kLength - 11 * t), 0.15 * (1 - t * t) * (1 - t * t), 1e-12) << t;
  EXPECT_EQ(press(StrokeEnding::stop, kLength - 11), 0);
  for (double s = 0; s <= kLength; s += 5) EXPECT_EQ(mark(StrokeEnding::stop, s).depth, 1) << s;
}

TEST(Press, OnAStrokeShorterThanItsPressesStaysWithinTheirSizes) {
  for (const double length : {0.5, 3.0, 9.0, 12.0}) {
    for (int i = 0; i <= 20; ++i) {
      const double w = mark(StrokeEnding::stop, length * i / 20, 0, length).half_width / (kWidth / 2);
      EXPECT_GE(w, 1) << length;
      EXPECT_LE(w, 1.08 * 1.15) << length;
    }
    const BrushZones zones = zones_of(plain_brush(kWidth), StrokeEnding::stop, length, 0);
    EXPECT_EQ(zones.entry_end, std::min(9.0, length));
    EXPECT_EQ(zones.ending_start, std::max(0.0, length - 11));
    EXPECT_EQ(zones.body_end, length);
  }
}

TEST(Taper, IsLiftedEvenlyOverTheLastThird) {
  for (double s = 10; s <= kLength * 2 / 3; s += 1) {
    EXPECT_EQ(press(StrokeEnding::taper, s), 0) << s;
    EXPECT_EQ(mark(StrokeEnding::taper, s).depth, 1) << s;
  }
  for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const BrushMark at = mark(StrokeEnding::taper, kLength * (2 + u) / 3);
    // Level at both ends: 1 - (3 u^2 - 2 u^3). The width thins evenly at first, then to a point.
    EXPECT_NEAR(at.depth, 1 - u * u * (3 - 2 * u), 1e-9) << u;
    EXPECT_NEAR(at.half_width, kWidth / 2 * (1 - u) * (1 + u - 0.6 * u * u), 1e-9) << u;
  }
}

TEST(Kick, LeavesTheStopAtItsFullWidthAndRisesToAPoint) {
  constexpr double kHook = 12;
  constexpr double kStop = kLength - kHook;
  EXPECT_NEAR(press(StrokeEnding::hook, kStop, kHook), 0.15, 1e-12);
  EXPECT_NEAR(press(StrokeEnding::hook, kStop - 5.5, kHook), 0.15 * 0.5625, 1e-12);
  EXPECT_EQ(press(StrokeEnding::hook, kStop - 11, kHook), 0);
  for (const double u : {0.001, 0.25, 0.5, 0.75, 1.0}) {
    const BrushMark at = mark(StrokeEnding::hook, kStop + kHook * u, kHook);
    const double risen = std::pow(u, 1.4);
    EXPECT_NEAR(at.depth, 1 - risen * risen * (3 - 2 * risen), 1e-9) << u;
    EXPECT_NEAR(at.half_width, kWidth / 2 * 1.15 * (1 - u * u * (1.5 - 0.5 * u)), 1e-9) << u;
  }
  EXPECT_EQ(mark(StrokeEnding::hook, kStop, kHook).depth, 1);
  // Only a hook kicks.
  EXPECT_EQ(mark(StrokeEnding::stop, kLength - 1, kHook).depth, 1);
  EXPECT_EQ(mark(StrokeEnding::either, kLength - 1, kHook).depth, 1);
}

TEST(Kick, ThatIsTheWholeStrokeHasNoPressBeforeIt) {
  for (const double hook : {kLength, kLength + 5}) {
    EXPECT_EQ(press(StrokeEnding::hook, 0, hook), 0);
    EXPECT_NEAR(mark(StrokeEnding::hook, kLength, hook).depth, 0, 1e-12);
  }
  EXPECT_EQ(zones_of(plain_brush(), StrokeEnding::hook, 5, 9).body_end, 0);
  EXPECT_EQ(zones_of(plain_brush(), StrokeEnding::hook, 5, -1).body_end, 5);
}

TEST(BrushAt, WithoutEndingsIsTheSameEverywhere) {
  Brush brush = plain_brush(kWidth);
  brush.endings = false;
  brush.depth = 0.6;
  for (const auto ending : {StrokeEnding::stop, StrokeEnding::hook, StrokeEnding::taper}) {
    for (const double s : {0.0, 1.0, 40.0, 79.0, 80.0}) {
      EXPECT_EQ(brush_at(brush, ending, s, kLength, 10).half_width, kWidth / 2);
      EXPECT_EQ(brush_at(brush, ending, s, kLength, 10).depth, 0.6);
    }
    EXPECT_EQ(zones_of(brush, ending, kLength, 10).body_end, kLength);
  }
}

TEST(BrushAt, ALiftedBrushIsAsMuchShallowerWhateverItsDepth) {
  Brush brush = plain_brush(kWidth);
  brush.depth = 0.5;
  const double middle_of_taper = kLength * 5 / 6;
  EXPECT_NEAR(brush_at(brush, StrokeEnding::taper, middle_of_taper, kLength).depth, 0.25, 1e-12);
}

TEST(SuggestedWidth, IsTheGapOfStrokesThatLieBesideEachOther) {
  const auto pair = [](double gap, double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    const GlyphPoint way{std::cos(a), std::sin(a)};
    return std::vector{stroke({{20, 50}, {80, 50}}),
                       stroke({GlyphPoint{50, 50 + gap} - way * 30, GlyphPoint{50, 50 + gap} + way * 30})};
  };
  EXPECT_NEAR(suggested_width(pair(4, 0)), 4, 1e-9);
  EXPECT_NEAR(suggested_width(pair(6.9, 0)), 6.9, 1e-9);
  EXPECT_EQ(suggested_width(pair(7.1, 0)), 7);
  EXPECT_EQ(suggested_width(pair(2.2, 0)), 3) << "a stylus falls into 3 units";
  EXPECT_EQ(suggested_width(pair(1.8, 0)), 7) << "one line, written twice";
  EXPECT_NEAR(suggested_width(pair(4, 180)), 4, 1e-9) << "whichever way they run";
  EXPECT_LT(suggested_width(pair(5, 18)), 6.9);
  EXPECT_EQ(suggested_width(pair(5, 22)), 7) << "strokes that open by more than twenty degrees are no bars";
  const auto apart = std::vector{stroke({{10, 50}, {40, 50}}), stroke({{60, 53}, {90, 53}})};
  EXPECT_EQ(suggested_width(apart), 7) << "one goes on where the other ended";
}

TEST(SuggestedWidth, AFewCloseStepsInAHundredDoNotDecide) {
  // Beside a line of 97 units lies a short one.
  const auto beside = [](double length) {
    return std::vector{stroke({{6, 50}, {103, 50}}), stroke({{40, 54}, {40 + length, 54}})};
  };
  EXPECT_EQ(suggested_width(beside(2)), 7);
  EXPECT_NEAR(suggested_width(beside(12)), 4, 1e-9);
}

TEST(SuggestedWidth, InkCoversHalfOfTheMiddleOfTheBoxAtMost) {
  // Strokes that lie at all angles: no two of them are parallel.
  std::vector<StrokeLine> fan;
  for (int k = 0; k < 7; ++k) {
    const double a = std::numbers::pi * k / 7;
    const GlyphPoint way{50 * std::cos(a), 50 * std::sin(a)};
    fan.push_back(stroke({GlyphPoint{54.5, 54.5} - way, GlyphPoint{54.5, 54.5} + way}));
  }
  EXPECT_NEAR(suggested_width(fan), 0.5 * 85 * 85 / 700, 1e-9);
  fan.push_back(fan.front());
  EXPECT_NEAR(suggested_width(fan), 0.5 * 85 * 85 / 700, 1e-9) << "a stroke given twice is one stroke";
}

TEST(SuggestedWidth, OfPointsAndOfLinesWithoutEndIsTheWidest) {
  EXPECT_EQ(suggested_width(std::vector{stroke({{50, 50}}), stroke({{53, 50}, {53, 50}})}), 7);
  EXPECT_EQ(suggested_width(std::vector{stroke({{-1e308, 0}, {1e308, 0}}), stroke({{1, 4}, {90, 4}})}), 7);
}

TEST(Fitted, ChangesTheWidthAloneAndIsFittedOnce) {
  const std::vector comb{stroke({{20, 50}, {80, 50}}), stroke({{20, 54}, {80, 54}})};
  const Brush brush = fitted({.width = 6, .depth = 0.4, .cross_section = CrossSection::v_shaped}, comb);
  EXPECT_NEAR(brush.width, 4, 1e-9);
  EXPECT_EQ(brush.depth, 0.4);
  EXPECT_EQ(brush.cross_section, CrossSection::v_shaped);
  EXPECT_TRUE(brush.endings);
  EXPECT_FALSE(brush.fit);
}

TEST(HookLength, OfALineWithoutATurnIsAQuarterAndSevenUnitsAtMost) {
  const auto level = [](double length) { return stroke({{10, 50}, {10 + length, 50}}, StrokeEnding::hook); };
  EXPECT_NEAR(hook_length(level(20)), 5, 1e-12);
  EXPECT_NEAR(hook_length(level(27)), 6.75, 1e-12);
  EXPECT_NEAR(hook_length(level(29)), 7, 1e-12);
}

/// Down for `down` units, then a turn, and `tail` units more.
StrokeLine kick(double down, double degrees, double tail) {
  const double a = (90 + degrees) * std::numbers::pi / 180;
  return stroke(
      {{60, 10}, {60, 10 + down}, GlyphPoint{60, 10 + down} + GlyphPoint{std::cos(a), std::sin(a)} * tail},
      StrokeEnding::hook);
}

TEST(HookLength, IsThatOfAShortTailAfterASharpTurn) {
  EXPECT_NEAR(hook_length(kick(60, 90, 13.9)), 13.9, 1e-9);
  EXPECT_EQ(hook_length(kick(60, 90, 14.1)), 7) << "too long for a kick";
  EXPECT_NEAR(hook_length(kick(11, 90, 10)), 10, 1e-9);
  EXPECT_NEAR(hook_length(kick(10, 90, 11)), 0.25 * 21, 1e-9) << "more than half of the stroke is no kick";
  EXPECT_NEAR(hook_length(kick(60, 52, 5)), 5, 1e-9);
  EXPECT_EQ(hook_length(kick(60, 48, 5)), 7) << "a bend of less than fifty degrees";
  EXPECT_NEAR(hook_length(kick(60, 90, 0.5)), 0.5, 1e-9);
}

TEST(HookLength, BeginsAtTheLastSharpTurnThoughAnEarlierOneIsSharper) {
  const auto line = stroke({{10, 10}, {60, 10}, {60, 17}, {55.7, 19.5}}, StrokeEnding::hook);
  EXPECT_NEAR(hook_length(line), std::hypot(4.3, 2.5), 1e-9);
}

}  // namespace
}  // namespace nazori::carving
