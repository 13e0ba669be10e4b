// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/embosser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace nazori::model {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Raised {
  double x;
  double y;
  int column;
  int row;
};

/// The dots of a part of a page and where they are: in-cell distances of 2.5 mm, cells 6 mm, lines 10 mm.
std::vector<Raised> raised(const EmbosserPage& page, int from_line, int to_line) {
  std::vector<Raised> dots;
  for (int line = from_line; line < to_line; ++line)
    for (int column = 0; column < page.columns(); ++column)
      for (int bit = 0; bit < 6; ++bit)
        if ((page.at(column, line) >> bit & 1) != 0)
          dots.push_back({column * 6.0 + bit / 3 * 2.5, line * 10.0 + bit % 3 * 2.5, 2 * column + bit / 3,
                          3 * line + bit % 3});
  return dots;
}

constexpr EmbossedMarks kPlain{false, false};

RaisedStroke stroke(PlateLine line) { return {std::move(line), LineEnd::full}; }

TEST(Embosser, DotsFollowAStrokeWithoutGapsOrDoubling) {
  const RaisedStroke diagonal = stroke({{0.1, 0.9}, {0.8, 0.15}});
  const auto made = embossed({&diagonal, 1}, {}, kPlain);
  ASSERT_TRUE(made);
  const auto dots = raised(made->page, 0, 25);
  // The page is 236.5 mm wide and 245 mm high from its first to its last dot.
  const double side = 236.5;
  ASSERT_GT(dots.size(), 40U);
  for (const Raised& dot : dots) {
    // Half of the widest gaps, 3.5 mm across and 5 mm down, is 3.05 mm.
    // Distance from the line through (0.1, 0.1) and (0.8, 0.85), y down.
    const double away =
        std::abs((dot.x / side - 0.1) * 0.75 - (dot.y / side - 0.1) * 0.7) / std::hypot(0.75, 0.7);
    EXPECT_LE(away * side, 3.06) << dot.x << ' ' << dot.y;
    int beside = 0;
    for (const Raised& other : dots)
      beside += std::max(std::abs(other.column - dot.column), std::abs(other.row - dot.row)) == 1 ? 1 : 0;
    EXPECT_GE(beside, 1);
    EXPECT_LE(beside, 2) << "an inner dot of a step at " << dot.x << ' ' << dot.y;
  }
}

TEST(Embosser, AHorizontalStrokeIsOneRowOfDots) {
  const RaisedStroke bar = stroke({{0.2, 0.5}, {0.8, 0.5}});
  const auto made = embossed({&bar, 1}, {}, kPlain);
  ASSERT_TRUE(made);
  const auto dots = raised(made->page, 0, 25);
  // 0.6 of 236.5 mm have a dot twice every 6 mm.
  EXPECT_NEAR(static_cast<double>(dots.size()), 0.6 * 236.5 / 3, 2);
  for (const Raised& dot : dots) EXPECT_NEAR(dot.y, 118.25, 2.5);
}

TEST(Embosser, ANumberStandsBesideItsStartWithNothingAroundIt) {
  const std::vector<RaisedStroke> strokes{stroke({{0.2, 0.8}, {0.8, 0.8}}),
                                          stroke({{0.5, 0.95}, {0.5, 0.1}})};
  const auto plain = embossed(strokes, {}, kPlain);
  const auto made = embossed(strokes, {}, {true, false});
  ASSERT_TRUE(plain);
  ASSERT_TRUE(made);
  EXPECT_THAT(made->without_number, IsEmpty());
  std::vector<std::pair<int, int>> places;
  std::vector<int> cells;
  for (int line = 0; line < 25; ++line)
    for (int column = 0; column < 40; ++column) {
      if (made->page.at(column, line) == plain->page.at(column, line)) continue;
      places.emplace_back(column, line);
      cells.push_back(made->page.at(column, line));
      for (int y = std::max(0, line - 1); y <= std::min(24, line + 1); ++y)
        for (int x = std::max(0, column - 1); x <= std::min(39, column + 1); ++x)
          EXPECT_EQ(plain->page.at(x, y), 0);
    }
  EXPECT_THAT(cells, testing::UnorderedElementsAre(1, 3));  // 1 and 2
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double x = cells[i] == 1 ? 0.2 * 236.5 : 0.5 * 236.5;
    const double y = (cells[i] == 1 ? 0.2 : 0.05) * 236.5;
    EXPECT_LE(std::hypot(places[i].first * 6 - x, places[i].second * 10 - y), 25);
  }
}

/// A page of 12 lines of 12 cells with one stroke from left to right, 62.5 mm of 68.5 mm long, in ASCII
/// braille.
std::string bar(LineEnd end, const EmbossedMarks& marks) {
  const RaisedStroke one{{{0, 0.5}, {62.5 / 68.5, 0.5}}, end};
  const auto made = embossed({&one, 1}, {}, marks, {12, 12});
  return made ? to_brf({&made->page, 1}) : base::to_line(made.error());
}

// In ASCII braille - is dots 3 and 6, a comma is dot 6, = is the full cell.
TEST(Embosser, AStopHasNoGapsAndASweepIsSparseAtItsEnd) {
  const std::string above = "\r\n\r\n\r\n";
  EXPECT_EQ(bar(LineEnd::full, kPlain), above + "-----------\r\n\f");
  // Of 22 dots the second, the fourth and the sixth from the end are left out.
  EXPECT_EQ(bar(LineEnd::sinks, kPlain), above + "--------,,,\r\n\f");
}

