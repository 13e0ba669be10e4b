// SPDX-License-Identifier: Apache-2.0
// Outlines of few discs, worked by hand: tangents, arcs, joins, and what is hidden.
#include "../src/stroke_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace nazori::author {
namespace {

using geometry::GlyphPoint;

std::vector<OutlineContour> outlined(const std::vector<Disc>& discs, double tolerance) {
  std::vector<OutlineContour> contours;
  append_outline(discs, tolerance, contours);
  return contours;
}

OutlinePoint on(double x, double y) { return {{x, y}, true}; }
OutlinePoint off(double x, double y) { return {{x, y}, false}; }

void expect_contour(const OutlineContour& found, const OutlineContour& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].at.x, expected[i].at.x, 1e-9) << i;
    EXPECT_NEAR(found[i].at.y, expected[i].at.y, 1e-9) << i;
    EXPECT_EQ(found[i].on_curve, expected[i].on_curve) << i;
  }
}

TEST(StrokeOutline, ADiscIsFourCurvesWhereThatIsNearEnough) {
  // A quadratic curve over a right angle is 6.07 % of the radius too far out in its middle.
  const std::vector<Disc> disc{{{50, 50}, 10}};
  const auto rough = outlined(disc, 0.61);
  ASSERT_EQ(rough.size(), 1U);
  expect_contour(rough[0], {on(50, 40), off(60, 40), off(60, 60), off(40, 60), off(40, 40)});
  EXPECT_EQ(outlined(disc, 0.60)[0].size(), 6U);
  // Over 360/7 degrees it is 0.54 %, over 60 degrees 1.04 %.
  EXPECT_EQ(outlined(disc, 0.103)[0].size(), 8U);
  EXPECT_EQ(outlined(disc, 0.104)[0].size(), 7U);
}

TEST(StrokeOutline, TwoEqualDiscsAreABarWithRoundEnds) {
  const auto bar = outlined({{{20, 50}, 5}, {{60, 50}, 5}}, 1);
  ASSERT_EQ(bar.size(), 1U);
  expect_contour(bar[0], {on(60, 45), off(65, 45), off(65, 55), on(60, 55), on(20, 55), off(15, 55),
                          off(15, 45), on(20, 45)});
}

TEST(StrokeOutline, OfUnequalDiscsTheSidesTouchBoth) {
  // The sine of the lean is (5 - 1) / 10; the lines touch at that share of each radius ahead.
  const auto drop = outlined({{{0, 0}, 5}, {{10, 0}, 1}}, 1);
  ASSERT_EQ(drop.size(), 1U);
  std::vector<GlyphPoint> corners;
  for (const OutlinePoint& p : drop[0])
    if (p.on_curve) corners.push_back(p.at);
  const double across = std::sqrt(1 - 0.4 * 0.4);
  const std::vector<GlyphPoint> expected{{10.4, -across}, {10.4, across}, {2, 5 * across}, {2, -5 * across}};
  ASSERT_EQ(corners.size(), expected.size());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(geometry::distance(corners[i], expected[i]), 1e-9) << i;
  // 133 degrees around the small end in two curves, 227 around the large one in three.
  EXPECT_EQ(drop[0].size(), 4U + 2U + 3U);
}

TEST(StrokeOutline, ASharpJoinIsAnArcOutsideAndARoundedCornerInside) {
  // Inside, the sides meet at (16, 4). The curve may be half a unit from them: it begins two units away.
  const auto corner = outlined({{{0, 0}, 4}, {{20, 0}, 4}, {{20, 20}, 4}}, 0.5);
  ASSERT_EQ(corner.size(), 1U);
  expect_contour(corner[0],
                 {on(20, -4), off(24, -4), on(24, 0), on(24, 20), off(24, 24), off(16, 24), on(16, 20),
                  on(16, 6), off(16, 4), on(14, 4), on(0, 4), off(-4, 4), off(-4, -4), on(0, -4)});
  // The other way round it is mirrored.
  const auto mirrored = outlined({{{0, 0}, 4}, {{20, 0}, 4}, {{20, -20}, 4}}, 0.5);
  ASSERT_EQ(mirrored.size(), 1U);
  expect_contour(mirrored[0],
                 {on(14, -4), off(16, -4), on(16, -6), on(16, -20), off(16, -24), off(24, -24), on(24, -20),
                  on(24, 0), off(24, 4), on(20, 4), on(0, 4), off(-4, 4), off(-4, -4), on(0, -4)});
}

