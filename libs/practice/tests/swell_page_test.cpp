// SPDX-License-Identifier: Apache-2.0
#include "../src/swell_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace nazori::practice {
namespace {

using model::PlateLine;
using print::PageMark;
using print::PathStep;
using Kind = PathStep::Kind;

/// A page of 100 x 200 mm after something was drawn on it.
template <class Draw>
std::vector<PageMark> marks(Draw draw) {
  SwellPage page(100, 200);
  draw(page);
  return page.take().marks;
}

void expect_path(const PageMark& mark, const PlateLine& y_down) {
  ASSERT_EQ(mark.path.size(), y_down.size());
  for (std::size_t i = 0; i < y_down.size(); ++i) {
    EXPECT_EQ(mark.path[i].kind, i == 0 ? Kind::move : Kind::line) << i;
    EXPECT_NEAR(mark.path[i].points[0].x, y_down[i].x, 1e-9) << i;
    EXPECT_NEAR(mark.path[i].points[0].y, y_down[i].y, 1e-9) << i;
  }
}

TEST(SwellPage, ALineHasItsPlaceFromTheUpperEdgeItsWidthAndItsGrey) {
  const auto made = marks([](SwellPage& page) {
    page.add_line(PlateLine{{10, 20}, {30, 20}, {30, 50}}, 1.5, 0.25);
  });
  ASSERT_EQ(made.size(), 1U);
  expect_path(made[0], {{10, 180}, {30, 180}, {30, 150}});
  EXPECT_EQ(made[0].width_mm, 1.5);
  EXPECT_EQ(made[0].grey, 0.25);
  EXPECT_TRUE(made[0].round);
  EXPECT_FALSE(made[0].filled);
}

TEST(SwellPage, APointIsALineToItself) {
  const auto made = marks([](SwellPage& page) { page.add_line(PlateLine{{10, 20}}, 1); });
  ASSERT_EQ(made.size(), 1U);
  expect_path(made[0], {{10, 180}, {10, 180}});
  EXPECT_EQ(made[0].grey, 0) << "black";
}

TEST(SwellPage, ADotIsAFilledCircle) {
  const auto made = marks([](SwellPage& page) { page.add_dot({50, 60}, 4); });
  ASSERT_EQ(made.size(), 1U);
  EXPECT_TRUE(made[0].filled);
  ASSERT_EQ(made[0].path.size(), 6U);
  EXPECT_EQ(made[0].path.front().kind, Kind::move);
  EXPECT_EQ(made[0].path.back().kind, Kind::close);
  print::PaperPoint at = made[0].path.front().points[0];
  double turned = 0;
  double before = std::atan2(at.y - 140, at.x - 50);
  for (std::size_t i = 1; i <= 4; ++i) {
    ASSERT_EQ(made[0].path[i].kind, Kind::curve);
    const auto& [a, b, c] = made[0].path[i].points;
    for (int step = 1; step <= 8; ++step) {
      const double t = step / 8.0, s = 1 - t;
      const double x = s * s * s * at.x + 3 * s * s * t * a.x + 3 * s * t * t * b.x + t * t * t * c.x;
      const double y = s * s * s * at.y + 3 * s * s * t * a.y + 3 * s * t * t * b.y + t * t * t * c.y;
      EXPECT_NEAR(std::hypot(x - 50, y - 140), 2, 2 * 0.0003) << i << " " << t;
      const double angle = std::atan2(y - 140, x - 50);
      turned += std::remainder(angle - before, 2 * std::numbers::pi);
      before = angle;
    }
    at = c;
  }
  EXPECT_NEAR(std::abs(turned), 2 * std::numbers::pi, 1e-9) << "once around";
}

/// The middle of a dot, whose path begins at its right.
print::PaperPoint middle_of(const PageMark& dot) {
  return {dot.path.front().points[0].x - 1.25 / 2, dot.path.front().points[0].y};
}

TEST(SwellPage, BrailleHasItsDots) {
  // Dots 1 and 6 of one cell.
  const auto made = marks([](SwellPage& page) {
    page.add_braille(std::vector<model::BrailleCell>{0b100001}, {10, 20});
  });
  ASSERT_EQ(made.size(), 2U);
  EXPECT_NEAR(middle_of(made[0]).x, 10.625, 1e-9);
  EXPECT_NEAR(middle_of(made[0]).y, 200 - (20.625 + 5), 1e-9);
  EXPECT_NEAR(middle_of(made[1]).x, 10.625 + 2.5, 1e-9);
  EXPECT_NEAR(middle_of(made[1]).y, 200 - 20.625, 1e-9);
}

TEST(SwellPage, TextGoesOnInTheNextLineAndEndsAtTheMargin) {
  // 76 mm between the margins hold 12 cells. The lines stand at 32, 22, 12 and 2 mm; the last has no room.
  const std::vector<std::vector<model::BrailleCell>> text{std::vector<model::BrailleCell>(14, 1), {1}, {1}};
  const auto made = marks([&](SwellPage& page) { page.add_text(text, 32); });
  ASSERT_EQ(made.size(), 15U);
  const auto expect_at = [&](std::size_t i, int cell, double y_mm) {
    EXPECT_NEAR(middle_of(made[i]).x, 12 + 0.625 + 6 * cell, 1e-9) << i;
    EXPECT_NEAR(middle_of(made[i]).y, 200 - (y_mm + 5.625), 1e-9) << i;
  };
  for (std::size_t i = 0; i < 12; ++i) expect_at(i, static_cast<int>(i), 32);
  expect_at(12, 0, 22);
  expect_at(13, 1, 22);
  expect_at(14, 0, 12);
}

TEST(SwellPage, AStrokeThatStopsHasOneWidth) {
  const auto made = marks([](SwellPage& page) {
    page.add_stroke({{{10, 20}, {30, 20}}, model::LineEnd::full});
  });
  ASSERT_EQ(made.size(), 1U);
  expect_path(made[0], {{10, 180}, {30, 180}, {30, 180}});
  EXPECT_EQ(made[0].width_mm, 1.6);
}

TEST(SwellPage, AStrokeThatSinksBecomesThinnerInPieces) {
  // Over its last 8 mm, half a millimetre at a time.
  const auto made = marks([](SwellPage& page) {
    page.add_stroke({{{10, 20}, {15, 20}, {30, 20}}, model::LineEnd::sinks});
  });
  ASSERT_EQ(made.size(), 17U);
  expect_path(made[0], {{10, 180}, {15, 180}, {22, 180}});
  EXPECT_EQ(made[0].width_mm, 1.6);
  for (int k = 0; k < 16; ++k) {
    const PageMark& piece = made[static_cast<std::size_t>(k) + 1];
    expect_path(piece, {{22 + 0.5 * k, 180}, {22.5 + 0.5 * k, 180}});
    EXPECT_NEAR(piece.width_mm, 1.6 - 0.6 * (k + 1) / 16, 1e-12) << k;
  }
}

constexpr double kNone = std::numeric_limits<double>::infinity();

TEST(ClosestLines, AreThoseThatRunSideBySide) {
  const PlateLine line{{0, 0}, {40, 0}};
  const auto closest = [&](const PlateLine& other) {
    return closest_lines(std::vector<PlateLine>{line, other});
  };
  EXPECT_NEAR(closest({{0, 5}, {40, 5}}), 5, 1e-9);
  EXPECT_NEAR(closest({{40, -7}, {0, -7}}), 7, 1e-9) << "in the other direction, too";
  EXPECT_NEAR(closest({{10, 3}, {30, 3}}), 3, 1e-9);
  EXPECT_EQ(closest({{20, 2}, {20, 30}}), kNone) << "across";
  EXPECT_EQ(closest({{44, 5}, {80, 5}}), kNone) << "farther along";
  EXPECT_EQ(closest({{0, 0.9}, {40, 0.9}}), kNone) << "as near as that it is the same line";
  EXPECT_NEAR(closest({{0, 1.1}, {40, 1.1}}), 1.1, 1e-9);
  // 19.9 degrees have a cosine of 0.94.
  const auto slanted = [&](double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    return closest({{0, 5}, {30 * std::cos(a), 5 + 30 * std::sin(a)}});
  };
  EXPECT_LT(slanted(19), 8);
  EXPECT_EQ(slanted(21), kNone);
}

TEST(ClosestLines, OneLineHasNoOtherAndADotNoDirection) {
  EXPECT_EQ(closest_lines(std::vector<PlateLine>{{{0, 0}, {40, 0}, {40, 3}, {0, 3}}}), kNone);
  EXPECT_EQ(closest_lines(std::vector<PlateLine>{{{0, 0}, {40, 0}}, {{20, 5}}}), kNone);
  EXPECT_EQ(closest_lines({}), kNone);
}

TEST(ClosestLines, WhereOneLeavesAnotherTheClosestTwentiethDoesNotCount) {
  // 60 mm at 10 mm, and the last millimetre nearer.
  const PlateLine line{{0, 0}, {60, 0}};
  const PlateLine leaves{{0, 10}, {59, 10}, {60, 2}};
  EXPECT_NEAR(closest_lines(std::vector<PlateLine>{line, leaves}), 10, 0.2);
}

}  // namespace
}  // namespace nazori::practice
