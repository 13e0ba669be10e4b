// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <span>

#include "nazori/geometry/polyline.h"

namespace nazori::geometry {
namespace {

using Line = Polyline<GlyphFrame>;
using Span = std::span<const GlyphPoint>;

Line random_line(std::mt19937& random, int points) {
  std::uniform_real_distribution<double> coordinate(0, 109);
  Line line;
  for (int i = 0; i < points; ++i) line.push_back({coordinate(random), coordinate(random)});
  return line;
}

TEST(ArcLength, OfARightAngleIsTheSumOfItsLegs) {
  EXPECT_DOUBLE_EQ(arc_length(Span(Line{{0, 0}, {3, 0}, {3, 4}})), 7);
  EXPECT_DOUBLE_EQ(arc_length(Span(Line{{5, 5}})), 0);
  EXPECT_DOUBLE_EQ(arc_length(Span(Line{})), 0);
}

TEST(ArcLength, OfAFineCircleIsItsCircumference) {
  Line circle;
  for (int i = 0; i <= 3600; ++i) {
    const double angle = 2 * std::numbers::pi * i / 3600;
    circle.push_back({10 * std::cos(angle), 10 * std::sin(angle)});
  }
  EXPECT_NEAR(arc_length(Span(circle)), 20 * std::numbers::pi, 1e-4);
}

TEST(NearestPoint, LiesAtTheFootOfThePerpendicular) {
  const Line line{{0, 0}, {10, 0}, {10, 10}};
  const auto foot = nearest_point(Span(line), {4, 3});
  EXPECT_EQ(foot.point, (GlyphPoint{4, 0}));
  EXPECT_DOUBLE_EQ(foot.distance, 3);
  EXPECT_DOUBLE_EQ(foot.arc_length, 4);
  EXPECT_EQ(foot.segment, 0U);
  const auto second = nearest_point(Span(line), {12, 6});
  EXPECT_EQ(second.point, (GlyphPoint{10, 6}));
  EXPECT_DOUBLE_EQ(second.arc_length, 16);
  EXPECT_EQ(second.segment, 1U);
}

TEST(NearestPoint, OfPointsBeyondTheEndsIsTheEnd) {
  const Line line{{0, 0}, {10, 0}};
  EXPECT_EQ(nearest_point(Span(line), {-3, 4}).point, (GlyphPoint{0, 0}));
  EXPECT_DOUBLE_EQ(nearest_point(Span(line), {-3, 4}).distance, 5);
  EXPECT_EQ(nearest_point(Span(line), {-3, 4}).arc_length, 0);
  EXPECT_EQ(nearest_point(Span(line), {-3, 4}).segment, 0U);
  EXPECT_EQ(nearest_point(Span(line), {13, -4}).point, (GlyphPoint{10, 0}));
  EXPECT_EQ(nearest_point(Span(line), {13, -4}).arc_length, 10);
}

TEST(NearestPoint, OfSeveralAtTheSameDistanceIsTheFirst) {
  const Line hairpin{{0, 0}, {10, 0}, {10, 4}, {0, 4}};
  const auto between = nearest_point(Span(hairpin), {5, 2});
  EXPECT_EQ(between.arc_length, 5);
  EXPECT_EQ(between.segment, 0U);
  const auto corner = nearest_point(Span(hairpin), {13, -4});
  EXPECT_EQ(corner.point, (GlyphPoint{10, 0}));
  EXPECT_EQ(corner.segment, 0U);
}

TEST(NearestPoint, OfASinglePointOrARepeatedOneIsThatPoint) {
  EXPECT_DOUBLE_EQ(nearest_point(Span(Line{{1, 1}}), {4, 5}).distance, 5);
  EXPECT_DOUBLE_EQ(nearest_point(Span(Line{{1, 1}, {1, 1}}), {4, 5}).distance, 5);
}

TEST(NearestPoint, IsNeverFartherThanAnyPointOfADenseWalk) {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    const Line line = random_line(random, 6);
    const Line walk = resample(Span(line), 4000);
    const GlyphPoint p = random_line(random, 1)[0];
    const auto nearest = nearest_point(Span(line), p);
    double best = 1e9;
    for (const GlyphPoint w : walk) best = std::min(best, distance(w, p));
    EXPECT_LE(nearest.distance, best + 1e-9);
    EXPECT_NEAR(nearest.distance, best, arc_length(Span(line)) / 4000);
    EXPECT_NEAR(distance(point_at(Span(line), nearest.arc_length), nearest.point), 0, 1e-9);
  }
}

TEST(NearestPointBetween, LooksOnlyAtThePartAsked) {
  // A hairpin: the way back passes nearer to the point than the way there.
  const Line line{{0, 0}, {10, 0}, {10, 1}, {0, 1}};
  const GlyphPoint p{4, 2};
  const auto there = nearest_point_between(Span(line), p, 0, 10);
  EXPECT_DOUBLE_EQ(there.distance, 2);
  EXPECT_DOUBLE_EQ(there.arc_length, 4);
  EXPECT_EQ(there.segment, 0U);
  const auto later = nearest_point_between(Span(line), p, 6, 10.5);
  EXPECT_DOUBLE_EQ(later.arc_length, 6);
  EXPECT_DOUBLE_EQ(later.point.x, 6);
  const auto back = nearest_point_between(Span(line), p, 10, 40);
  EXPECT_DOUBLE_EQ(back.distance, 1);
  EXPECT_DOUBLE_EQ(back.arc_length, 17);
  EXPECT_EQ(back.segment, 2U);
}

TEST(NearestPointBetween, ACornerOutsideThePartIsNotTaken) {
  const Line line{{0, 0}, {10, 0}, {10, 1}, {0, 1}};
  const auto after = nearest_point_between(Span(line), {12, -1}, 10.5, 11);
  EXPECT_EQ(after.point, (GlyphPoint{10, 0.5}));
  EXPECT_EQ(after.arc_length, 10.5);
  EXPECT_EQ(after.segment, 1U);
  const auto before = nearest_point_between(Span(line), {12, 2}, 0, 5);
  EXPECT_EQ(before.point, (GlyphPoint{5, 0}));
  EXPECT_EQ(before.arc_length, 5);
  const auto only = nearest_point_between(Span(line), {3, 9}, 10.25, 10.25);
  EXPECT_EQ(only.point, (GlyphPoint{10, 0.25}));
}

TEST(NearestPointBetween, OfSeveralAtTheSameDistanceIsTheFirst) {
  const Line line{{0, 0}, {10, 0}, {10, 4}, {0, 4}};
  EXPECT_EQ(nearest_point_between(Span(line), {5, 2}, 0, 24).arc_length, 5);
  EXPECT_EQ(nearest_point_between(Span(line), {13, -4}, 10, 24).segment, 0U);
}

TEST(NearestPointBetween, PastTheEndAndOfASinglePointIsTheLastPoint) {
  const auto end = nearest_point_between(Span(Line{{0, 0}, {3, 4}, {3, 4}}), {0, 0}, 6, 9);
  EXPECT_DOUBLE_EQ(end.arc_length, 5);
  EXPECT_DOUBLE_EQ(end.distance, 5);
  EXPECT_EQ(end.segment, 1U);
  EXPECT_EQ(end.point, (GlyphPoint{3, 4}));
  const auto point = nearest_point_between(Span(Line{{1, 1}}), {4, 5}, 0, 1);
  EXPECT_DOUBLE_EQ(point.distance, 5);
  EXPECT_EQ(point.arc_length, 0);
  EXPECT_EQ(point.segment, 0U);
}

TEST(NearestPointBetween, IsNeverFartherThanAnyPointOfADenseWalkOfThePart) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const auto line = random_line(random, 8);
    const GlyphPoint p{50, 50};
    const double from = arc_length(Span(line)) * 0.3;
    const double to = from + 60;
    const auto nearest = nearest_point_between(Span(line), p, from, to);
    EXPECT_GE(nearest.arc_length, from - 1e-9);
    EXPECT_LE(nearest.arc_length, to + 1e-9);
    double walked = std::numeric_limits<double>::infinity();
    for (double s = from; s <= to; s += 0.01) walked = std::min(walked, distance(point_at(Span(line), s), p));
    EXPECT_LE(nearest.distance, walked + 1e-9);
    EXPECT_NEAR(nearest.distance, walked, 0.01);
  }
}

