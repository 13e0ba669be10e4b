// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "nazori/model/embosser.h"
#include "nazori/model/plot_layout.h"
#include "test_plates.h"

namespace nazori::model {
namespace {

using testing::Contains;
using testing::ElementsAre;

/// The dots of a page as text: o is a dot, two columns for each cell and three rows for each line.
std::string drawn(const EmbosserPage& page) {
  std::string text;
  for (int row = 0; row < 3 * page.lines(); ++row) {
    std::string line;
    for (int column = 0; column < 2 * page.columns(); ++column)
      line += (page.at(column / 2, row / 3) >> (column % 2 * 3 + row % 3) & 1) != 0 ? 'o' : '.';
    line.erase(line.find_last_not_of('.') + 1);
    text += line + '\n';
  }
  text.erase(text.find_last_not_of('\n') + 1);
  const std::size_t empty = text.find_first_not_of('\n');
  return std::to_string(empty) + " empty rows\n" + text.substr(empty);
}

std::string plot_page(const RaisedPlot& plot, const EmbosserPaper& paper = {15, 12}) {
  const auto made = embossed_plot(plot, {}, paper);
  return made ? drawn(*made) : base::to_line(made.error());
}

RaisedPlot axes() {
  RaisedPlot plot;
  plot.x_axis = 0.5;
  plot.y_axis = 0.5;
  plot.x_ticks = {{0, "-1"}, {0.5, "0"}, {1, "1"}};
  plot.y_ticks = {{0, "-1"}, {0.5, "0"}, {1, "1"}};
  return plot;
}

TEST(EmbossedPlot, AxesHaveEverySecondDotTicksAndNumbers) {
  EXPECT_EQ(plot_page(axes()),
            "12 empty rows\n"
            "................oo\n"
            ".................o\n"
            "................oo\n"
            "...oo\n"
            "...o\n"
            "..oo....oo.....ooo\n"
            "................o\n"
            "\n"
            "................o\n"
            "\n"
            "................o\n"
            "........o.......o........o\n"
            "...o.o..ooo.o.ooooo.o.o.oo..oo\n"
            "...ooo..o.......o........o\n"
            "..oo............o...........oo\n"
            "\n"
            "................o\n"
            "\n"
            "...oo...........o\n"
            "...o....o.......o........o\n"
            "oooo....oo.....ooo.......o\n"
            ".........oo....o.o.......oo\n"
            ".........o.....ooo.......o\n"
            "......oooo....oo........oo");
}

TEST(EmbossedPlot, ACurveIsWholeAndAxesKeepClearOfIt) {
  RaisedPlot plot = axes();
  plot.curves = {{{{0, 0}, {1, 1}}, CurveStyle::solid}};
  EXPECT_EQ(plot_page(plot),
            "12 empty rows\n"
            "................oo\n"
            ".................o\n"
            "................oo\n"
            "...oo\n"
            "...o\n"
            "..oo....oo.....ooo......oo\n"
            "................o......o\n"
            "......................o\n"
            "................o....o\n"
            "....................o\n"
            "...................o\n"
            "........o........oo......o\n"
            "...o.o..ooo.o...o...o.o.oo..oo\n"
            "...ooo..o......o.........o\n"
            "..oo..........o.............oo\n"
            ".............o\n"
            "............o...o\n"
            "...........o\n"
            "...oo.....o.....o\n"
            "...o.....o......o........o\n"
            "oooo....o......ooo.......o\n"
            ".........oo....o.o.......oo\n"
            ".........o.....ooo.......o\n"
            "......oooo....oo........oo");
}

TEST(EmbossedPlot, CurvesAreToldApartByTheirGaps) {
  RaisedPlot plot;
  plot.curves = {{{{0, 1}, {1, 1}}, CurveStyle::solid},
                 {{{0, 0.5}, {1, 0.5}}, CurveStyle::dashed},
                 {{{0, 0}, {1, 0}}, CurveStyle::dotted}};
  EXPECT_EQ(plot_page(plot),
            "6 empty rows\n"
            "..oo\n"
            "...o\n"
            "..oo\n"
            "\n"
            "\n"
            "..oooooooooooooooooooooooo\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "..oooo..oooo..oooo..oooo\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "\n"
            "............................oo\n"
            "\n"
            "..o..o..o..o..o..o..o..o....oo");
}

TEST(EmbossedPlot, TheExpressionStandsBelowAfterAnEmptyLine) {
  const std::vector<std::vector<BrailleCell>> text{{1, 2, 3}, {4}};
  const auto made = embossed_plot(axes(), text, {20, 20});
  ASSERT_TRUE(made);
  const auto cells = [&](int line) {
    std::vector<int> found;
    for (int column = 0; column < 20; ++column) found.push_back(made->at(column, line));
    return found;
  };
  const auto begins_with = [](const std::vector<int>& line, std::vector<int> first) {
    first.resize(line.size());
    return line == first;
  };
  EXPECT_TRUE(begins_with(cells(18), {1, 2, 3}));
  EXPECT_TRUE(begins_with(cells(19), {4}));
  EXPECT_TRUE(begins_with(cells(17), {}));
  EXPECT_THAT(cells(16), Contains(braille_cells("1")->front()));  // the numbers of the x axis
}

TEST(EmbossedPlot, NumbersThatWouldTouchAreLeftOutAndTheEndsStay) {
  RaisedPlot plot = axes();
  plot.x_ticks.clear();
  for (int i = 0; i <= 40; ++i) plot.x_ticks.push_back({i / 40.0, i == 0 ? "3" : i == 40 ? "4" : "1"});
  const auto made = embossed_plot(plot, {}, {40, 25});
  ASSERT_TRUE(made);
  std::vector<int> line;
  for (int column = 0; column < 40; ++column) line.push_back(made->at(column, 24));
  const int sign = braille_cells("1")->front();
  int numbers = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != sign) continue;
    ++numbers;
    EXPECT_EQ(i > 0 ? line[i - 1] : 0, 0);
    EXPECT_EQ(i + 2 < line.size() ? line[i + 2] : 0, 0);
  }
  EXPECT_GE(numbers, 8);
  EXPECT_THAT(line, Contains(braille_cells("c")->front()));
  EXPECT_THAT(line, Contains(braille_cells("d")->front()));
}

