// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/raised.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nazori/model/mesh.h"
#include "test_plates.h"

namespace nazori::model {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

double rise(const Plate& plate, PlatePoint p) {
  return plate.at(static_cast<int>(std::lround(p.x / plate.step_mm())),
                  static_cast<int>(std::lround(p.y / plate.step_mm()))) -
         plate.thickness_mm();
}

/// Summits of braille dots in a box: samples as high as a dot, none of whose neighbours is higher.
int dots_in(const Plate& plate, PlatePoint low, PlatePoint high) {
  int count = 0;
  for (int row = 1; row + 1 < plate.rows(); ++row) {
    for (int column = 1; column + 1 < plate.columns(); ++column) {
      const double x = column * plate.step_mm();
      const double y = row * plate.step_mm();
      if (x < low.x || x > high.x || y < low.y || y > high.y) continue;
      const double own = plate.at(column, row) - plate.thickness_mm();
      if (own < 0.45 || own > 0.501) continue;
      bool summit = true;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const double other = plate.at(column + dx, row + dy) - plate.thickness_mm();
          const bool before = dy < 0 || (dy == 0 && dx < 0);
          if ((dx != 0 || dy != 0) && (before ? other >= own : other > own)) summit = false;
        }
      count += summit ? 1 : 0;
    }
  }
  return count;
}

TEST(RaisedStrokes, AStrokeHasALineADotAndANumber) {
  Plate plate = Plate::create(60, 60, 0.1, 3).value();
  const RaisedStroke stroke{{{30, 30}, {50, 30}}, LineEnd::sinks};
  EXPECT_THAT(add_strokes(plate, std::array{stroke}), IsEmpty());
  EXPECT_NEAR(rise(plate, {30, 30}), 1.8, 1e-4);
  EXPECT_NEAR(rise(plate, {40, 30}), 1.0, 1e-4);
  EXPECT_NEAR(rise(plate, {50, 30}), 1.0 / 3, 1e-4);
  // "1" is one dot, behind the start: to the left of it.
  EXPECT_EQ(dots_in(plate, {10, 20}, {28, 40}), 1);
  EXPECT_EQ(dots_in(plate, {33, 31.5}, {60, 60}), 0);
}

TEST(RaisedStrokes, DotsAndNumbersCanBeLeftOut) {
  Plate plate = Plate::create(60, 60, 0.1, 3).value();
  RaisedStrokeSettings settings;
  settings.start_dots = false;
  settings.numbers = false;
  add_strokes(plate, std::array{RaisedStroke{{{30, 30}, {50, 30}}, LineEnd::full}}, settings);
  EXPECT_NEAR(rise(plate, {30, 30}), 1, 1e-4);
  EXPECT_EQ(dots_in(plate, {0, 0}, {28, 60}), 0);
}

TEST(RaisedStrokes, NumbersStandClearOfLinesAndOfEachOther) {
  std::vector<RaisedStroke> strokes;
  for (int i = 0; i < 12; ++i) strokes.push_back({{{30, 10.0 + 9 * i}, {110, 10.0 + 9 * i}}, LineEnd::full});
  Plate plate = Plate::create(120, 120, 0.1, 3).value();
  EXPECT_THAT(add_strokes(plate, strokes), IsEmpty());
  // Dots of 1 to 12 as in the published alphabet: a b c d e f g h i, and aj, aa, ab.
  EXPECT_EQ(dots_in(plate, {0, 0}, {27, 120}),
            1 + 2 + 2 + 3 + 2 + 3 + 4 + 3 + 2 + (1 + 3) + (1 + 1) + (1 + 2));
}

TEST(RaisedStrokes, NumbersStandClearOfTheCharacterBeside) {
  // Behind the second stroke of the right one, the stroke of the left one ends where the number would stand.
  const std::vector<std::vector<RaisedStroke>> characters{
      {{{{10, 30}, {57, 30}}, LineEnd::full}},
      {{{{70, 50}, {100, 50}}, LineEnd::full}, {{{62, 30}, {100, 30}}, LineEnd::full}}};
  Plate plate = Plate::create(120, 60, 0.1, 3).value();
  EXPECT_THAT(add_strokes(plate, characters), IsEmpty());
  EXPECT_EQ(dots_in(plate, {0, 0}, {120, 60}), 1 + 1 + 2) << "1, and 1 and 2";
  RaisedStrokeSettings settings;
  settings.numbers = false;
  Plate bare = Plate::create(120, 60, 0.1, 3).value();
  EXPECT_THAT(add_strokes(bare, characters, settings), IsEmpty());
  EXPECT_EQ(dots_in(bare, {0, 0}, {120, 60}), 0);
}

TEST(RaisedStrokes, ANumberWithoutRoomIsNamed) {
  std::vector<RaisedStroke> strokes;
  for (int i = 0; i < 14; ++i) strokes.push_back({{{3, 3.0 + 4 * i}, {57, 3.0 + 4 * i}}, LineEnd::full});
  Plate plate = Plate::create(60, 60, 0.2, 3).value();
  const auto without = add_strokes(plate, strokes);
  EXPECT_GE(without.size(), 10U);
  EXPECT_TRUE(std::is_sorted(without.begin(), without.end()));
  EXPECT_EQ(dots_in(plate, {0, 0}, {60, 60}) == 0, without.size() == 14U);
}

