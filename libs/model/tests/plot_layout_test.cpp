// SPDX-License-Identifier: Apache-2.0
// Where the lines and labels of a plot stand, by hand.
#include "nazori/model/plot_layout.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace nazori::model {
namespace {

// The square begins behind an edge, a label of five cells or one and a half lines of braille, and a gap.
constexpr double kLeft = 5 + 27.75 + 3;
constexpr double kBottom = 5 + 1.5 * 6.25 + 3;

void expect_lines(const std::vector<PlateLine>& found, const std::vector<PlateLine>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].size(), wanted[i].size()) << i;
    for (std::size_t k = 0; k < found[i].size(); ++k) {
      EXPECT_NEAR(found[i][k].x, kLeft + wanted[i][k].x, 1e-9) << i << " " << k;
      EXPECT_NEAR(found[i][k].y, kBottom + wanted[i][k].y, 1e-9) << i << " " << k;
    }
  }
}

RaisedPlot two_ticks() {
  RaisedPlot plot;
  plot.x_ticks = {{0.25, "2"}};
  plot.y_ticks = {{0.75, "3"}};
  return plot;
}

TEST(PlotLayout, AxesCrossTheSquareAndTicksCrossThemAndBeginAtItsSides) {
  RaisedPlot plot = two_ticks();
  plot.x_axis = 0.5;
  plot.y_axis = 0.1;
  expect_lines(plot_layout(plot, 100).axes, {{{0, 50}, {100, 50}},
                                             {{10, 0}, {10, 100}},
                                             {{25, 48}, {25, 52}},
                                             {{25, 0}, {25, 2}},
                                             {{8, 75}, {12, 75}},
                                             {{0, 75}, {2, 75}}});
  expect_lines(plot_layout(plot, 100, {5, 3, 6}).axes, {{{0, 50}, {100, 50}},
                                                        {{10, 0}, {10, 100}},
                                                        {{25, 47}, {25, 53}},
                                                        {{25, 0}, {25, 3}},
                                                        {{7, 75}, {13, 75}},
                                                        {{0, 75}, {3, 75}}});
}

TEST(PlotLayout, WithoutAxesThereAreOnlyTheTicksAtTheSidesAndForASurfaceNone) {
  RaisedPlot plot = two_ticks();
  expect_lines(plot_layout(plot, 50).axes, {{{12.5, 0}, {12.5, 2}}, {{0, 37.5}, {2, 37.5}}});
  const auto map = surface::HeightMap::create(3).value();
  plot.surface = &map;
  EXPECT_TRUE(plot_layout(plot, 50).axes.empty());
  EXPECT_EQ(plot_layout(plot, 50).labels.size(), 4U);
}

TEST(PlotLayout, HasRoomForLabelsBeforeAndLettersBehindTheSquare) {
  const PlotLayout layout = plot_layout(two_ticks(), 100);
  EXPECT_NEAR(layout.lower_left.x, kLeft, 1e-12);
  EXPECT_NEAR(layout.lower_left.y, kBottom, 1e-12);
  EXPECT_EQ(layout.side_mm, 100);
  EXPECT_NEAR(layout.width_mm, kLeft + 100 + 14.25, 1e-9);
  EXPECT_NEAR(layout.height_mm, kBottom + 100 + 14.25, 1e-9);
}

TEST(PlotLayout, LabelsStandInTheMiddleOfTheirTicksAndLettersAtTheEndsOfTheAxes) {
  for (const bool axes : {true, false}) {
    RaisedPlot plot = two_ticks();
    if (axes) {
      plot.x_axis = 0.5;
      plot.y_axis = 0.1;
    }
    const auto labels = plot_layout(plot, 100).labels;
    // A digit and its sign are 9.75 mm wide and 6.25 mm high, a letter is 3.75 mm wide.
    const std::vector<std::pair<std::string, PlatePoint>> wanted{
        {"2", {kLeft + 25 - 4.875, 5}},
        {"3", {kLeft - 3 - 9.75, kBottom + 75 - 3.125}},
        {"x", {kLeft + 103, kBottom + (axes ? 50 : 0) - 3.125}},
        {"y", {kLeft + (axes ? 10 : 0) - 1.875, kBottom + 103}}};
    ASSERT_EQ(labels.size(), wanted.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
      EXPECT_EQ(labels[i].cells, *braille_cells(wanted[i].first)) << i;
      EXPECT_NEAR(labels[i].lower_left.x, wanted[i].second.x, 1e-9) << i;
      EXPECT_NEAR(labels[i].lower_left.y, wanted[i].second.y, 1e-9) << i;
    }
  }
}

TEST(PlotLayout, ALabelKeepsItsGapFromOthersAndStaysOnThePlate) {
  const auto shown = [](double first, double second) {
    RaisedPlot plot;
    plot.x_ticks = {{first, "1"}, {second, "2"}};
    return plot_layout(plot, 100).labels.size() - 2;
  };
  EXPECT_EQ(shown(0.2, 0.2 + 0.1276), 2U) << "9.75 mm wide and 3 mm apart";
  EXPECT_EQ(shown(0.2, 0.2 + 0.1274), 1U);
  RaisedPlot low;
  low.y_ticks = {{0, "1"}};
  EXPECT_EQ(plot_layout(low, 100).labels.size(), 3U);
  low.y_ticks = {{1.2, "1"}};  // beyond the upper edge
  EXPECT_EQ(plot_layout(low, 100).labels.size(), 2U);
  low.y_ticks = {{-0.2, "1"}};
  EXPECT_EQ(plot_layout(low, 100).labels.size(), 2U);
  low.y_ticks.clear();
  low.x_ticks = {{1.2, "1"}};
  EXPECT_EQ(plot_layout(low, 100).labels.size(), 2U);
  low.x_ticks = {{-0.4, "1"}};
  EXPECT_EQ(plot_layout(low, 100).labels.size(), 2U);
}

TEST(PlotLayout, ADashIsEightMillimetresOfTwelveRoundCorners) {
  RaisedPlot plot;
  plot.curves = {{{{0, 0}, {0.05, 0}, {0.05, 0.2}}, CurveStyle::dashed}};
  expect_lines(plot_layout(plot, 100).curves,
               {{{0, 0}, {5, 0}, {5, 3}}, {{5, 7}, {5, 15}}, {{5, 19}, {5, 20}}});
  plot.curves = {{{{0, 0}, {0.05, 0}, {0.05, 0.2}}, CurveStyle::solid}};
  expect_lines(plot_layout(plot, 100).curves, {{{0, 0}, {5, 0}, {5, 20}}});
  plot.curves = {{{{0.1, 0.1}}, CurveStyle::dashed}};
  expect_lines(plot_layout(plot, 100).curves, {{{10, 10}}});
}

TEST(PlotLayout, DotsStandFourAndAHalfMillimetresApart) {
  RaisedPlot plot;
  plot.curves = {{{{0, 0}, {0.05, 0}, {0.05, 0.085}}, CurveStyle::dotted}};
  expect_lines(plot_layout(plot, 100).curves, {{{0, 0}}, {{4.5, 0}}, {{5, 4}}, {{5, 8.5}}});
}

TEST(PlotLayout, ALabelHasSixCellsAtMost) {
  EXPECT_EQ(cells_of({0, "-10.5"}).size(), 6U);
  EXPECT_TRUE(cells_of({0, "-100.5"}).empty());
  EXPECT_TRUE(cells_of({0, "?"}).empty());
}

}  // namespace
}  // namespace nazori::model