TEST(EmbossedPlot, WhatCannotBeEmbossedIsRefused) {
  EXPECT_FALSE(embossed_plot(axes(), {}, {11, 25}));
  EXPECT_FALSE(embossed_plot(axes(), {}, {40, 101}));
  EXPECT_FALSE(embossed_plot(axes(), {}, {12, 25}));  // 6 cells are 32.5 mm wide
  EXPECT_TRUE(embossed_plot(axes(), {}, {14, 12}));   // 8 cells are 44.5 mm wide
  const auto map = hills(65);
  RaisedPlot surface = axes();
  surface.surface = &map;
  EXPECT_FALSE(embossed_plot(surface, {}));
}

TEST(EmbossedPlot, ANumberThatIsTooLongIsLeftOut) {
  RaisedPlot plot = axes();
  plot.y_ticks = {{0, "-100.25"}, {1, "1"}};
  RaisedPlot without = plot;
  without.y_ticks = {{0, "a?"}, {1, "1"}};  // no cells at all
  EXPECT_EQ(plot_page(plot), plot_page(without));
}

TEST(PlotLayout, WiderGapsMoveTheLabelsAwayFromTheSquare) {
  const auto near = plot_layout(axes(), 100, {0, 3, 4});
  const auto far = plot_layout(axes(), 100, {0, 6.4, 4});
  EXPECT_NEAR(far.lower_left.x - near.lower_left.x, 3.4, 1e-9);
  EXPECT_NEAR(far.width_mm - near.width_mm, 6.8, 1e-9);
  ASSERT_EQ(far.labels.size(), near.labels.size());
  for (const PlacedBraille& label : far.labels) {
    const double right = label.lower_left.x + braille_width_mm(label.cells.size());
    const double top = label.lower_left.y + braille_height_mm();
    const bool is_clear = right <= far.lower_left.x - 6.4 + 1e-9 || top <= far.lower_left.y - 6.4 + 1e-9 ||
                          label.lower_left.x >= far.lower_left.x + 100 + 6.4 - 1e-9 ||
                          label.lower_left.y >= far.lower_left.y + 100 + 6.4 - 1e-9;
    EXPECT_TRUE(is_clear);
  }
}

TEST(PlotLayout, ZeroAndTheEndsGetTheirPlacesFirst) {
  const std::vector<RaisedTick> ticks{{0, "-2"}, {0.25, "-1"}, {0.5, "0"}, {0.75, "1"}, {1, "2"}};
  EXPECT_THAT(label_order(ticks), ElementsAre(2, 0, 4, 1, 3));
  EXPECT_THAT(label_order({}), testing::IsEmpty());
}

}  // namespace
}  // namespace nazori::model
