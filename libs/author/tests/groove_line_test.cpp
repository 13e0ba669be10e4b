// SPDX-License-Identifier: Apache-2.0
#include "groove_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "drawn_ink.h"
#include "nazori/geometry/polyline.h"

namespace nazori::author::test {
namespace {

using geometry::GridPoint;

GridLine flat(double from, double to, double y, double step = 2) {
  GridLine line;
  for (double x = from; x <= to; x += step) line.push_back({x, y});
  return line;
}

/// A bar along y = 200 with a half width of its own at each column.
template <class Half>
InkMap bar_with(Half half) {
  return ink_with([&](double x, double y) { return 1 + 0.25 * (half(x) - std::abs(y - 200)); });
}

std::vector<double> half_widths(const OwnStroke& stroke) {
  std::vector<double> widths;
  for (const GroovePoint& p : stroke.points) widths.push_back(p.half_width * kInkPerUnit);
  return widths;
}

TEST(GrooveAlong, MeasuresTheWidthToTheFractionOfASample) {
  const InkMap map = bar_with([](double x) { return 12.3 + 0.02 * x; });
  const GridLine line = flat(100, 300, 200);
  const OwnStroke stroke = groove_along(line, map);
  ASSERT_EQ(stroke.points.size(), line.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    EXPECT_NEAR(stroke.points[i].half_width * kInkPerUnit, 12.3 + 0.02 * line[i].x, 1e-3);
    EXPECT_NEAR(stroke.points[i].at.x, line[i].x * 109 / 511, 1e-9);
    EXPECT_NEAR(stroke.points[i].at.y, line[i].y * 109 / 511, 1e-9);
  }
  EXPECT_EQ(stroke.ending, kanji::StrokeEnding::stop);
}

TEST(GrooveAlong, MeasuresBothSidesAlsoAlongASlope) {
  // Half width 20 across a line that falls by 3 in 4.
  const InkMap map =
      ink_with([](double x, double y) { return 1 + 0.25 * (20 - std::abs(0.8 * y - 0.6 * x - 20)); });
  GridLine line;
  for (int k = 0; k < 60; ++k) line.push_back({120 + 1.6 * k, 115 + 1.2 * k});
  for (const double width : half_widths(groove_along(line, map))) EXPECT_NEAR(width, 20, 0.02);
}

TEST(GrooveAlong, FindsWhereTheWallOfAGrooveEndsLevel) {
  // The root of the depth is straight and would be 0 at 25.5 samples.
  InkMap map = ink_with([](double, double y) {
    const double root = std::max(0.0, 0.25 * (25.5 - std::abs(y - 200)));
    return root * root;
  });
  map.is_groove = true;
  for (const double width : half_widths(groove_along(flat(100, 200, 200), map)))
    EXPECT_NEAR(width, 25.5, 0.08);
  // Nowhere deeper than four times the limit, so only the rim is known.
  InkMap shallow = ink_with([](double, double y) { return 1 + 0.1 * (20.3 - std::abs(y - 200)); });
  shallow.is_groove = true;
  for (const double width : half_widths(groove_along(flat(100, 200, 200), shallow)))
    EXPECT_NEAR(width, 20.3, 1e-3);
}

TEST(GrooveAlong, HasTheDepthOfTheMapWithinItsRange) {
  InkMap map = bar_with([](double) { return 10.0; });
  for (std::size_t i = 0; i < map.depth.size(); ++i)
    map.depth[i] = static_cast<float>(i % kInkSide) / 400.0F - 0.2F;
  const OwnStroke stroke = groove_along(flat(40, 500, 200, 10), map);
  for (const GroovePoint& p : stroke.points) {
    const double x = p.at.x * kInkPerUnit;
    EXPECT_NEAR(p.depth, std::clamp(x / 400 - 0.2, 0.01, 1.0), 1e-6) << x;
  }
}

TEST(GrooveAlong, GoesOnEvenlyWhereOtherInkCrosses) {
  const auto half = [](double x) { return 10 + 0.02 * (x - 100); };
  const InkMap map = bar_with([&](double x) { return std::abs(x - 250) < 15 ? 150 : half(x); });
  const GridLine line = flat(100, 400, 200);
  const auto widths = half_widths(groove_along(line, map));
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(widths[i], half(line[i].x), 1e-3) << line[i].x;
}

/// The half width at x = 250 of a bar of 10 whose lower side reaches `other` from 240 to 260.
double beside(double other) {
  const InkMap map = ink_with([&](double x, double y) {
    const double half = y > 200 && std::abs(x - 250) < 11 ? other : 10;
    return 1 + 0.25 * (half - std::abs(y - 200));
  });
  return half_widths(groove_along(flat(100, 400, 200), map))[75];
}

TEST(GrooveAlong, ASideThatIsMuchBroaderIsOtherInk) {
  EXPECT_NEAR(beside(14.5), 12.25, 0.01);
  EXPECT_NEAR(beside(15.4), 12.7, 0.01) << "less than 1.35 * 10 + 2";
  EXPECT_NEAR(beside(15.6), 10, 0.01);
  EXPECT_NEAR(beside(40), 10, 0.01);
}

TEST(GrooveAlong, AWidthFarAboveTheUsualOneIsOtherInk) {
  const auto at_250 = [](double wide) {
    const InkMap map = bar_with([&](double x) { return std::abs(x - 250) < 11 ? wide : 10; });
    return half_widths(groove_along(flat(100, 400, 200), map))[75];
  };
  EXPECT_NEAR(at_250(16.9), 16.9, 0.01);
  EXPECT_NEAR(at_250(17.1), 10, 0.01);
  EXPECT_NEAR(at_250(22), 10, 0.01);
}

TEST(GrooveAlong, NarrowsOnTowardsAnEndInOtherInk) {
  const auto half = [](double x) { return 30 - 0.1 * (x - 100); };
  const InkMap map = bar_with([&](double x) { return x > 250.5 ? 150 : half(x); });
  const GridLine line = flat(100, 290, 200);
  auto widths = half_widths(groove_along(line, map));
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(widths[i], half(line[i].x), 2e-3) << line[i].x;
  // From the other end as well.
  GridLine back = line;
  std::ranges::reverse(back);
  widths = half_widths(groove_along(back, map));
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(widths[i], half(back[i].x), 2e-3) << back[i].x;
}

TEST(GrooveAlong, DoesNotBroadenTowardsAnEndInOtherInk) {
  const auto half = [](double x) { return 10 + 0.05 * (x - 100); };
  const InkMap map = bar_with([&](double x) { return x > 250.5 ? 150 : half(x); });
  const GridLine line = flat(100, 290, 200);
  const auto widths = half_widths(groove_along(line, map));
  for (std::size_t i = 0; i < line.size(); ++i)
    EXPECT_NEAR(widths[i], half(std::min(line[i].x, 250.0)), 2e-3) << line[i].x;
}

TEST(GrooveAlong, WithoutARimInSightIsAsWideAsTheDistanceFromPaper) {
  // 70 samples on both sides are ink, so paper is 71 away; a ray ends at 60.
  const InkMap map = bar_with([](double) { return 70.5; });
  for (const double width : half_widths(groove_along(flat(200, 260, 200), map)))
    EXPECT_NEAR(width, 70.5, 1e-5);
  const InkMap seen = bar_with([](double) { return 59.4; });
  for (const double width : half_widths(groove_along(flat(200, 260, 200), seen)))
    EXPECT_NEAR(width, 59.4, 1e-3);
}

TEST(GrooveAlong, ADotIsAsWideAsTheDistanceFromPaper) {
  const InkMap map =
      ink_with([](double x, double y) { return 1 + 0.25 * (9.5 - std::hypot(x - 200, y - 200)); });
  const auto widths = half_widths(groove_along({{200, 200}}, map));
  ASSERT_EQ(widths.size(), 1U);
  EXPECT_NEAR(widths[0], static_cast<double>(map.distance.distance[map.index(200, 200)]) - 0.5, 1e-6);
}

TEST(GrooveAlong, OutsideOfTheInkIsATenthOfASampleWide) {
  const InkMap map = bar_with([](double) { return 10.0; });
  for (const double width : half_widths(groove_along(flat(200, 260, 300), map)))
    EXPECT_NEAR(width, 0.1, 1e-9);
}

TEST(GrooveAlong, TheEdgeOfThePictureIsARim) {
  const InkMap map = ink_with([](double, double y) { return 1 + 0.25 * (5.5 - std::abs(y - 5)); });
  for (const double width : half_widths(groove_along(flat(200, 260, 5), map))) EXPECT_NEAR(width, 5.5, 1e-3);
  const InkMap right = ink_with([](double x, double) { return 1 + 0.25 * (5.5 - std::abs(x - 506)); });
  GridLine line;
  for (double y = 200; y < 260; y += 2) line.push_back({506, y});
  for (const double width : half_widths(groove_along(line, right))) EXPECT_NEAR(width, 5.5, 1e-3);
}

/// A bar with round ends around the points (150, 200) and (350, 200), of radius 20.
InkMap capsule() {
  return ink_with([](double x, double y) {
    const double along = std::max({150 - x, x - 350, 0.0});
    return 1 + 0.25 * (20 - std::hypot(along, y - 200));
  });
}

TEST(CentreEnds, MovesEndsToTheMiddleOfTheRoundEnds) {
  const InkMap map = capsule();
  for (const double off : {-4.0, 0.0, 6.0, 10.0}) {
    GridLine line = flat(150 + off, 350 - off, 200);
    centre_ends(line, map, true, true);
    EXPECT_NEAR(line.front().x, 150, 0.05) << off;
    EXPECT_NEAR(line.back().x, 350, 0.05) << off;
    EXPECT_NEAR(line.back().y, 200, 1e-9);
    for (std::size_t i = 1; i < line.size(); ++i) EXPECT_GE(line[i].x - line[i - 1].x, 1 - 0.05) << off;
  }
}

TEST(CentreEnds, MovesOnlyTheEndsItIsAskedFor) {
  const InkMap map = capsule();
  GridLine line = flat(156, 344, 200);
  const GridLine before = line;
  centre_ends(line, map, false, false);
  EXPECT_EQ(line, before);
  centre_ends(line, map, true, false);
  EXPECT_NEAR(line.front().x, 150, 0.05);
  EXPECT_EQ(line.back(), before.back());
  line = before;
  centre_ends(line, map, false, true);
  EXPECT_EQ(line.front(), before.front());
  EXPECT_NEAR(line.back().x, 350, 0.05);
  GridLine two{{160, 200}, {340, 200}};
  centre_ends(two, map, true, true);
  EXPECT_EQ(two, (GridLine{{160, 200}, {340, 200}}));
}

TEST(CentreEnds, LeavesEndsInOtherInkAndThinOnes) {
  const InkMap map = capsule();
  // More than 1.6 radii ahead there is still ink; 11 and 13 samples inside are 31 and 33 from the rim.
  GridLine line = flat(161, 339, 200);
  centre_ends(line, map, true, true);
  EXPECT_NEAR(line.back().x, 350, 0.05);
  line = flat(163, 337, 200);
  centre_ends(line, map, true, true);
  EXPECT_EQ(line, flat(163, 337, 200));
  // Nearer to the rim than 0.8 radii less one the line thins out.
  line = flat(144, 356, 200);
  centre_ends(line, map, true, true);
  EXPECT_EQ(line, flat(144, 356, 200));
  line = flat(146, 354, 200);
  centre_ends(line, map, true, true);
  EXPECT_NEAR(line.back().x, 350, 0.05);
}

TEST(CentreEnds, LeavesEndsThatAreNotBetweenTwoRims) {
  // One side is 20 wide, the other one more.
  const auto moved = [](double other) {
    const InkMap map = ink_with([&](double x, double y) {
      const double along = std::max(x - 350, 0.0);
      return 1 + 0.25 * ((y > 200 ? other : 20) - std::hypot(along, y - 200));
    });
    GridLine line = flat(250, 346, 200);
    centre_ends(line, map, false, true);
    return line.back().x - 346;
  };
  EXPECT_NEAR(moved(26), 24 - 23, 0.05) << "less than 1.3 * 20 + 1";
  EXPECT_EQ(moved(28), 0);
}

/// A stroke to the right whose half width grows evenly from its first point.
OwnStroke narrow_at_front(double first, double slope, double step = 0.5) {
  OwnStroke stroke;
  for (double s = 0; s <= 12; s += step) stroke.points.push_back({{20 + s, 30}, first + slope * s, 0.6});
  return stroke;
}

double lengthened_by(OwnStroke stroke) {
  const GroovePoint before = stroke.points.front();
  const std::size_t count = stroke.points.size();
  lengthen_tips(stroke);
  if (stroke.points.size() == count) return 0;
  EXPECT_EQ(stroke.points.size(), count + 1);
  EXPECT_NEAR(stroke.points.front().half_width, 0.1 / kInkPerUnit, 1e-12);
  EXPECT_EQ(stroke.points.front().depth, before.depth);
  EXPECT_NEAR(stroke.points.front().at.y, before.at.y, 1e-12);
  return before.at.x - stroke.points.front().at.x;
}

TEST(LengthenTips, GoesOnToWhereTheWidthWouldBeNothing) {
  EXPECT_NEAR(lengthened_by(narrow_at_front(0.3, 0.3)), 1, 1e-9);
  EXPECT_NEAR(lengthened_by(narrow_at_front(0.3, 0.2)), 1.5, 1e-9);
  EXPECT_NEAR(lengthened_by(narrow_at_front(1.2, 0.3)), 3, 1e-9) << "at most";
  EXPECT_NEAR(lengthened_by(narrow_at_front(0.05, 0.11)), 0.05 / 0.11, 1e-9);
  EXPECT_EQ(lengthened_by(narrow_at_front(0.05, 0.09)), 0) << "too even";
  EXPECT_EQ(lengthened_by(narrow_at_front(0, 0.3)), 0) << "it is there already";
  // A unit from the tip the width must be 0.7 of that five units from it.
  EXPECT_NEAR(lengthened_by(narrow_at_front(1.9, 0.3)), 3, 1e-9);
  EXPECT_EQ(lengthened_by(narrow_at_front(2.6, 0.3)), 0);
}

TEST(LengthenTips, AtBothEndsWhereBothThinOut) {
  OwnStroke stroke = narrow_at_front(0.3, 0.3);
  const std::size_t count = stroke.points.size();
  for (std::size_t i = 0; i < count / 2; ++i)
    stroke.points[count - 1 - i].half_width = stroke.points[i].half_width;
  lengthen_tips(stroke);
  ASSERT_EQ(stroke.points.size(), count + 2);
  EXPECT_NEAR(stroke.points.front().at.x, 19, 1e-9);
  EXPECT_NEAR(stroke.points.back().at.x, 33, 1e-9);
  OwnStroke dot{{{{20, 20}, 3, 1}}, kanji::StrokeEnding::stop, {}};
  lengthen_tips(dot);
  EXPECT_EQ(dot.points.size(), 1U);
}

TEST(LengthenTips, TakesTheSteepestSlopeFromTwoUnitsOn) {
  // Level but for a rise of 0.5 a unit from 3 to 4 units: 0.5 in 3 units from the first one.
  OwnStroke stroke;
  for (double s = 0; s <= 12; s += 0.5)
    stroke.points.push_back({{20 + s, 30}, 0.2 + 0.5 * std::clamp(s - 3, 0.0, 1.0), 1});
  // (0.7 - 0.2) / (4 - 1) is the steepest.
  EXPECT_NEAR(lengthened_by(stroke), 0.2 / (0.5 / 3) - 1, 1e-9);
}

/// Two straight parts of 40 steps of 2 samples that meet at this angle.
GridLine bent_by(double degrees) {
  GridLine line;
  const double a = degrees * std::numbers::pi / 180;
  for (int k = -40; k < 0; ++k) line.push_back({200 + 2.0 * k, 200});
  for (int k = 0; k <= 40; ++k) line.push_back({200 + 2 * k * std::cos(a), 200 + 2 * k * std::sin(a)});
  return line;
}

TEST(CornersOf, AreTheSharpestPointsOfBendsOfMoreThanFortyDegrees) {
  for (const double degrees : {41.0, 60.0, 90.0, 130.0}) {
    const auto corners = corners_of(bent_by(degrees), 12);
    ASSERT_EQ(corners.size(), 1U) << degrees;
    EXPECT_EQ(corners[0].point, 40U);
    EXPECT_NEAR(corners[0].turn, degrees * std::numbers::pi / 180, 1e-9);
  }
  EXPECT_TRUE(corners_of(bent_by(39), 12).empty());
  EXPECT_TRUE(corners_of({{0, 0}, {2, 0}, {2, 2}, {2, 4}}, 2).empty());
  EXPECT_TRUE(corners_of(GridLine(9, {3, 3}), 2).empty());
  EXPECT_EQ(corners_of({{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}}, 4).size(), 1U);
}

TEST(CornersOf, OfTwoBendsWithinReachIsTheSharperOne) {
  // 80 degrees at the 30th point and 60 more at a later one.
  const auto twice = [](int apart) {
    GridLine line;
    const double a = 80 * std::numbers::pi / 180;
    const double b = 140 * std::numbers::pi / 180;
    GridPoint at{100, 100};
    for (int k = 0; k < 90; ++k) {
      line.push_back(at);
      const double turn = k < 30 ? 0 : k < 30 + apart ? a : b;
      at = at + GridPoint{2 * std::cos(turn), 2 * std::sin(turn)};
    }
    return corners_of(line, 20);
  };
  EXPECT_EQ(twice(25).size(), 2U);
  EXPECT_EQ(twice(25)[0].point, 30U);
  EXPECT_EQ(twice(25)[1].point, 55U);
  EXPECT_EQ(twice(4).size(), 1U);
}

TEST(Smoothed, KeepsStraightLinesAndEnds) {
  const GridLine line = smoothed(flat(100, 200, 50, 1));
  ASSERT_EQ(line.size(), 51U);
  for (std::size_t i = 0; i < line.size(); ++i) {
    EXPECT_NEAR(line[i].x, 100 + 2.0 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(line[i].y, 50, 1e-9);
  }
  EXPECT_EQ(smoothed(flat(100, 200, 50, 1), 5).size(), 21U);
  EXPECT_EQ(smoothed({{1, 1}, {9, 9}}), (GridLine{{1, 1}, {9, 9}}));
}

TEST(Smoothed, IsTheMeanOfNineNeighboursTwice) {
  // A square corner of unit steps. Weights are 1 - (k / 5)^2, fewer near the ends.
  GridLine raw = flat(100, 150, 100, 1);
  for (double y = 101; y <= 150; ++y) raw.push_back({150, y});
  GridLine truth = raw;
  for (int pass = 0; pass < 2; ++pass) {
    const GridLine from = truth;
    for (int i = 1; i + 1 < static_cast<int>(from.size()); ++i) {
      const int r = std::min({4, i, static_cast<int>(from.size()) - 1 - i});
      GridPoint sum;
      double weights = 0;
      for (int k = -r; k <= r; ++k) {
        const double weight = 1 - static_cast<double>(k * k) / ((r + 1) * (r + 1));
        sum = sum + from[static_cast<std::size_t>(i + k)] * weight;
        weights += weight;
      }
      truth[static_cast<std::size_t>(i)] = sum * (1 / weights);
    }
  }
  const double length = geometry::arc_length<geometry::GridFrame>(truth);
  const GridLine found = smoothed(raw);
  ASSERT_EQ(found.size(), static_cast<std::size_t>(std::lround(length / 2)) + 1);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double s = length * static_cast<double>(i) / static_cast<double>(found.size() - 1);
    EXPECT_LT(geometry::distance(found[i], geometry::point_at<geometry::GridFrame>(truth, s)), 1e-6) << i;
  }
}

}  // namespace
}  // namespace nazori::author::test
