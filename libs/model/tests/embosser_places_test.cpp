// SPDX-License-Identifier: Apache-2.0
// Where an embosser's page has its dots and numbers, against their definition.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "nazori/model/embosser.h"

namespace nazori::model {
namespace {

constexpr EmbossedMarks kPlain{false, false};

TEST(EmbosserPlaces, ASweepLosesThreeDotsAtItsEndButNoneOfItsFirstThreeFifths) {
  for (int count = 1; count <= 22; ++count) {
    // From the first dot to the last of 24 in a row, on 68.5 mm.
    const RaisedStroke bar{{{0, 0.5}, {dot_x_mm(count - 1) / 68.5, 0.5}}, LineEnd::sinks};
    const auto made = embossed({&bar, 1}, {}, kPlain, {12, 12});
    ASSERT_TRUE(made);
    for (int i = 0; i < 24; ++i) {
      const int to_end = count - 1 - i;
      const bool gap = (to_end == 1 || to_end == 3 || to_end == 5) && i >= count * 60 / 100;
      int dots = 0;
      for (int line = 0; line < 12; ++line)
        for (int row = 0; row < 3; ++row) dots += made->page.at(i / 2, line) >> (i % 2 * 3 + row) & 1;
      EXPECT_EQ(dots, i < count && !gap ? 1 : 0) << i << " of " << count;
    }
  }
}

struct Place {
  int column;
  int line;
};

/// Whether cells have nothing around them on the page of a character, as it is without their number.
bool is_free(const EmbosserPage& page, Place place, int cells, int lines) {
  for (int line = place.line - 1; line <= place.line + 1; ++line)
    for (int column = place.column - 1; column <= place.column + cells; ++column)
      if (column >= 0 && line >= 0 && column < page.columns() && line < lines && page.at(column, line) != 0)
        return false;
  return place.column >= 0 && place.line >= 0 && place.column + cells <= page.columns() && place.line < lines;
}

/// The least distance of the middle of free cells from a start, three cells and lines away at most.
std::optional<double> nearest(const EmbosserPage& page, Place start, int cells, int lines) {
  std::optional<double> least;
  for (int line = start.line - 3; line <= start.line + 3; ++line)
    for (int first = start.column - 3 - (cells - 1); first <= start.column + 3; ++first)
      if (is_free(page, {first, line}, cells, lines)) {
        const double away =
            std::hypot((first + (cells - 1) / 2.0 - start.column) * 6, (line - start.line) * 10.0);
        least = std::min(least.value_or(away), away);
      }
  return least;
}

TEST(EmbosserPlaces, ANumberHasTheNearestFreePlaceOrIsNamed) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  int placed = 0, named = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<RaisedStroke> strokes;
    const int count = 1 + round % 14;
    for (int i = 0; i < count; ++i)
      strokes.push_back({{{any(random), any(random)}, {any(random), any(random)}}, LineEnd::full});
    const EmbosserPaper paper{14 + round % 20, 12 + round % 9};
    const auto plain = embossed(strokes, {}, {false, true}, paper);
    const auto made = embossed(strokes, {}, {true, true}, paper);
    ASSERT_TRUE(plain && made);
    // The page is built up number by number.
    EmbosserPage page = plain->page;
    const double width = 6.0 * (paper.columns - 1) + 2.5, height = 10.0 * (paper.lines - 1) + 5;
    const double side = std::min(width, height);
    const double left = std::floor((width - side) / 2 / 6) * 6;
    for (int i = 0; i < count; ++i) {
      const PlatePoint at = strokes[static_cast<std::size_t>(i)].line.front();
      // The cell of the dot nearest to the start.
      Place start{0, 0};
      double least = 1e9;
      for (int row = 0; row < 3 * paper.lines; ++row)
        for (int column = 0; column < 2 * paper.columns; ++column) {
          const double away =
              std::hypot(dot_x_mm(column) - left - at.x * side, dot_y_mm(row) - (1 - at.y) * side);
          if (away < least - 1e-9) {
            least = away;
            start = {column / 2, row / 3};
          }
        }
      std::vector<BrailleCell> cells = *braille_cells(std::to_string(i + 1));
      cells.erase(cells.begin());
      const int width_cells = static_cast<int>(cells.size());
      const auto away = nearest(page, start, width_cells, paper.lines);
      const bool is_named = std::count(made->without_number.begin(), made->without_number.end(), i + 1) == 1;
      ASSERT_EQ(is_named, !away) << i + 1;
      if (!away) {
        ++named;
        continue;
      }
      // One of the places that are as near has the number.
      bool found = false;
      for (int line = start.line - 3; line <= start.line + 3 && !found; ++line)
        for (int first = start.column - 4; first <= start.column + 3 && !found; ++first) {
          const Place place{first, line};
          if (!is_free(page, place, width_cells, paper.lines)) continue;
          const double own =
              std::hypot((first + (width_cells - 1) / 2.0 - start.column) * 6, (line - start.line) * 10.0);
          if (own > *away + 1e-9) continue;
          found = true;
          for (int k = 0; k < width_cells; ++k)
            found = found && made->page.at(first + k, line) == cells[static_cast<std::size_t>(k)];
          for (int k = 0; found && k < width_cells; ++k)
            page.set(first + k, line, cells[static_cast<std::size_t>(k)]);
        }
      ASSERT_TRUE(found) << i + 1;
      ++placed;
    }
    for (int line = 0; line < paper.lines; ++line)
      for (int column = 0; column < paper.columns; ++column)
        ASSERT_EQ(made->page.at(column, line), page.at(column, line)) << column << " " << line;
  }
  EXPECT_GT(placed, 200);
  EXPECT_GT(named, 5);
}