TEST(StrokeOutline, InsideAJoinOfShortPartsTheContourGoesThroughTheCentre) {
  // The sides would meet 4 units from the centre, past 45 % of a part of 8.
  const auto corner = outlined({{{0, 0}, 4}, {{8, 0}, 4}, {{8, 8}, 4}}, 0.5);
  ASSERT_EQ(corner.size(), 1U);
  expect_contour(corner[0], {on(8, -4), off(12, -4), on(12, 0), on(12, 8), off(12, 12), off(4, 12), on(4, 8),
                             on(4, 0), on(8, 0), on(8, 4), on(0, 4), off(-4, 4), off(-4, -4), on(0, -4)});
}

TEST(StrokeOutline, AGentleBendIsACurveOnBothSides) {
  const double half = std::atan2(4, 20) / 2;
  const auto bend = outlined({{{0, 0}, 1}, {{20, 0}, 1}, {{40, 4}, 1}}, 0.1);
  ASSERT_EQ(bend.size(), 1U);
  const auto has_control = [&](GlyphPoint at) {
    for (const OutlinePoint& p : bend[0])
      if (!p.on_curve && geometry::distance(p.at, at) < 1e-9) return true;
    return false;
  };
  EXPECT_TRUE(has_control({20 + std::tan(half), -1}));
  EXPECT_TRUE(has_control({20 - std::tan(half), 1}));
}

TEST(StrokeOutline, WhereALineTurnsBackOneSideHasTheHalfDisc) {
  const auto back = outlined({{{0, 0}, 2}, {{10, 0}, 2}, {{0, 0}, 2}}, 0.5);
  ASSERT_EQ(back.size(), 1U);
  expect_contour(
      back[0], {on(10, -2), off(12, -2), off(12, 2), on(10, 2), on(0, 2), off(-2, 2), off(-2, -2), on(0, -2),
                on(10, -2), on(10, 0), on(10, 2), on(0, 2), off(-2, 2), off(-2, -2), on(0, -2)});
}

TEST(StrokeOutline, ADiscWithinItsNeighbourIsHidden) {
  const Disc large{{0, 0}, 5};
  const Disc small{{1, 0}, 1};
  const auto first_at = [](const OutlineContour& contour) { return contour.front().at; };
  for (const auto& discs : {std::vector{large, small}, std::vector{small, large}, std::vector{large, large},
                            std::vector{small, large, small}, std::vector{large, large, large}}) {
    const auto contours = outlined(discs, 1);
    ASSERT_EQ(contours.size(), 1U);
    EXPECT_EQ(first_at(contours[0]), (GlyphPoint{0, -5}));
  }
  EXPECT_EQ(outlined({small}, 1).size(), 1U);
  // A disc that just reaches the rim of the larger one is within it; one a little farther is not.
  EXPECT_EQ(outlined({large, {{4, 0}, 1}}, 1)[0][0].at, (GlyphPoint{0, -5}));
  EXPECT_GT(outlined({large, {{4.01, 0}, 1}}, 1)[0][0].at.x, 4);
}

TEST(StrokeOutline, ALineEndsWhereTheNextDiscHasItAllAndAnotherBegins) {
  const auto contours = outlined({{{0, 0}, 1}, {{10, 0}, 1}, {{11, 0}, 5}}, 1);
  ASSERT_EQ(contours.size(), 2U);
  EXPECT_EQ(contours[0].size(), 8U) << "a bar";
  EXPECT_EQ(contours[1].size(), 5U) << "a disc";
  // The small disc at the end of a bar needs no contour, the bar after it does.
  EXPECT_EQ(outlined({{{0, 0}, 5}, {{20, 0}, 5}, {{21, 0}, 1}}, 1).size(), 1U);
  EXPECT_EQ(outlined({{{0, 0}, 5}, {{1, 0}, 1}, {{20, 0}, 1}}, 1).size(), 2U);
}