TEST(PointAt, HoldsThePositionWithinTheLine) {
  const Line line{{0, 0}, {10, 0}, {10, 10}};
  EXPECT_EQ(point_at(Span(line), -1), (GlyphPoint{0, 0}));
  EXPECT_EQ(point_at(Span(line), 10), (GlyphPoint{10, 0}));
  EXPECT_EQ(point_at(Span(line), 15), (GlyphPoint{10, 5}));
  EXPECT_EQ(point_at(Span(line), 99), (GlyphPoint{10, 10}));
}

TEST(Resample, KeepsBothEndsAndEvenSteps) {
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    const Line line = random_line(random, 5);
    const Line even = resample(Span(line), 33);
    ASSERT_EQ(even.size(), 33U);
    EXPECT_EQ(even.front(), line.front());
    EXPECT_EQ(even.back(), line.back());
    const double step = arc_length(Span(line)) / 32;
    for (std::size_t i = 0; i < even.size(); ++i) {
      EXPECT_NEAR(distance(even[i], point_at(Span(line), step * static_cast<double>(i))), 0, 1e-9);
    }
  }
}

TEST(PointAt, OfALineWhoseFirstPointIsRepeatedBeginsThere) {
  const Line line{{1, 1}, {1, 1}, {5, 1}};
  EXPECT_EQ(point_at(Span(line), -2), (GlyphPoint{1, 1}));
  EXPECT_EQ(point_at(Span(line), 0), (GlyphPoint{1, 1}));
  EXPECT_EQ(point_at(Span(line), 3), (GlyphPoint{4, 1}));
}

TEST(Resample, PassesOverRepeatedPoints) {
  const Line even{{1, 1}, {3, 1}, {5, 1}};
  EXPECT_EQ(resample(Span(Line{{1, 1}, {1, 1}, {5, 1}}), 3), even);
  EXPECT_EQ(resample(Span(Line{{1, 1}, {3, 1}, {3, 1}, {5, 1}}), 3), even);
  EXPECT_EQ(resample(Span(Line{{1, 1}, {5, 1}, {5, 1}}), 3), even);
  EXPECT_EQ(resample(Span(Line{{1, 1}, {5, 1}}), 2), (Line{{1, 1}, {5, 1}}));
}

TEST(Resample, OfASinglePointRepeatsIt) {
  EXPECT_EQ(resample(Span(Line{{2, 3}}), 3), (Line{{2, 3}, {2, 3}, {2, 3}}));
}

}  // namespace
}  // namespace nazori::geometry