TEST(EmbosserPlaces, ACharacterStandsInTheMiddleOfAWidePageAndAtTheTopOfAHighOne) {
  const RaisedStroke diagonal{{{0, 1}, {1, 0}}, LineEnd::full};
  // 12 lines are 115 mm high, 40 cells 236.5 mm wide: left of it there are 60.75 mm, ten cells.
  const auto wide = embossed({&diagonal, 1}, {}, kPlain, {40, 12});
  ASSERT_TRUE(wide);
  EXPECT_EQ(wide->page.at(10, 0) & 1, 1);
  EXPECT_EQ(wide->page.at(29, 11) & 4, 4) << "the dot nearest to 175 mm, in the lowest row";
  const auto high = embossed({&diagonal, 1}, {}, kPlain, {12, 40});
  ASSERT_TRUE(high);
  EXPECT_EQ(high->page.at(0, 0) & 1, 1);
  EXPECT_NE(high->page.at(11, 6), 0);
}

TEST(EmbosserPlaces, ASideThatIsExactlyLargeEnoughIsTakenForAPlot) {
  // Two cells before the square and two behind it; 7 cells are 38.5 mm wide and 8 are 44.5 mm.
  EXPECT_FALSE(embossed_plot({}, {}, {9, 25}));
  for (int columns = 12; columns <= 16; ++columns)
    for (int lines = 12; lines <= 14; ++lines) {
      RaisedPlot plot;
      plot.y_ticks = {{0.5, "1"}};  // two cells and an empty one
      const auto made = embossed_plot(plot, {}, {columns, lines});
      const double wide = (columns - 5 - 1) * 6 + 2.5, high = (lines - 2 - 1) * 10 + 5;
      EXPECT_EQ(made.has_value(), std::min(wide, high) >= 40) << columns << " " << lines;
      if (!made) {
        EXPECT_EQ(made.error().what, std::to_string(lines) + " lines of " + std::to_string(columns) +
                                         " cells are too few for a plot");
      }
    }
}

}  // namespace
}  // namespace nazori::model