RaisedPlot sine() {
  RaisedPlot plot;
  RaisedCurve curve;
  for (int i = 0; i <= 200; ++i) curve.line.push_back({i / 200.0, 0.5 + 0.4 * std::sin(i / 200.0 * 6.283)});
  plot.curves = {curve};
  plot.x_axis = 0.5;
  plot.y_axis = 0.25;
  plot.x_ticks = {{0, "-1"}, {0.25, "0"}, {0.5, "1"}, {1, "3"}};
  plot.y_ticks = {{0, "-1"}, {0.5, "0"}, {1, "1"}};
  return plot;
}

// The square of the plot begins here: 5 mm of edge, a label of 5 cells or one line of braille, and a gap.
constexpr double kLeft = 5 + (4 * 6 + 3.75) + 3;
constexpr double kBelow = 5 + 6.25 * 1.5 + 3;

TEST(RaisedPlot, TheCurveIsHigherThanTheAxes) {
  const Plate plate = raised_plot(sine()).value();
  EXPECT_NEAR(rise(plate, {kLeft + 0.25 * 120, kBelow + 0.9 * 120}), 1.0, 0.02);
  EXPECT_NEAR(rise(plate, {kLeft + 0.375 * 120, kBelow + 0.5 * 120}), 0.5, 0.02);
  EXPECT_NEAR(rise(plate, {kLeft + 0.25 * 120, kBelow + 0.2 * 120}), 0.5, 0.02);
  EXPECT_EQ(rise(plate, {kLeft + 0.375 * 120, kBelow + 0.3 * 120}), 0);
  // A tick across the axis.
  EXPECT_NEAR(rise(plate, {kLeft + 120, kBelow + 0.5 * 120 + 1.8}), 0.5, 0.05);
  EXPECT_EQ(rise(plate, {kLeft + 0.75 * 120, kBelow + 0.5 * 120 + 1.8}), 0);
}

TEST(RaisedPlot, LabelsStandLeftAndBelowAndLettersAtTheEnds) {
  const Plate plate = raised_plot(sine()).value();
  // -1 is 2 + 4 + 1 dots, 0 is 4 + 3, 1 is 4 + 1, 3 is 4 + 2.
  EXPECT_EQ(dots_in(plate, {0, 0}, {200, kBelow - 4.5}), 7 + 7 + 5 + 6);
  EXPECT_EQ(dots_in(plate, {0, kBelow - 4.5}, {kLeft - 2, 200}), 7 + 7 + 5);
  EXPECT_EQ(dots_in(plate, {kLeft + 122, kBelow}, {200, 200}), 4);          // x
  EXPECT_EQ(dots_in(plate, {kLeft, kBelow + 122}, {kLeft + 120, 200}), 5);  // y
}

TEST(RaisedPlot, LabelsThatWouldCoverOneAnotherAreLeftOut) {
  RaisedPlot plot = sine();
  plot.x_ticks.clear();
  for (int i = 0; i <= 40; ++i) plot.x_ticks.push_back({i / 40.0, "1"});
  const Plate plate = raised_plot(plot).value();
  const int dots = dots_in(plate, {0, 0}, {200, kBelow - 4.5});
  EXPECT_EQ(dots % 5, 0);
  EXPECT_GE(dots / 5, 6);
  EXPECT_LE(dots / 5, 10);  // 9.75 mm and a gap of 3 mm each, on 120 mm
}

TEST(RaisedPlot, ADashedCurveHasGapsAndADottedOneKnobs) {
  RaisedPlot plot;
  plot.curves = {{{{0, 0.25}, {1, 0.25}}, CurveStyle::dashed}, {{{0, 0.75}, {1, 0.75}}, CurveStyle::dotted}};
  const Plate plate = raised_plot(plot).value();
  const auto at = [&](double mm, double y) { return rise(plate, {kLeft + mm, kBelow + y * 120}); };
  EXPECT_NEAR(at(4, 0.25), 1, 0.02);
  EXPECT_EQ(at(10, 0.25), 0);
  EXPECT_NEAR(at(16, 0.25), 1, 0.02);
  EXPECT_NEAR(at(0, 0.75), 1, 0.02);
  EXPECT_EQ(at(2.25, 0.75), 0);
  EXPECT_NEAR(at(4.5, 0.75), 1, 0.02);
}

TEST(RaisedPlot, ASurfaceRisesToItsHeight) {
  const auto map = hills(65);
  RaisedPlot plot;
  plot.surface = &map;
  const Plate plate = raised_plot(plot).value();
  const float top = *std::max_element(plate.heights().begin(), plate.heights().end());
  EXPECT_NEAR(top, 3 + 20, 0.5);
  const auto made = mesh_of(plate);
  ASSERT_TRUE(made);
  EXPECT_EQ(open_edges(made->mesh), 0U);
  EXPECT_LT(made->mesh.triangles.size(), 100'000U);
}

TEST(RaisedPlot, APlateThatWouldBeTooLargeIsRefused) {
  RaisedPlotSettings settings;
  settings.side_mm = 990;
  EXPECT_FALSE(raised_plot(sine(), settings));
}

}  // namespace
}  // namespace nazori::model
