// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "../src/number_labels.h"
#include "../src/number_layout.h"

namespace nazori::view {
namespace {

/// The box of what is inked in a cell, in its pixels; the sums are over its coverage.
struct Inked {
  int left = 1000, right = -1, top = 1000, bottom = -1;
  double sum = 0;
  [[nodiscard]] int width() const { return right - left + 1; }
  [[nodiscard]] int height() const { return bottom - top + 1; }
};

double coverage(const LabelSheet& sheet, int number, int x, int y) {
  const int column = (number - 1) % sheet.columns * sheet.cell + x;
  const int row = (number - 1) / sheet.columns * sheet.cell + y;
  return sheet.coverage[static_cast<std::size_t>(row) * static_cast<std::size_t>(sheet.columns * sheet.cell) +
                        static_cast<std::size_t>(column)];
}

Inked inked(const LabelSheet& sheet, int number) {
  Inked box;
  for (int y = 0; y < sheet.cell; ++y) {
    for (int x = 0; x < sheet.cell; ++x) {
      const double c = coverage(sheet, number, x, y);
      box.sum += c / 255;
      if (c < 100) continue;
      box.left = std::min(box.left, x);
      box.right = std::max(box.right, x);
      box.top = std::min(box.top, y);
      box.bottom = std::max(box.bottom, y);
    }
  }
  return box;
}

class EachFont : public testing::TestWithParam<bool> {
 protected:
  NumberFont font_ = GetParam() ? NumberFont::built_in() : NumberFont();
};

INSTANTIATE_TEST_SUITE_P(View, EachFont, testing::Bool(),
                         [](const auto& chosen) { return chosen.param ? "BuiltIn" : "System"; });

TEST_P(EachFont, DrawsEightNumbersInARow) {
  for (const auto& [count, columns, rows] :
       {std::tuple{1, 1, 1}, {7, 7, 1}, {8, 8, 1}, {9, 8, 2}, {17, 8, 3}}) {
    const LabelSheet sheet = font_.draw(count, 20);
    EXPECT_EQ(sheet.cell, 20);
    EXPECT_EQ(sheet.columns, columns);
    EXPECT_EQ(sheet.rows, rows);
    EXPECT_EQ(sheet.coverage.size(), static_cast<std::size_t>(columns * rows) * 400);
  }
}

TEST_P(EachFont, NumbersStandInTheMiddleOfTheirCellsAndFillTheirDiscs) {
  constexpr int kCell = 100;
  const LabelSheet sheet = font_.draw(120, kCell);
  for (int number = 1; number <= 120; ++number) {
    const Inked box = inked(sheet, number);
    const double height = kCell * (number < 10 ? 0.52 : number < 100 ? 0.44 : 0.32);
    EXPECT_NEAR(box.height(), height, 2.5) << number;
    // The built-in one is narrower than the field on which it stands, at whichever end.
    EXPECT_NEAR(box.left + box.right, kCell - 1, GetParam() && number > 9 ? 9 : 3) << number;
    EXPECT_NEAR(box.top + box.bottom, kCell - 1, 3) << number;
    EXPECT_LT(std::hypot(box.width(), box.height()), kCell) << number;
    EXPECT_GT(box.sum, 0.08 * box.width() * box.height()) << number;
  }
}

TEST_P(EachFont, ANumberIsItsDigitsFromLeftToRight) {
  constexpr int kCell = 100;
  const LabelSheet sheet = font_.draw(99, kCell);
  // The ink of the tens and ones of two numbers that share them is the same.
  const auto half = [&](int number, bool right) {
    std::vector<double> ink;
    const Inked box = inked(sheet, number);
    for (int y = 20; y < 80; ++y)
      for (int x = 0; x < 22; ++x) {
        const int at = right ? box.right - x : box.left + x;
        ink.push_back(coverage(sheet, number, at, y));
      }
    return ink;
  };
  const auto difference = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]) / 255;
    return sum;
  };
  for (const int tens : {2, 3, 5, 6, 8, 9}) {
    EXPECT_LT(difference(half(tens * 10 + 2, false), half(tens * 10 + 5, false)), 60) << tens;
    EXPECT_LT(difference(half(20 + tens, true), half(50 + tens, true)), 60) << tens;
    EXPECT_GT(difference(half(20 + tens, true), half(24, true)), 80) << tens;
  }
}

TEST_P(EachFont, TheSmallestAndTheLargestCellHaveNumbers) {
  for (const int cell : {8, 512}) {
    const LabelSheet sheet = font_.draw(11, cell);
    for (const int number : {1, 8, 11}) EXPECT_GT(inked(sheet, number).sum, 2) << cell << ' ' << number;
  }
}

