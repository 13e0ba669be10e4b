// SPDX-License-Identifier: Apache-2.0
#include "../src/embossed_dots.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "nazori/model/embosser.h"

namespace nazori::model {
namespace {

using Cells = std::vector<BrailleCell>;
using Lines = std::vector<Cells>;

TEST(EmbossedDots, TheNearestDotIsTheOneOnThisSideOfTheMiddle) {
  // Columns at 0, 2.5, 6 and 8.5 mm, rows at 0, 2.5, 5 and 10 mm.
  for (const auto& [x, column] :
       {std::pair{-7.0, 0}, {1.2, 0}, {1.3, 1}, {4.2, 1}, {4.3, 2}, {7.2, 2}, {7.3, 3}, {60.1, 20}})
    EXPECT_EQ(nearest_dot(x, 0).column, column) << x;
  for (const auto& [y, row] :
       {std::pair{-7.0, 0}, {1.2, 0}, {1.3, 1}, {3.7, 1}, {3.8, 2}, {7.4, 2}, {7.6, 3}, {101.3, 31}})
    EXPECT_EQ(nearest_dot(0, y).row, row) << y;
}

TEST(EmbossedDots, EachDotOfACellIsItsBit) {
  EmbosserPage page({12, 12});
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 2; ++column) {
      const Dot dot{2 * 7 + column, 3 * 5 + row};
      EXPECT_FALSE(has_dot(page, dot));
      const BrailleCell before = page.at(7, 5);
      set_dot(page, dot);
      EXPECT_TRUE(has_dot(page, dot));
      EXPECT_EQ(page.at(7, 5), before | 1 << (3 * column + row));
    }
  EXPECT_EQ(page.at(7, 5), 63);
}

TEST(EmbossedDots, ALineIsAChainWithoutCorners) {
  const auto dots = dots_along({{0, 0}, {8.5, 0}, {8.5, 5}});
  EXPECT_EQ(dots, (std::vector<Dot>{{0, 0}, {1, 0}, {2, 0}, {3, 1}, {3, 2}}))
      << "the dot at the corner is between two that touch already";
  EXPECT_EQ(dots_along({{6, 10}}), (std::vector<Dot>{{2, 3}}));
}

TEST(EmbossedText, IsBrokenAtItsLastBlankThatFits) {
  EXPECT_EQ(wrapped(std::vector<Cells>{{1, 1, 0, 2, 2, 2}}, 4), (Lines{{1, 1}, {2, 2, 2}}));
  EXPECT_EQ(wrapped(std::vector<Cells>{{1, 0, 2, 0, 3}}, 4), (Lines{{1, 0, 2}, {3}}));
  EXPECT_EQ(wrapped(std::vector<Cells>{{1, 1, 1, 0, 0, 2}}, 3), (Lines{{1, 1, 1}, {2}}));
  EXPECT_EQ(wrapped(std::vector<Cells>{{1, 1, 1, 1, 1}}, 3), (Lines{{1, 1, 1}, {1, 1}}))
      << "a word that is longer than a line";
  EXPECT_EQ(wrapped(std::vector<Cells>{{1, 2, 3}}, 3), (Lines{{1, 2, 3}}));
  EXPECT_EQ(wrapped(std::vector<Cells>{{}, {4}}, 3), (Lines{{}, {4}}));
}

TEST(EmbossedText, StandsInItsLinesFromTheLeft) {
  EmbosserPage page({12, 12});
  put_text(page, Lines{{1, 2}, {}, {3}}, 9);
  EXPECT_EQ(page.at(0, 9), 1);
  EXPECT_EQ(page.at(1, 9), 2);
  EXPECT_EQ(page.at(0, 10), 0);
  EXPECT_EQ(page.at(0, 11), 3);
}

TEST(EmbosserPaper, HasTwelveToAHundredOfEach) {
  for (const int fine : {12, 100}) {
    EXPECT_TRUE(check_paper({fine, 25}));
    EXPECT_TRUE(check_paper({40, fine}));
  }
  for (const int wrong : {11, 101}) {
    EXPECT_FALSE(check_paper({wrong, 25}));
    EXPECT_FALSE(check_paper({40, wrong}));
  }
  EXPECT_EQ(check_paper({11, 25}).error().what, "a page cannot have 25 lines of 11 cells");
}

TEST(Embosser, ANumberStandsTwoCellsBesideItsStart) {
  const std::vector<RaisedStroke> strokes{{{{0.5, 0.5}, {0.5, 0}}, LineEnd::full}};
  const auto made = embossed(strokes, {}, {}, {12, 12});
  ASSERT_TRUE(made);
  // The middle of 68.5 mm is in the sixth cell of the fourth line. The stroke goes down from there.
  EXPECT_EQ(made->page.at(5, 3), 63);
  EXPECT_EQ(made->page.at(3, 3), 1);
  int others = 0;
  for (int line = 0; line < 12; ++line)
    for (int column = 0; column < 12; ++column)
      if (column != 5 && made->page.at(column, line) != 0) ++others;
  EXPECT_EQ(others, 1);
}

TEST(Embosser, TextHasHalfOfThePageAtMostAndPlotsLeaveItAQuarter) {
  Lines text;
  for (int i = 0; i < 20; ++i) text.push_back({static_cast<BrailleCell>(i + 1)});
  const std::vector<RaisedStroke> strokes{{{{0, 0}, {1, 0}}, LineEnd::full}};
  const auto made = embossed(strokes, text, {false, false}, {12, 12});
  ASSERT_TRUE(made);
  for (int line = 0; line < 6; ++line) EXPECT_EQ(made->page.at(0, 6 + line), line + 1);
  EXPECT_NE(made->page.at(1, 4), 0) << "the stroke is in the fifth line";
  EXPECT_EQ(made->page.at(1, 5), 0);
  const auto plot = embossed_plot({}, text, {20, 20});
  ASSERT_TRUE(plot);
  for (int line = 0; line < 5; ++line) EXPECT_EQ(plot->at(0, 15 + line), line + 1);
  EXPECT_EQ(plot->at(0, 14), 0);
}

}  // namespace
}  // namespace nazori::model
