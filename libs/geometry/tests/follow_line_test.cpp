// SPDX-License-Identifier: Apache-2.0
#include "nazori/geometry/follow_line.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "nazori/geometry/polyline.h"

namespace nazori::geometry {
namespace {

using Line = Polyline<GlyphFrame>;
using Span = std::span<const GlyphPoint>;

TEST(NearestShare, IsTheFootOfThePerpendicularHeldToTheSegment) {
  const GlyphPoint a{1, 1}, b{5, 1};
  EXPECT_DOUBLE_EQ(nearest_share(GlyphPoint{2, 9}, a, b), 0.25);
  EXPECT_EQ(nearest_share(GlyphPoint{-3, 2}, a, b), 0);
  EXPECT_EQ(nearest_share(GlyphPoint{9, 2}, a, b), 1);
  EXPECT_EQ(nearest_share(GlyphPoint{9, 2}, a, a), 0);
  EXPECT_DOUBLE_EQ(distance_to_segment(GlyphPoint{2, 9}, a, b), 8);
  EXPECT_DOUBLE_EQ(distance_to_segment(GlyphPoint{8, 5}, a, b), 5);
  EXPECT_DOUBLE_EQ(distance_to_segment(GlyphPoint{4, 5}, a, a), 5);
}

TEST(AngleBetween, IsThatOfTheDirectionsWhateverTheirLengths) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_NEAR(angle_between(GlyphPoint{2, 0}, GlyphPoint{0, 3}), kPi / 2, 1e-15);
  EXPECT_NEAR(angle_between(GlyphPoint{0, 3}, GlyphPoint{2, 0}), kPi / 2, 1e-15);
  EXPECT_NEAR(angle_between(GlyphPoint{1, 0}, GlyphPoint{-4, 0}), kPi, 1e-15);
  EXPECT_NEAR(angle_between(GlyphPoint{1, 1}, GlyphPoint{0, 1}), kPi / 4, 1e-15);
  EXPECT_EQ(angle_between(GlyphPoint{0, 0}, GlyphPoint{0, 1}), 0);
}

TEST(PlaceAt, ReachesEveryLengthOnItsSegment) {
  const Line line{{0, 0}, {3, 0}, {3, 4}};
  const auto along = arc_lengths<GlyphFrame>(line);
  EXPECT_EQ(along, (std::vector<double>{0, 3, 7}));
  EXPECT_EQ(place_at(along, 1.5).segment, 0U);
  EXPECT_DOUBLE_EQ(place_at(along, 1.5).share, 0.5);
  EXPECT_EQ(place_at(along, 3).segment, 1U) << "the segment that begins there";
  EXPECT_EQ(place_at(along, 3).share, 0);
  EXPECT_EQ(place_at(along, 7).segment, 1U);
  EXPECT_EQ(place_at(along, 7).share, 1);
  EXPECT_EQ(place_at(along, -2).share, 0);
  EXPECT_EQ(place_at(along, 99).share, 1);
  for (double s = 0; s <= 7; s += 0.25) {
    const GlyphPoint p = point_on<GlyphPoint>(line, place_at(along, s));
    const GlyphPoint expected = s < 3 ? GlyphPoint{s, 0} : GlyphPoint{3, s - 3};
    EXPECT_NEAR(distance(p, expected), 0, 1e-14) << s;
  }
}

TEST(PlaceAt, OfOnePointOrOfRepeatedOnesIsThatPoint) {
  const Line one{{4, 5}};
  EXPECT_EQ(point_on<GlyphPoint>(one, place_at(arc_lengths<GlyphFrame>(one), 3)), one[0]);
  const Line repeated{{1, 1}, {1, 1}, {2, 1}, {2, 1}};
  const auto along = arc_lengths<GlyphFrame>(repeated);
  EXPECT_EQ(point_on<GlyphPoint>(repeated, place_at(along, 0)), repeated[0]);
  EXPECT_EQ(point_on<GlyphPoint>(repeated, place_at(along, 9)), repeated[3]);
}

/// The segment to which a point is followed from `segment`, and how many segments were measured.
std::pair<int, int> followed(const Line& line, GlyphPoint p, int segment, const LookPast& past) {
  double nearest = std::numeric_limits<double>::infinity();
  int best = -1, measured = 0;
  const auto nearer = [&](int i) {
    ++measured;
    const auto k = static_cast<std::size_t>(i);
    const double d = distance_to_segment(p, line[k], line[k + 1]);
    if (d >= nearest) return false;
    nearest = d;
    best = i;
    return true;
  };
  const auto length = [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    return distance(line[k], line[k + 1]);
  };
  walk_to_nearest(segment, 0, static_cast<int>(line.size()) - 2, past, nearer, length);
  return {best, measured};
}

TEST(WalkToNearest, GoesWithAPointAlongACircle) {
  Line circle;
  constexpr int kPieces = 360;
  for (int i = 0; i <= kPieces; ++i) {
    const double turn = 2 * std::numbers::pi * i / kPieces;
    circle.push_back({10 * std::cos(turn), 10 * std::sin(turn)});
  }
  int segment = 0;
  for (int i = 0; i < kPieces; ++i) {
    const double turn = 2 * std::numbers::pi * (i + 0.5) / kPieces;
    segment = followed(circle, {12 * std::cos(turn), 12 * std::sin(turn)}, segment, {2, 0}).first;
    EXPECT_EQ(segment, i);
  }
}

// Two legs 1 apart: the nearest segment of all is on the other leg, which is far along the line.
TEST(WalkToNearest, DoesNotJumpToWhereTheLineComesBackNearItself) {
  Line hairpin;
  for (int i = 0; i <= 20; ++i) hairpin.push_back({static_cast<double>(i), 0});
  for (int i = 20; i >= 0; --i) hairpin.push_back({static_cast<double>(i), 1});
  const GlyphPoint p{5.5, 0.7};
  EXPECT_EQ(nearest_point<GlyphFrame>(hairpin, p).segment, 35U);
  EXPECT_EQ(followed(hairpin, p, 5, {2, 0}).first, 5);
  EXPECT_EQ(followed(hairpin, p, 9, {2, 4}).first, 5) << "back along the same leg";
}

TEST(WalkToNearest, EndsAfterSegmentsThatAreNoNearerAndTheirLength) {
  Line straight;
  for (int i = 0; i <= 40; ++i) straight.push_back({static_cast<double>(i), 0});
  const GlyphPoint p{20.5, 1};
  // Both ways from the nearest: two segments, or as many as are shorter than 5 together.
  EXPECT_EQ(followed(straight, p, 20, {2, 0}), (std::pair{20, 1 + 2 + 2}));
  EXPECT_EQ(followed(straight, p, 20, {2, 5}), (std::pair{20, 1 + 5 + 5}));
  EXPECT_EQ(followed(straight, p, 0, {2, 0}).first, 20);
  EXPECT_EQ(followed(straight, {-3, 0}, 0, {2, 0}), (std::pair{0, 3})) << "there is nothing before the first";
}

// From one leg of a sharp kick, past a short overshoot, to the other.
TEST(WalkToNearest, LooksPastAnOvershootAtACorner) {
  const Line kick{{0, 20}, {0, 0}, {0.5, -0.5}, {-3, 3}};
  EXPECT_EQ(followed(kick, {-2, 2}, 0, {2, 0}).first, 2);
  EXPECT_EQ(followed(kick, {-2, 2}, 0, {1, 0}).first, 0);
}

}  // namespace
}  // namespace nazori::geometry