TEST(BuiltInFigures, AreLinesOfEvenWidthThatPassWhereTheFiguresDo) {
  EXPECT_EQ(NumberFont::built_in().family(), "built-in");
  EXPECT_FALSE(NumberFont().family().empty());
  constexpr int kCell = 200;
  const LabelSheet sheet = NumberFont::built_in().draw(9, kCell);
  // Places on a field 4 wide and 6 high, y down, on the line and off it, as one writes these figures.
  struct Figure {
    int digit;
    std::vector<glm::dvec2> on;
    std::vector<glm::dvec2> off;
  };
  const std::vector<Figure> figures{
      {1, {{2, 0.3}, {2, 3}, {2, 5.5}, {1.5, 0.5}, {1.3, 6}, {2.7, 6}}, {{0.5, 3}, {3.5, 3}, {1, 2}, {3, 1}}},
      {2, {{1, 0}, {3, 0}, {4, 1.5}, {2, 4}, {0, 6}, {2, 6}, {4, 6}}, {{1, 2}, {2, 2}, {3, 5}, {0, 4}}},
      {3, {{0, 0}, {2, 0}, {3, 1}, {4, 4.5}, {2, 6}, {0, 5}}, {{0.5, 2.5}, {2, 4.3}, {0, 3.5}}},
      {4, {{3, 0}, {3, 3}, {3, 6}, {1.5, 2}, {0, 4}, {2, 4}, {4, 4}}, {{0.5, 0.5}, {1, 5.5}, {2, 3}, {4, 1}}},
      {5,
       {{4, 0}, {2, 0}, {0, 0}, {0, 1.5}, {2, 2}, {4, 4}, {2, 6}, {0, 5}},
       {{2, 1}, {4, 1.2}, {2, 4}, {0, 4}}},
      {6, {{3, 1}, {2, 0}, {0, 3.5}, {0, 5}, {2, 6}, {4, 4.5}, {2, 3}}, {{2, 1.5}, {4, 2}, {2, 4.5}}},
      {7, {{0, 0}, {2, 0}, {4, 0}, {2.5, 3}, {1, 6}}, {{1, 2}, {0, 4}, {4, 4}}},
      {8,
       {{2, 0}, {4, 1.5}, {0, 1.5}, {2, 3}, {0, 4.5}, {4, 4.5}, {2, 6}},
       {{2, 1.5}, {2, 4.5}, {0, 3}, {4, 3}}},
      {9, {{4, 2}, {2, 0}, {0, 1.5}, {2, 3}, {4, 3}, {3, 5.5}, {2, 6}}, {{2, 1.5}, {1, 4.5}, {0, 4}}}};
  const double unit = static_cast<double>(std::lround(kCell * 0.52)) / 6.9;
  const double left = kCell / 2.0 - 2 * unit;
  const double top = (kCell - 6.9 * unit) / 2 + 0.45 * unit;
  for (const Figure& figure : figures) {
    const auto at = [&](glm::dvec2 p) {
      return coverage(sheet, figure.digit, static_cast<int>(left + p.x * unit),
                      static_cast<int>(top + p.y * unit));
    };
    for (const glm::dvec2 p : figure.on) EXPECT_GT(at(p), 200) << figure.digit << ": " << p.x << ", " << p.y;
    for (const glm::dvec2 p : figure.off) EXPECT_EQ(at(p), 0) << figure.digit << ": " << p.x << ", " << p.y;
  }
  // The upright of the one is nine tenths of a unit wide.
  double across = 0;
  for (int x = 0; x < kCell; ++x) across += coverage(sheet, 1, x, kCell / 2) / 255;
  EXPECT_NEAR(across, 0.9 * unit, 0.6);
}

constexpr double kRadius = 10;
constexpr double kGap = 3;

std::vector<glm::dvec2> lay_out(const std::vector<NumberWish>& wishes) {
  return lay_out_numbers(wishes, kRadius, kGap);
}

TEST(NumberLayout, WhereThereIsRoomANumberStandsBesideItsStart) {
  const auto places = lay_out({{{100, 100}, {0, -1}}, {{200, 100}, {0.6, 0.8}}, {{300, 100}, {0, 0}}});
  EXPECT_NEAR(glm::distance(places[0], glm::dvec2(100, 87)), 0, 1e-9);
  EXPECT_NEAR(glm::distance(places[1], glm::dvec2(207.8, 110.4)), 0, 1e-9);
  EXPECT_NEAR(glm::distance(places[2], glm::dvec2(300, 100)), 0, 1e-9);
  EXPECT_TRUE(lay_out({}).empty());
  // Half a gap is enough between two discs.
  const auto close = lay_out({{{100, 100}, {0, -1}}, {{121.5, 100}, {0, -1}}});
  EXPECT_NEAR(close[0].x, 100, 1e-9);
  EXPECT_NEAR(close[1].x, 121.5, 1e-9);
}

TEST(NumberLayout, TwoThatTouchPartEvenlyAlongTheLineBetweenThem) {
  const auto places = lay_out({{{100, 100}, {0, -1}}, {{110, 100}, {0, -1}}});
  EXPECT_NEAR(places[0].y, 87, 1e-9);
  EXPECT_NEAR(places[1].y, 87, 1e-9);
  EXPECT_NEAR(places[0].x + places[1].x, 210, 1e-9);
  EXPECT_NEAR(places[1].x - places[0].x, 2 * kRadius + kGap / 2, 0.1) << "no further than needed";
}

TEST(NumberLayout, OnOneSpotNumbersStillPartAndStayNear) {
  for (const int count : {2, 3, 7}) {
    const auto places =
        lay_out(std::vector<NumberWish>(static_cast<std::size_t>(count), {{-50, -70}, {1, 0}}));
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_LT(glm::distance(places[i], glm::dvec2(-37, -70)), 14 * std::sqrt(count) + 3) << count;
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GE(glm::distance(places[i], places[j]), 2 * kRadius) << count;
    }
  }
}

TEST(NumberLayout, MovesSmoothlyWithTheStarts) {
  std::vector<NumberWish> wishes;
  for (int i = 0; i < 6; ++i) wishes.push_back({{100 + 7.0 * i, 100 + (i % 2) * 9.0}, {0, -1}});
  auto before = lay_out(wishes);
  for (int step = 0; step < 40; ++step) {
    for (std::size_t i = 0; i < wishes.size(); ++i)
      wishes[i].start += glm::dvec2(0.1, 0.05 * static_cast<double>(i));
    const auto after = lay_out(wishes);
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_LT(glm::distance(before[i], after[i]), 3) << step;
    before = after;
  }
}

}  // namespace
}  // namespace nazori::view
