// SPDX-License-Identifier: Apache-2.0
// Axes, ticks, grid and rim; the picture for paper; how a plot is drawn step by step.
#include "../src/layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "nazori/functions/print_picture.h"

namespace nazori::functions {
namespace {

TEST(Ticks, AreTheSmallestStepThatLeavesTenAtMost) {
  const std::pair<double, double> steps[] = {{10, 1},   {1, 0.1},  {12, 2},      {20, 2},
                                             {20.1, 5}, {50, 5},   {51, 10},     {99, 10},
                                             {100, 10}, {101, 20}, {3e-5, 5e-6}, {7e6, 1e6}};
  for (const auto& [range, step] : steps) {
    EXPECT_NEAR(tick_step(0, range), step, 1e-12 * step) << range;
    EXPECT_NEAR(tick_step(-range / 4, range * 3 / 4), step, 1e-12 * step) << range;
  }
}

TEST(Ticks, DistancesAreThoseToTheNearest) {
  // Ticks at 0, 0.5, ..., 2.5 of a range from -0.1 to 2.6.
  for (const bool downwards : {false, true}) {
    const auto distances = tick_distances(-0.1, 2.6, 7, downwards);
    ASSERT_EQ(distances.size(), 7U);
    for (int i = 0; i < 7; ++i) {
      const double c = ((downwards ? 6 - i : i) + 0.5) / 7;
      double nearest = 10;
      for (const double tick : {0.0, 0.5, 1.0, 1.5, 2.0, 2.5})
        nearest = std::min(nearest, std::abs(c - (tick + 0.1) / 2.7));
      EXPECT_NEAR(distances[static_cast<std::size_t>(i)], nearest, 1e-12) << i;
    }
  }
  // Both ends of the range are ticks themselves.
  const auto ends = tick_distances(-1, 1, 20, false);
  EXPECT_NEAR(ends.front(), 0.025, 1e-12);
  EXPECT_NEAR(ends.back(), 0.025, 1e-12);
}

constexpr int kSize = 2000;

struct Layered {
  Plate plate;
  Window window;
  /// Height at the sample nearest to a place, in plate units.
  [[nodiscard]] float at(double u, double v) const {
    const auto cell = [](double c) { return std::clamp(static_cast<int>(c * kSize), 0, kSize - 1); };
    return plate.heights.at(cell(u), cell(1 - v));
  }
};

Layered layered(const Window& window, const Layers& layers, std::vector<Branch> branches = {},
                std::vector<Fill> fills = {}) {
  Tracing tracing;
  tracing.window = window;
  tracing.branches = std::move(branches);
  tracing.fills = std::move(fills);
  PlateSettings settings;
  settings.size = kSize;
  settings.layers = layers;
  auto plate = carve(tracing, settings);
  EXPECT_TRUE(plate);
  return {std::move(*plate), window};
}

TEST(LayersOfAPlate, AxesAreRidgesThatMeetInAHigherOrigin) {
  const Layered p = layered({-3, 1, -1, 1}, {true, false, false, false});
  // The y axis is at u = 3/4, the x axis at v = 1/2.
  EXPECT_NEAR(p.at(0.75, 0.2), 0.97, 0.001);
  EXPECT_NEAR(p.at(0.2, 0.5), 0.97, 0.001);
  EXPECT_NEAR(p.at(0.75, 0.5), 1.0, 0.002);
  // Half as high over the plateau a half of 0.0045 beside it, and nothing beyond the whole.
  EXPECT_NEAR(p.at(0.75 + 0.00225, 0.2), 0.935, 0.008);
  EXPECT_GT(p.at(0.75 + 0.004, 0.2), 0.9001F);
  EXPECT_EQ(p.at(0.75 + 0.005, 0.2), 0.9F);
  EXPECT_EQ(p.at(0.75 - 0.005, 0.2), 0.9F);
  EXPECT_EQ(p.at(0.2, 0.5 + 0.005), 0.9F);
  // The origin is a hill of 0.009.
  EXPECT_GT(p.at(0.75 + 0.0058, 0.5 + 0.0058), 0.9001F);
  EXPECT_EQ(p.at(0.75 + 0.0068, 0.5 + 0.0068), 0.9F);
  EXPECT_EQ(p.at(0.01, 0.01), 0.9F) << "no rim";
}

TEST(LayersOfAPlate, AnAxisOutsideTheWindowIsNotThereButItsTicksAreOnTheFrame) {
  const Layered p = layered({1, 5, -7, -3}, {true, true, false, false});
  // Ticks every half; x = 2 is at u = 1/4, y = -4 at v = 3/4. The x axis lies above, the y axis to the left.
  EXPECT_NEAR(p.at(0.25, 0.995), 0.97, 0.002);
  EXPECT_NEAR(p.at(0.005, 0.75), 0.97, 0.002);
  EXPECT_EQ(p.at(0.25, 0.5), 0.9F);
  EXPECT_EQ(p.at(0.19, 0.999), 0.9F) << "no axis between the ticks";
  EXPECT_EQ(p.at(0.001, 0.81), 0.9F);
  const Layered other = layered({-5, -1, 3, 7}, {true, true, false, false});
  EXPECT_NEAR(other.at(0.25, 0.005), 0.97, 0.002);
  EXPECT_NEAR(other.at(0.995, 0.75), 0.97, 0.002);
}

TEST(LayersOfAPlate, TicksReachAsFarOnBothSidesOfTheAxes) {
  const Layered p = layered({-1, 1, -2, 2}, {false, true, false, false});
  // A tick at x = 0.4, u = 0.7, across the x axis at v = 1/2; one at y = 1, v = 3/4.
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(p.at(0.7, 0.5 + side * 0.013), 0.97, 0.002);
    EXPECT_EQ(p.at(0.7, 0.5 + side * 0.015), 0.9F);
    EXPECT_NEAR(p.at(0.5 + side * 0.013, 0.75), 0.97, 0.002);
    EXPECT_EQ(p.at(0.5 + side * 0.015, 0.75), 0.9F);
  }
  EXPECT_EQ(p.at(0.65, 0.5), 0.9F) << "no axis";
  EXPECT_EQ(p.at(0.7 + 0.005, 0.5), 0.9F);
}

TEST(LayersOfAPlate, TheGridIsAFineLowRidgeAtEveryTick) {
  const Layered p = layered({-1, 1, -2, 2}, {false, false, true, false});
  EXPECT_NEAR(p.at(0.7, 0.33), 0.925, 0.0015);
  EXPECT_NEAR(p.at(0.33, 0.75), 0.925, 0.0015);
  EXPECT_GT(p.at(0.7 + 0.002, 0.33), 0.9001F);
  EXPECT_EQ(p.at(0.7 + 0.003, 0.33), 0.9F);
  EXPECT_EQ(p.at(0.65, 0.33), 0.9F);
}

TEST(LayersOfAPlate, TheRimStandsAroundEverything) {
  const Layered p = layered({-1, 1, -2, 2}, {false, false, false, true});
  for (const double c : {0.0005, 0.0115}) {
    EXPECT_EQ(p.at(c, 0.4), 1);
    EXPECT_EQ(p.at(1 - c, 0.4), 1);
    EXPECT_EQ(p.at(0.4, c), 1);
    EXPECT_EQ(p.at(0.4, 1 - c), 1);
  }
  EXPECT_EQ(p.at(0.0125, 0.4), 0.9F);
  EXPECT_EQ(p.at(0.4, 1 - 0.0125), 0.9F);
}

TEST(LayersOfAPlate, KeepAwayFromGroovesAndRegions) {
  Branch curve;
  curve.points = {{0.2, 0, 0}, {0.2, 1, 0}};
  const Layered p = layered({-1, 1, -1, 1}, {true, true, true, true}, {curve}, {{0, {0.6, 0.1}, {0.8, 0.9}}});
  // The x axis comes as near as two and a half half widths: 0.03125.
  EXPECT_EQ(p.at(0.2 + 0.031, 0.5), 0.9F);
  EXPECT_GT(p.at(0.2 + 0.032, 0.5), 0.96F);
  EXPECT_GT(p.at(0.2 - 0.032, 0.5), 0.96F);
  EXPECT_LT(p.at(0.2, 0.5), 0.001F);
  EXPECT_LT(p.at(0.2, 0.005), 0.001F) << "the rim is cut by the groove";
  EXPECT_LE(p.at(0.7, 0.5), 0.9F * 0.9F + 1e-4F);
  // Without layers the plateau is the highest there is.
  EXPECT_EQ(layered({-1, 1, -1, 1}, Layers::none()).at(0.5, 0.5), 1);
}

/// A print of 10 dots a millimetre, 100 mm wide.
struct Printed {
  surface::HeightMap picture;
  /// Millimetres from the left and from below.
  [[nodiscard]] bool black(double x, double y) const {
    return picture.at(static_cast<int>(x * 10), 999 - static_cast<int>(y * 10)) == 0;
  }
};

Printed printed(Tracing tracing, const Window& window, bool axes = true) {
  tracing.window = window;
  auto picture = print_picture(tracing, {100, 254, axes});
  EXPECT_TRUE(picture);
  EXPECT_EQ(picture->size(), 1000);
  return {std::move(*picture)};
}

TEST(Print, AxesTicksAndFrameHaveTheirWidths) {
  const Printed p = printed({}, {-3, 1, -1, 1});
  EXPECT_TRUE(p.black(20.05, 50.25));
  EXPECT_FALSE(p.black(20.05, 50.45)) << "0.7 mm";
  EXPECT_TRUE(p.black(75.25, 20.05));
  EXPECT_FALSE(p.black(75.45, 22.05));
  // Ticks 3 mm long: x = -2 at 25 mm, y = 0.6 at 80 mm.
  EXPECT_TRUE(p.black(25.05, 51.35));
  EXPECT_FALSE(p.black(25.05, 51.65));
  EXPECT_TRUE(p.black(73.65, 80.05));
  EXPECT_FALSE(p.black(73.35, 80.05));
  EXPECT_TRUE(p.black(0.35, 33.05));
  EXPECT_FALSE(p.black(0.65, 33.05)) << "a frame of half a millimetre";
  EXPECT_TRUE(p.black(33.05, 99.65));
  const Printed none = printed({}, {-3, 1, -1, 1}, false);
  EXPECT_FALSE(none.black(20.05, 50.05));
  EXPECT_TRUE(none.black(0.05, 50.05));
  const Printed outside = printed({}, {1, 5, -7, -3});
  EXPECT_FALSE(outside.black(1.05, 81.05));
  EXPECT_TRUE(outside.black(1.05, 75.05)) << "ticks along the frame";
  EXPECT_TRUE(outside.black(25.05, 98.95));
  EXPECT_FALSE(outside.black(25.05, 50.05));
}

TEST(Print, EveryStatementHasALineOfItsOwnAndAxesStopBesideIt) {
  Tracing tracing;
  for (int k = 0; k < 5; ++k) {
    Branch b;
    b.statement = k;
    b.points = {{0, 0.1 + 0.06 * k, 0}, {1, 0.1 + 0.06 * k, 0}};
    tracing.branches.push_back(b);
  }
  Branch strict;
  strict.strict = true;
  strict.points = {{0, 0.6, 0}, {1, 0.6, 0}};
  tracing.branches.push_back(strict);
  const Printed p = printed(tracing, {-1, 1, -3, 1});
  const std::vector<std::vector<double>> styles{{100}, {6, 3}, {1.7, 3.2}, {7, 3, 1.7, 3}, {100}, {6, 3}};
  for (std::size_t k = 0; k < styles.size(); ++k) {
    const double y = k == 5 ? 60.02 : 10.02 + 6 * static_cast<double>(k);
    double at = 0;
    for (std::size_t part = 0; at < 40; ++part) {
      const double length = styles[k][part % styles[k].size()];
      // A stroke is round at its ends and 0.8 mm longer on both.
      const double middle = at + length / 2;
      if (middle > 1 && middle < 45) {
        EXPECT_EQ(p.black(middle, y), part % 2 == 0) << k << " at " << middle;
      }
      if (part % 2 == 0 && at > 2) {
        EXPECT_TRUE(p.black(at - 0.6, y)) << k << " at " << at;
        EXPECT_FALSE(p.black(at - 1.0, y)) << k << " at " << at;
      }
      at += length;
    }
  }
  // 1.6 mm wide; the y axis at 50 mm comes as near as 2 mm to the ink.
  EXPECT_TRUE(p.black(30.05, 10.75));
  EXPECT_FALSE(p.black(30.05, 10.95));
  EXPECT_FALSE(p.black(50.05, 12.65));
  EXPECT_TRUE(p.black(50.05, 12.95));
  EXPECT_FALSE(p.black(50.05, 57.35));
  EXPECT_TRUE(p.black(50.05, 57.05));
}

TEST(Print, BarsAndDotsAreInkAndRegionsAreHatched) {
  Tracing tracing;
  tracing.bars.push_back({1, {0.3, 0.2}, {0.3, 0.4}});
  tracing.dots.push_back({1, {0.6, 0.3}});
  tracing.fills.push_back({0, {0.7, 0.7}, {0.9, 0.9}});
  const Printed p = printed(tracing, {1, 2, 1, 2});
  EXPECT_TRUE(p.black(30.05, 30.05));
  EXPECT_TRUE(p.black(30.75, 30.05));
  EXPECT_FALSE(p.black(30.95, 30.05));
  EXPECT_TRUE(p.black(60.05, 30.75));
  EXPECT_FALSE(p.black(60.05, 30.95));
  // Three tenths of the way from one line of 3 mm to the next, aslant.
  int black = 0;
  int starts = 0;
  for (int i = 0; i < 180; ++i) {
    const double x = 71.05 + 0.1 * i;
    black += p.black(x, 80.05) ? 1 : 0;
    starts += p.black(x, 80.05) && !p.black(x - 0.1, 80.05) ? 1 : 0;
    EXPECT_EQ(p.black(x, 80.05), p.black(x - 0.1, 80.15));
  }
  EXPECT_NEAR(black, 54, 2);
  EXPECT_NEAR(starts, 6, 1);
  EXPECT_FALSE(p.black(69.5, 80.05));
}

TEST(Print, RefusesSizesOutOfRangeAndTakesThoseOnItsEnds) {
  const auto size = [](double side, int dots) {
    const auto picture = print_picture({}, {side, dots, false});
    return picture ? picture->size() : 0;
  };
  EXPECT_EQ(size(50, 72), 142);
  EXPECT_EQ(size(49.9, 72), 0);
  EXPECT_EQ(size(400, 72), 1134);
  EXPECT_EQ(size(400.1, 72), 0);
  EXPECT_EQ(size(50, 71), 0);
  EXPECT_EQ(size(50, 600), 1181);
  EXPECT_EQ(size(50, 601), 0);
}

}  // namespace
}  // namespace nazori::functions
