// SPDX-License-Identifier: Apache-2.0
// What a window asks of the room: zooming, curves to snap to, pictures to print.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "curve_facts.h"
#include "nazori/functions/points.h"
#include "nazori/functions/print_picture.h"
#include "nazori/functions/tablet_curves.h"

namespace nazori::functions {
namespace {

using test::is_carved;
using test::pieces_of;

Picture drawn(const std::string& expression, const Window& window, Layers layers = Layers::none()) {
  const auto plot = parse(expression);
  EXPECT_TRUE(plot) << expression;
  PlateSettings settings;
  settings.size = 256;
  settings.layers = layers;
  auto picture = draw(*plot, window, settings);
  EXPECT_TRUE(picture) << expression;
  return std::move(*picture);
}

TEST(Zoom, KeepsThePointUnderTheHandAndComesBackExactly) {
  const Window w{-10, 10, -5, 5};
  const PlatePoint hand{0.25, 0.75};
  Window z = w;
  for (int i = 0; i < 20; ++i) z = z.zoomed(hand, 2);
  EXPECT_NEAR(z.x(hand.u), -5, 1e-12);
  EXPECT_NEAR(z.y(hand.v), 2.5, 1e-12);
  EXPECT_NEAR(z.x1 - z.x0, 20 / std::exp2(20), 1e-15);
  for (int i = 0; i < 20; ++i) z = z.zoomed(hand, 0.5);
  EXPECT_NEAR(z.x0, w.x0, 1e-9);
  EXPECT_NEAR(z.y1, w.y1, 1e-9);
  const Window m = w.moved(0.1, -0.2);
  EXPECT_EQ(m.x0, -8);
  EXPECT_EQ(m.y0, -7);
}

TEST(Zoom, ShowsWhatWasHiddenBecauseTheExpressionIsDrawnAnew) {
  // From afar the two hooks at x = 3 are one spike; near by they are apart.
  const std::string thin = "y = x(x-3)/(x-3.001)";
  Window w{-10, 10, -10, 10};
  const Picture far = drawn(thin, w);
  EXPECT_TRUE(is_carved(far, 3, 0));
  for (int i = 0; i < 4; ++i) w = w.zoomed({w.u(3.001), w.v(3)}, 2);
  const Picture near = drawn(thin, w);
  EXPECT_EQ(pieces_of(near.plate), 2);
  EXPECT_FALSE(is_carved(near, 3.001, 3));
  // A million times: sin is its tangent there, and still a proven one.
  Window deep{-8, 8, -8, 8};
  for (int i = 0; i < 30; ++i) deep = deep.zoomed({deep.u(std::numbers::pi), deep.v(0)}, 2);
  const Picture tangent = drawn("y = sin(x)", deep);
  const double span = deep.x1 - deep.x0;
  EXPECT_TRUE(is_carved(tangent, std::numbers::pi, 0));
  EXPECT_TRUE(is_carved(tangent, std::numbers::pi + span / 8, -span / 8));
  EXPECT_FALSE(is_carved(tangent, std::numbers::pi + span / 8, span / 8));
}

TEST(TabletCurves, LieWhereTheGroovesAreDeepest) {
  const Picture p = drawn("x^2 + y^2 = 1; y = x/2", {-2, 2, -2, 2});
  const geometry::TabletShape shape;
  const auto curves = tablet_curves(p.tracing, 256, shape);
  ASSERT_EQ(curves.size(), 2U);
  for (const TabletCurve& c : curves) {
    for (const auto& q : c.points) {
      const PlatePoint at = plate_place(q, 256, shape);
      const double x = p.tracing.window.x(at.u);
      const double y = p.tracing.window.y(at.v);
      EXPECT_NEAR(c.statement == 0 ? std::hypot(x, y) - 1 : y - x / 2, 0, 0.002);
      const auto back = tablet_place(at, 256, shape);
      EXPECT_NEAR(back.x, q.x, 1e-12);
      EXPECT_NEAR(back.y, q.y, 1e-12);
    }
  }
  // The circle of radius 1 has a quarter of the plate's side as its radius, 256/255 wider on the tablet.
  double farthest = 0;
  for (const auto& q : curves[0].points) farthest = std::max(farthest, std::hypot(q.x, q.y));
  EXPECT_NEAR(farthest, 0.025 * 256 / 255, 2e-5);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_LT(curves[0].points.size(), 400U);
}

TEST(TabletCurves, AHandFindsTheNearestCurveAndStepsAlongIt) {
  const Picture p = drawn("y = x; x^2 + y^2 = 1", {-2, 2, -2, 2});
  const Window& w = p.tracing.window;
  const auto line = nearest_place(p.tracing, {w.u(1.5), w.v(1.3)});
  ASSERT_TRUE(line);
  EXPECT_NEAR(w.x(line->at.u), 1.4, 1e-3);
  EXPECT_NEAR(line->distance, 0.2 / std::sqrt(2.0) / 4, 1e-4);
  const CurvePlace next = step_along(p.tracing, *line, 0.05);
  EXPECT_NEAR(std::hypot(next.at.u - line->at.u, next.at.v - line->at.v), 0.05, 1e-9);
  EXPECT_NEAR(next.at.u, next.at.v, 1e-6);
  const CurvePlace end = step_along(p.tracing, *line, 100);
  EXPECT_GE(std::max(std::abs(end.at.u - 0.5), std::abs(end.at.v - 0.5)), 0.5);
  // Round the circle of circumference 2 pi / 4 and back to where it began.
  const auto circle = nearest_place(p.tracing, {w.u(0.9), w.v(0.1)}, 1);
  ASSERT_TRUE(circle);
  const CurvePlace round = step_along(p.tracing, *circle, std::numbers::pi / 2);
  EXPECT_NEAR(round.at.u, circle->at.u, 1e-3);
  EXPECT_NEAR(round.at.v, circle->at.v, 1e-3);
  EXPECT_FALSE(nearest_place(Tracing{}, {0.5, 0.5}));
  EXPECT_EQ(place_in_words(1.5, -2, Language::english), "x = about 1.5; y = minus 2");
  EXPECT_EQ(place_in_words(1.5, -2, Language::japanese), "x = 約1.5、y = マイナス2");
}

TEST(TabletCurves, EndAtTheFrameAndLeaveNothingOutside) {
  const Picture p = drawn("y = tan(x)", {-6, 6, -4, 4});
  const auto curves = tablet_curves(p.tracing, 256);
  EXPECT_EQ(curves.size(), 5U);
  for (const TabletCurve& c : curves) {
    for (const auto& q : c.points) {
      EXPECT_LE(std::abs(q.x), 0.0503);
      EXPECT_LE(std::abs(q.y), 0.0503);
    }
  }
}

TEST(CurveFeel, NeighboursDifferAndTheFloorOfTheSecondHasBumpsWithoutBeingDeeper) {
  EXPECT_GT(std::abs(feel_of(0).friction - feel_of(1).friction), 0.1);
  EXPECT_NE(feel_of(1).texture_period, feel_of(2).texture_period);
  const Picture p = drawn("y = 1; y = -1", {-5, 5, -5, 5});
  const auto range_along = [&](double y) {
    const int row = static_cast<int>((1 - p.tracing.window.v(y)) * 256);
    float low = 1;
    float high = 0;
    for (int column = 20; column < 236; ++column) {
      low = std::min(low, p.plate.heights.at(column, row));
      high = std::max(high, p.plate.heights.at(column, row));
    }
    return std::pair{low, high};
  };
  const auto first = range_along(1);
  const auto second = range_along(-1);
  EXPECT_LT(first.second - first.first, 0.001F);
  EXPECT_GT(second.second - second.first, 0.05F);
  EXPECT_GE(second.first, first.first - 0.001F);
  EXPECT_EQ(p.plate.statement[static_cast<std::size_t>(static_cast<int>(0.4 * 256) * 256 + 128)], 1);
}

TEST(PrintPicture, IsBlackAndWhiteWithCurvesOfTheirWidthAndAxesBrokenBesideThem) {
  const Picture p = drawn("y = x; y = -2", {-4, 4, -4, 4});
  PrintSettings settings;
  settings.dots_per_inch = 150;
  const auto print = print_picture(p.tracing, settings);
  ASSERT_TRUE(print);
  const int n = print->size();
  EXPECT_EQ(n, 945);
  for (const float s : print->samples()) ASSERT_TRUE(s == 0.0F || s == 1.0F);
  const auto black = [&](double x, double y) {
    return print->at(static_cast<int>((x + 4) / 8 * n), static_cast<int>((4 - y) / 8 * n)) == 0.0F;
  };
  // 1.6 mm across a slope of 45 degrees is 2.26 mm in a row: 0.113 of the window.
  int across = 0;
  for (int column = 0; column < n; ++column)
    across += print->at(column, static_cast<int>(0.3 * n)) == 0.0F && column > n / 2 + 80 && column < n - 30
                  ? 1
                  : 0;
  EXPECT_NEAR(across, 1.6 * std::sqrt(2.0) / 160 * n, 2);
  EXPECT_TRUE(black(1.5, 0));
  EXPECT_FALSE(black(0.12, 0));
  EXPECT_TRUE(black(1, 1));
  // The second curve is dashed.
  int dashes = 0;
  for (int column = 1; column < n; ++column) {
    const int row = static_cast<int>(0.75 * n);
    dashes += print->at(column, row) == 0.0F && print->at(column - 1, row) == 1.0F ? 1 : 0;
  }
  EXPECT_GT(dashes, 10);
  settings.side_mm = 10;
  EXPECT_FALSE(print_picture(p.tracing, settings));
}

TEST(Draw, WhenTimeIsOutWhatIsThereIsShownAndSaidToBeUnfinished) {
  const auto plot = parse("sin(x^2+y^2) = cos(xy)");
  ASSERT_TRUE(plot);
  TraceSettings settings;
  settings.most_milliseconds = 0.001;
  const auto part = trace(*plot, {-5, 5, -5, 5}, settings);
  ASSERT_TRUE(part);
  EXPECT_FALSE(part->complete);
  settings.most_milliseconds = 0;
  settings.resolution = 64;
  const auto all = trace(*plot, {-5, 5, -5, 5}, settings);
  ASSERT_TRUE(all);
  EXPECT_TRUE(all->complete);
  EXPECT_GT(all->branches.size(), part->branches.size());
}

}  // namespace
}  // namespace nazori::functions