TEST(Embosser, AStartIsAFullCell) {
  EXPECT_EQ(bar(LineEnd::full, {false, true}), "\r\n\r\n\r\n=----------\r\n\f");
}

TEST(Embosser, AShortSweepKeepsItsFirstPartAndItsLastDot) {
  // Two cells, four dots: only the last dot but one is left out.
  const RaisedStroke one{{{0, 0.5}, {8.5 / 68.5, 0.5}}, LineEnd::sinks};
  const auto made = embossed({&one, 1}, {}, kPlain, {12, 12});
  EXPECT_EQ(to_brf({&made->page, 1}), "\r\n\r\n\r\n-,\r\n\f");
}

TEST(Embosser, ANumberStandsClearOfFullCells) {
  const RaisedStroke one{{{0.5, 0.5}, {0.5, 0}}, LineEnd::full};
  const auto made = embossed({&one, 1}, {}, {}, {12, 12});
  int full_column = 0;
  int number_column = 0;
  for (int line = 0; line < 12; ++line)
    for (int column = 0; column < 12; ++column) {
      if (made->page.at(column, line) == 0b111111) full_column = column;
      if (made->page.at(column, line) == 1 && line < 6) number_column = column;
    }
  EXPECT_GE(std::abs(number_column - full_column), 2);
}

TEST(Embosser, WhereThereIsNoRoomTheNumberIsNamed) {
  std::vector<RaisedStroke> bars;
  for (int i = 0; i < 12; ++i) bars.push_back(stroke({{0, 0.04 + 0.08 * i}, {1, 0.04 + 0.08 * i}}));
  const auto made = embossed(bars, {});
  ASSERT_TRUE(made);
  EXPECT_GE(made->without_number.size(), 8U);
  EXPECT_THAT(made->without_number, testing::Contains(6));
}

TEST(Embosser, TextStandsBelowTheCharacterAndIsBrokenAtBlanks) {
  const RaisedStroke bar = stroke({{0, 0}, {1, 0}});
  std::vector<BrailleCell> words;
  for (int word = 0; word < 9; ++word) {
    words.insert(words.end(), 5, BrailleCell{1});
    words.push_back(0);
  }
  const std::vector<std::vector<BrailleCell>> text{words, {3}};
  const auto made = embossed({&bar, 1}, text, kPlain);
  ASSERT_TRUE(made);
  // Three lines of text and an empty one: 21 for the character.
  EXPECT_THAT(raised(made->page, 21, 22), IsEmpty());
  EXPECT_FALSE(raised(made->page, 20, 21).empty());
  EXPECT_EQ(made->page.at(0, 22), 1);
  EXPECT_EQ(made->page.at(34, 22), 1);
  EXPECT_EQ(made->page.at(36, 22), 0);  // a sixth word would not fit whole
  EXPECT_EQ(made->page.at(0, 23), 1);
  EXPECT_EQ(made->page.at(0, 24), 3);
}

TEST(Embosser, AFileHasAsciiBrailleLinesAndPages) {
  EmbosserPage page({12, 12});
  page.set(0, 0, 1);
  page.set(2, 0, 0b111111);
  page.set(1, 2, 0b111100);  // the sign for numbers
  const std::vector<EmbosserPage> pages{page, EmbosserPage({12, 12})};
  EXPECT_EQ(to_brf(pages), "A =\r\n\r\n #\r\n\f\f");
  // The letters of the alphabet are themselves.
  EmbosserPage letters({40, 12});
  const auto cells = braille_cells("abcdefghijklmnopqrstuvwxyz");
  for (std::size_t i = 0; i < cells->size(); ++i) letters.set(static_cast<int>(i), 0, (*cells)[i]);
  EXPECT_EQ(to_brf({&letters, 1}), "ABCDEFGHIJKLMNOPQRSTUVWXYZ\r\n\f");
  // @source North American ASCII braille, U+2800 and following.
  EmbosserPage all({64, 12});
  for (int i = 0; i < 64; ++i) all.set(i, 0, static_cast<BrailleCell>(i));
  EXPECT_EQ(to_brf({&all, 1}), " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)=\r\n\f");
}

TEST(Embosser, DotsHaveTheirDistances) {
  const auto x = [](int i) { return dot_x_mm(i); };
  const auto y = [](int i) { return dot_y_mm(i); };
  EXPECT_THAT((std::vector{x(0), x(1), x(2), x(3)}), ElementsAre(0, 2.5, 6, 8.5));
  EXPECT_THAT((std::vector{y(0), y(1), y(2), y(3)}), ElementsAre(0, 2.5, 5, 10));
}

TEST(Embosser, WhatCannotBeEmbossedIsRefused) {
  const RaisedStroke bar = stroke({{0, 0}, {1, 0}});
  EXPECT_FALSE(embossed({}, {}));
  EXPECT_FALSE(embossed({&bar, 1}, {}, {}, {11, 25}));
  EXPECT_FALSE(embossed({&bar, 1}, {}, {}, {40, 101}));
  EXPECT_TRUE(embossed({&bar, 1}, {}, {}, {12, 12}));
  // A point beyond the square stays on the page.
  const RaisedStroke beyond = stroke({{-1, 2}, {3, -1}});
  EXPECT_TRUE(embossed({&beyond, 1}, {}, {}, {12, 100}));
}

}  // namespace
}  // namespace nazori::model
