// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/brush_stroke.h"

#include <gtest/gtest.h>

#include <numbers>

#include "editor_under_test.h"
#include "nazori/calligraphy/sheet_ink.h"
#include "nazori/geometry/polyline.h"

namespace nazori::calligraphy {
namespace {

using geometry::PaperPoint;
using Line = geometry::Polyline<geometry::PaperFrame>;
constexpr double kPi = std::numbers::pi;

/// Area inside a closed line; positive where it turns counterclockwise.
double area(const Line& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const PaperPoint a = loop[i], b = loop[(i + 1) % loop.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum / 2;
}
double total_area(const std::vector<Line>& outline) {
  double sum = 0;
  for (const Line& loop : outline) sum += area(loop);
  return sum;
}

TEST(StrokeOutline, OfADotIsACircle) {
  const ModelStroke dot{{{0.003, -0.002}}, {0.002}};
  const auto outline = outline_of(dot);
  ASSERT_EQ(outline.size(), 1U);
  for (const PaperPoint p : outline[0]) EXPECT_NEAR(geometry::distance(p, {0.003, -0.002}), 0.002, 1e-5);
  EXPECT_NEAR(area(outline[0]), kPi * 4e-6, 0.05e-6);
}

TEST(StrokeOutline, OfABarIsARectangleWithRoundEnds) {
  const ModelStroke bar{{{-0.01, 0}, {0.01, 0.005}}, {0.0015, 0.0015}};
  const auto outline = outline_of(bar);
  ASSERT_EQ(outline.size(), 1U);
  const double length = std::hypot(0.02, 0.005);
  EXPECT_NEAR(area(outline[0]), 2 * 0.0015 * length + kPi * 0.0015 * 0.0015, 0.25e-6);
  EXPECT_LT(outline[0].size(), 120U);  // straight sides need no points
}

TEST(StrokeOutline, OfASweepIsAWedge) {
  const ModelStroke sweep{{{0, 0}, {0.02, 0}}, {0.002, 0.0}};
  const auto outline = outline_of(sweep);
  // A half disc and a triangle.
  EXPECT_NEAR(total_area(outline), kPi * 2e-6 + 0.02 * 0.002, 0.3e-6);
}

TEST(StrokeOutline, OfARingHasAHoleThatTurnsTheOtherWay) {
  ModelStroke ring;
  for (int i = 0; i <= 100; ++i) {
    const double a = 2 * kPi * i / 100;
    ring.points.push_back({0.01 * std::cos(a), 0.01 * std::sin(a)});
    ring.half_width_m.push_back(0.001);
  }
  const auto outline = outline_of(ring);
  ASSERT_EQ(outline.size(), 2U);
  EXPECT_LT(area(outline[0]) * area(outline[1]), 0);
  EXPECT_NEAR(total_area(outline), kPi * (0.011 * 0.011 - 0.009 * 0.009), 0.3e-6);
}

TEST(StrokeOutline, OfNothingIsNothing) { EXPECT_TRUE(outline_of({}).empty()); }

TEST(StrokeInk, CellsOfABarHaveItsArea) {
  const std::vector bars{ModelStroke{{{-0.02, 0.01}, {0.02, 0.01}}, {0.003, 0.003}}};
  const SheetInk ink = ink_of(bars, 512);
  const auto cells = std::count(ink.cells.begin(), ink.cells.end(), 1);
  EXPECT_NEAR(static_cast<double>(cells) * ink.cell_m() * ink.cell_m(), 0.04 * 0.006 + kPi * 9e-6, 2e-6);
  const auto at = [&](PaperPoint p) {
    return ink.has(static_cast<int>((p.x + 0.0512) / ink.cell_m()),
                   static_cast<int>((0.0512 - p.y) / ink.cell_m()));
  };
  EXPECT_TRUE(at({0, 0.0125}));
  EXPECT_FALSE(at({0, 0.0135}));
  EXPECT_TRUE(at({0, 0.0075}));
  EXPECT_FALSE(at({0, 0.0065}));
}

TEST(StrokeInk, StrokesBesideTheSheetAreCutOff) {
  const std::vector bars{ModelStroke{{{-0.2, 0}, {0.2, 0}}, {0.003, 0.003}}};
  const SheetInk ink = ink_of(bars, 128);
  EXPECT_TRUE(ink.has(0, 64));
  EXPECT_TRUE(ink.has(127, 64));
  EXPECT_FALSE(ink.has(0, 0));
}

TEST(WrittenStrokes, AreKnownWithTheirWidthAndFollowUndoAndRedo) {
  SheetEditor e = test::editor();
  test::line(e, {-0.02, 0.01}, {0.02, 0.01}, 0.3);
  test::line(e, {-0.02, -0.01}, {0.02, -0.01}, 0.8);
  ASSERT_EQ(e.written().size(), 2U);
  const auto middle = [&](std::size_t i) { return e.written()[i][e.written()[i].size() / 2]; };
  EXPECT_NEAR(middle(0).pen.y, 0.01, 1e-9);
  EXPECT_NEAR(middle(0).at.y, 0.01, 0.002);
  EXPECT_EQ(middle(0).pressure, 0.3);
  EXPECT_GT(middle(0).half_width_m, 0.0003);
  EXPECT_GT(middle(1).half_width_m, 1.2 * middle(0).half_width_m);
  const double width = middle(1).half_width_m;
  e.undo();
  ASSERT_EQ(e.written().size(), 1U);
  e.undo();
  EXPECT_TRUE(e.written().empty());
  e.redo();
  e.redo();
  ASSERT_EQ(e.written().size(), 2U);
  EXPECT_EQ(middle(1).half_width_m, width);
  e.undo();
  test::line(e, {0, -0.02}, {0, 0.02});
  ASSERT_EQ(e.written().size(), 2U);
  EXPECT_NEAR(middle(1).pen.x, 0, 1e-9);
}

TEST(WrittenStrokes, StayWhenTheSheetDriesAndGoWithTheSheet) {
  SheetEditor e = test::editor();
  test::line(e, {-0.02, 0.01}, {0.02, 0.01});
  ASSERT_TRUE(e.dry_now());
  EXPECT_EQ(e.written().size(), 1U);
  e.undo();
  EXPECT_EQ(e.written().size(), 1U);
  ASSERT_TRUE(e.take_new_sheet("hanshi"));
  EXPECT_TRUE(e.written().empty());
  e.undo();
  EXPECT_EQ(e.written().size(), 1U);
}

TEST(WrittenStrokes, HaveTheWidthOfTheInkOnTheSheet) {
  SheetEditor e = std::move(SheetEditor::create("board", 512).value());
  test::line(e, {-0.03, 0}, {0.03, 0}, 0.6);
  const SheetInk ink = ink_on(e.sheet());
  int cells = 0;
  for (int row = 0; row < ink.size; ++row) cells += ink.has(ink.size / 2, row) ? 1 : 0;
  const BrushPoint& middle = e.written()[0][e.written()[0].size() / 2];
  EXPECT_NEAR(cells * ink.cell_m(), 2 * middle.half_width_m, 0.25 * 2 * middle.half_width_m);
}

}  // namespace
}  // namespace nazori::calligraphy