TEST(DistanceOfDiscs, IsThatOfTheirCentresAndOfTheirRadii) {
  const Disc a{{0, 0}, 1};
  const Disc b{{10, 0}, 2};
  EXPECT_DOUBLE_EQ(distance_to_segment(Disc{{5, 3}, 2}, a, b), 3 + 0.5);
  EXPECT_DOUBLE_EQ(distance_to_segment(Disc{{2, -3}, 1}, a, b), 3 + 0.2);
  EXPECT_DOUBLE_EQ(distance_to_segment(Disc{{13, 4}, 1}, a, b), 5 + 1);
  EXPECT_DOUBLE_EQ(distance_to_segment(Disc{{-3, 4}, 1}, a, b), 5);
}

TEST(ThinnedDiscs, KeepTheEndsAndOneOfEachBlock) {
  std::vector<Disc> line;
  for (int i = 0; i < 8; ++i) line.push_back({{2.0 * i, 0}, 1 + 0.5 * i});
  const auto kept = [&](std::span<const Disc> discs, std::size_t block) {
    std::vector<double> places;
    for (const Disc& disc : thinned_discs(discs, 0.1, block)) places.push_back(disc.at.x);
    return places;
  };
  EXPECT_EQ(kept(line, 512), (std::vector<double>{0, 14}));
  EXPECT_EQ(kept(line, 3), (std::vector<double>{0, 6, 12, 14}));
  EXPECT_EQ(kept(std::span(line).first(7), 3), (std::vector<double>{0, 6, 12}));
  EXPECT_EQ(kept(std::span(line).first(1), 3), (std::vector<double>{0}));
  line[5].radius += 0.12;
  EXPECT_EQ(kept(line, 512), (std::vector<double>{0, 10, 14}));
  line[5].radius -= 0.03;
  EXPECT_EQ(kept(line, 512), (std::vector<double>{0, 14})) << "within the tolerance";
}

double radius_at(const std::vector<Disc>& discs, double x) {
  for (std::size_t i = 1; i < discs.size(); ++i)
    if (discs[i].at.x >= x) {
      const Disc& a = discs[i - 1];
      return std::lerp(a.radius, discs[i].radius, (x - a.at.x) / (discs[i].at.x - a.at.x));
    }
  return discs.back().radius;
}

TEST(DiscsOf, ALineThinsOutToItsTipsAndNoFurther) {
  const RadiusFloor floor{1, 0.2, 5};
  const carving::Groove hairline{{{10, 50}, 0, 1}, {{50, 50}, 0, 1}};
  const std::vector<Disc> discs = discs_of(hairline, floor, 0.001);
  EXPECT_EQ(discs.front(), (Disc{{10, 50}, 0.2}));
  EXPECT_EQ(discs.back(), (Disc{{50, 50}, 0.2}));
  for (const auto& [x, radius] :
       {std::pair{12.5, 0.6}, std::pair{20.0, 1.0}, std::pair{40.0, 1.0}, std::pair{47.5, 0.6}})
    EXPECT_NEAR(radius_at(discs, x), radius, 0.01) << x;
  // Of a short line the tips are a quarter at each end.
  const carving::Groove small{{{10, 50}, 0, 1}, {{18, 50}, 0, 1}};
  const std::vector<Disc> few = discs_of(small, floor, 0.001);
  for (const auto& [x, radius] :
       {std::pair{11.0, 0.6}, std::pair{12.0, 1.0}, std::pair{16.0, 1.0}, std::pair{17.0, 0.6}})
    EXPECT_NEAR(radius_at(few, x), radius, 0.01) << x;
  // Where the groove is wider, it is as wide as that.
  const carving::Groove wide{{{10, 50}, 3, 1}, {{50, 50}, 3, 1}};
  EXPECT_EQ(discs_of(wide, floor, 0.001), (std::vector<Disc>{{{10, 50}, 3}, {{50, 50}, 3}}));
}

TEST(DiscsOf, ADotHasTheRadiusOfTheBody) {
  const RadiusFloor floor{1, 0.2, 5};
  EXPECT_EQ(discs_of({{{30, 40}, 0.5, 1}}, floor, 0.01), (std::vector<Disc>{{{30, 40}, 1}}));
  EXPECT_EQ(discs_of({{{30, 40}, 2.5, 1}}, floor, 0.01), (std::vector<Disc>{{{30, 40}, 2.5}}));
}

}  // namespace
}  // namespace nazori::author
