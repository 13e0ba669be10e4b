// SPDX-License-Identifier: Apache-2.0
#include "../src/centre_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "../src/brush.h"
#include "nazori/carving/groove.h"
#include "nazori/geometry/polyline.h"
#include "test_strokes.h"

namespace nazori::carving {
namespace {

using namespace test;

constexpr double kPi = std::numbers::pi;
constexpr int kSize = 1091;  // ten samples a glyph unit
constexpr double kScale = 10;

GlyphPoint place(const Joint& joint) { return {joint.x / kScale, joint.y / kScale}; }

/// All joints in order; the joint between two pieces appears twice.
std::vector<Joint> joints_of(const std::vector<Piece>& pieces) {
  std::vector<Joint> joints;
  for (const Piece& piece : pieces) joints.insert(joints.end(), piece.joints.begin(), piece.joints.end());
  return joints;
}

/// Points on a circle about the middle, from `from` to `to` degrees.
StrokeLine arc(double radius, int from, int to, int step) {
  StrokeLine line;
  for (int degree = from; degree <= to; degree += step) {
    const double a = degree * kPi / 180;
    line.points.push_back({54.5 + radius * std::cos(a), 54.5 + radius * std::sin(a)});
  }
  return line;
}

TEST(TurnAt, IsTheAngleBetweenTheWaysToAndFromAPoint) {
  const std::vector<GlyphPoint> corner{{0, 0}, {10, 0}, {10, 10}};
  for (const double reach : {1.0, 10.0, 50.0})
    EXPECT_NEAR(turn_at(corner, 1, reach), kPi / 2, 1e-12) << reach;
  EXPECT_EQ(turn_at(corner, 0, 1), 0);
  EXPECT_EQ(turn_at(corner, 2, 1), 0);
  EXPECT_NEAR(turn_at(std::vector<GlyphPoint>{{0, 0}, {10, 0}, {3, 0}}, 1, 2), kPi, 1e-12) << "back again";
  EXPECT_NEAR(turn_at(std::vector<GlyphPoint>{{0, 0}, {5, 0}, {10, 0}}, 1, 2), 0, 1e-12);
}

TEST(TurnAt, LooksAlongTheLineAsFarAsItIsTold) {
  // Three units before the point and three after it the line bends at right angles.
  const std::vector<GlyphPoint> line{{-3, -9}, {-3, 0}, {0, 0}, {3, 0}, {3, -9}};
  EXPECT_NEAR(turn_at(line, 2, 3), 0, 1e-12);
  EXPECT_NEAR(turn_at(line, 2, 6), kPi / 2, 1e-12);
  EXPECT_NEAR(turn_at(line, 2, 7), 2 * std::atan2(4, 3), 1e-12);
  EXPECT_NEAR(turn_at(line, 2, 100), 2 * std::atan2(9, 3), 1e-12);
  const std::vector<GlyphPoint> repeated{{-3, -9}, {-3, 0}, {-3, 0}, {0, 0}, {3, 0}, {3, 0}, {3, -9}};
  EXPECT_NEAR(turn_at(repeated, 3, 6), kPi / 2, 1e-12);
}

TEST(Trace, OfAStraightEvenStrokeHasTwoJointsAndRoundEnds) {
  const std::vector<Piece> pieces = trace(stroke({{10, 20}, {50, 50}}), even_brush(6), kSize);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_TRUE(pieces[0].round_start);
  EXPECT_TRUE(pieces[0].round_end);
  ASSERT_EQ(pieces[0].joints.size(), 2U);
  EXPECT_NEAR(geometry::distance(place(pieces[0].joints[0]), GlyphPoint{10, 20}), 0, 1e-9);
  EXPECT_NEAR(geometry::distance(place(pieces[0].joints[1]), GlyphPoint{50, 50}), 0, 1e-9);
  for (const Joint& joint : pieces[0].joints) {
    EXPECT_NEAR(joint.forward_x, 0.8, 1e-12);
    EXPECT_NEAR(joint.forward_y, 0.6, 1e-12);
    EXPECT_NEAR(joint.half_width, 30, 1e-9);
    EXPECT_EQ(joint.depth, 1);
    EXPECT_FALSE(joint.needs_disc);
  }
}

TEST(Trace, OfAPointIsOneJoint) {
  for (const auto& line : {stroke({{30, 40}}), stroke({{30, 40}, {30, 40}}, StrokeEnding::hook)}) {
    const std::vector<Piece> pieces = trace(line, plain_brush(6), kSize);
    ASSERT_EQ(pieces.size(), 1U);
    ASSERT_EQ(pieces[0].joints.size(), 1U);
    EXPECT_NEAR(pieces[0].joints[0].x, 300, 1e-9);
    EXPECT_NEAR(pieces[0].joints[0].y, 400, 1e-9);
    EXPECT_EQ(pieces[0].joints[0].depth, 1);
  }
}

TEST(Trace, TakesALineApartAtEachSharpCornerWhereBothSidesEndSquare) {
  // 41 degrees are a corner, 39 are none.
  const auto line = stroke({{10, 10}, {60, 10}, {60, 60}, {20, 60}});
  const std::vector<Piece> pieces = trace(line, even_brush(6), kSize);
  ASSERT_EQ(pieces.size(), 3U);
  const GlyphPoint ways[] = {{1, 0}, {0, 1}, {-1, 0}};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_TRUE(pieces[k].round_start && pieces[k].round_end);
    ASSERT_EQ(pieces[k].joints.size(), 2U);
    EXPECT_NEAR(geometry::distance(place(pieces[k].joints[0]), line.points[k]), 0, 1e-9);
    EXPECT_NEAR(geometry::distance(place(pieces[k].joints[1]), line.points[k + 1]), 0, 1e-9);
    for (const Joint& joint : pieces[k].joints) {
      EXPECT_NEAR(joint.forward_x, ways[k].x, 1e-9);
      EXPECT_NEAR(joint.forward_y, ways[k].y, 1e-9);
      EXPECT_FALSE(joint.needs_disc);
    }
  }
  const auto bend = [](double degrees) {
    const double a = degrees * kPi / 180;
    return trace(stroke({{10, 50}, {50, 50}, {50 + 40 * std::cos(a), 50 + 40 * std::sin(a)}}), even_brush(6),
                 kSize);
  };
  EXPECT_EQ(bend(41).size(), 2U);
  EXPECT_EQ(bend(39).size(), 1U);
  EXPECT_EQ(bend(-41).size(), 2U);
}

TEST(Trace, PassesThroughTheGivenPointsAndStaysNearTheirChords) {
  for (const double degrees : {5.0, 20.0, 39.0}) {
    StrokeLine line = stroke({{15, 20}});
    double a = 0;
    for (int i = 0; i < 5; ++i) {
      line.points.push_back(line.points.back() +
                            GlyphPoint{std::cos(a), std::sin(a)} * (i % 2 == 0 ? 18 : 3));
      a += (i % 2 == 0 ? 1 : -0.7) * degrees * kPi / 180;
    }
    std::vector<GlyphPoint> walked;
    for (const Joint& joint : joints_of(trace(line, even_brush(4), kSize))) walked.push_back(place(joint));
    for (const GlyphPoint p : line.points)
      EXPECT_LT(geometry::nearest_point(std::span<const GlyphPoint>(walked), p).distance, 1e-9) << degrees;
    for (const GlyphPoint p : walked)
      EXPECT_LT(geometry::nearest_point(std::span<const GlyphPoint>(line.points), p).distance, 0.15)
          << degrees;
  }
}

TEST(Trace, PointsOfAnArcAreFollowedAsAnArcUpToItsEnds) {
  for (const double radius : {12.0, 30.0}) {
    const std::vector<Piece> pieces = trace(arc(radius, 0, 100, 10), even_brush(4), kSize);
    ASSERT_EQ(pieces.size(), 1U);
    for (const Joint& joint : pieces[0].joints) {
      const GlyphPoint from_middle = place(joint) - GlyphPoint{54.5, 54.5};
      // The chords leave the arc by 0.004 of its radius.
      EXPECT_NEAR(geometry::length(from_middle), radius, 1e-4 * radius);
    }
  }
}

TEST(Trace, NeighbouringJointsTurnSoLittleThatItCannotBeFelt) {
  for (const int size : {200, 512, 1091, 4096}) {
    const std::vector<Joint> joints = trace(arc(30, -20, 80, 10), even_brush(4), size)[0].joints;
    double most = 0;
    for (std::size_t i = 1; i + 1 < joints.size(); ++i) {
      const GlyphPoint before{joints[i].x - joints[i - 1].x, joints[i].y - joints[i - 1].y};
      const GlyphPoint after{joints[i + 1].x - joints[i].x, joints[i + 1].y - joints[i].y};
      const double turn = std::atan2(before.x * after.y - before.y * after.x, geometry::dot(before, after));
      EXPECT_GT(turn, 0);
      most = std::max(most, turn);
      // The direction at a joint is halfway between those before and after it.
      const double forward = std::atan2(joints[i].forward_y, joints[i].forward_x);
      EXPECT_NEAR(forward, (std::atan2(before.y, before.x) + std::atan2(after.y, after.x)) / 2, 2e-3) << i;
      EXPECT_NEAR(std::hypot(joints[i].forward_x, joints[i].forward_y), 1, 1e-12);
    }
    // As 12 samples turn by a radian, at least 0.012 and at most 0.06; no finer than half of that.
    const double wanted = std::clamp(12.0 / size, 0.012, 0.06);
    EXPECT_LT(most, wanted) << size;
    EXPECT_GT(most, wanted / 2) << size;
  }
}

TEST(Trace, ALongBendIsCutWhereItIsGentle) {
  // A spiral of a full turn and more, so that it may cross itself.
  StrokeLine line;
  for (int degree = 0; degree <= 400; degree += 10) {
    const double a = degree * kPi / 180;
    line.points.push_back(GlyphPoint{54.5, 54.5} +
                          GlyphPoint{std::cos(a), std::sin(a)} * (20 + degree * 0.05));
  }
  const std::vector<Piece> pieces = trace(line, even_brush(4), kSize);
  ASSERT_EQ(pieces.size(), 4U) << "each turns by 120 degrees, the last by what is left";
  EXPECT_TRUE(pieces.front().round_start);
  EXPECT_TRUE(pieces.back().round_end);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Joint& first = pieces[k].joints.front();
    const Joint& last = pieces[k].joints.back();
    const double turned = std::atan2(first.forward_x * last.forward_y - first.forward_y * last.forward_x,
                                     first.forward_x * last.forward_x + first.forward_y * last.forward_y);
    if (k + 1 == pieces.size()) break;
    EXPECT_NEAR(turned, 2 * kPi / 3, 0.05) << k;
    EXPECT_FALSE(pieces[k].round_end);
    EXPECT_FALSE(pieces[k + 1].round_start);
    const Joint& next = pieces[k + 1].joints.front();
    EXPECT_EQ(last.x, next.x);
    EXPECT_EQ(last.y, next.y);
    EXPECT_EQ(last.forward_x, next.forward_x) << "both sides share the cut";
    EXPECT_EQ(last.forward_y, next.forward_y);
    EXPECT_EQ(last.half_width, next.half_width);
  }
}

TEST(Trace, ACornerAfterALongBendEndsRoundAndIsNoPlaceToCutTheBend) {
  StrokeLine line = arc(30, 0, 110, 10);
  line.points.push_back(line.points.back() + GlyphPoint{0, 20});
  const std::vector<Piece> pieces = trace(line, even_brush(4), kSize);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_TRUE(pieces[0].round_end);
  EXPECT_TRUE(pieces[1].round_start);
}

TEST(Trace, ABendTighterThanTheGrooveIsPressedDiscByDisc) {
  const auto discs = [](double radius) {
    // Gentle bends before and after half a turn.
    StrokeLine line = stroke({{54.5 + radius, 10}});
    const StrokeLine bend = arc(radius, 0, 180, 5);
    line.points.insert(line.points.end(), bend.points.begin(), bend.points.end());
    line.points.push_back({54.5 - radius, 10});
    const std::vector<Joint> joints = joints_of(trace(line, even_brush(10), kSize));
    std::size_t in_bend = 0;
    std::size_t elsewhere = 0;
    for (const Joint& joint : joints)
      (place(joint).y > 54.5 + 1 ? in_bend : elsewhere) += joint.needs_disc ? 1 : 0;
    for (const Joint& joint : joints)
      if (place(joint).y < 54.5 - 6) {
        EXPECT_FALSE(joint.needs_disc) << radius;
      }
    return in_bend;
  };
  // Over a half width of 5 units the line turns by 5 / R radians; more than 0.85 is tight.
  EXPECT_GT(discs(5.5), 20U);
  EXPECT_EQ(discs(6.5), 0U);
  EXPECT_EQ(discs(20), 0U);
}

TEST(Trace, ABendThatIsTightUpToTheEndOfTheStrokeEndsSquare) {
  const std::vector<Piece> pieces = trace(arc(2.5, 0, 180, 5), even_brush(10), kSize);
  const std::vector<Joint>& last = pieces.back().joints;
  ASSERT_GT(last.size(), 3U);
  EXPECT_TRUE(last[last.size() - 2].needs_disc);
  EXPECT_FALSE(last.back().needs_disc);
}

TEST(Trace, TakesALineApartAtEachBendThatIsSharpWithinAGroovesWidth) {
  // Two right angles, rounded in steps of 22.5 degrees, of which none is a corner.
  StrokeLine line = stroke({{20, 20}});
  const auto add_bend = [&line](GlyphPoint middle, double from) {
    for (int i = 0; i <= 4; ++i) {
      const double a = (from + 22.5 * i) * kPi / 180;
      line.points.push_back(middle + GlyphPoint{std::cos(a), std::sin(a)} * 0.8);
    }
  };
  add_bend({50, 20.8}, -90);
  add_bend({50, 60}, 0);
  line.points.push_back({20, 60.8});
  const std::vector<Piece> pieces = trace(line, even_brush(6), kSize);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_LT(geometry::distance(place(pieces[1].joints.front()), GlyphPoint{50.6, 20.2}), 0.5);
  EXPECT_LT(geometry::distance(place(pieces[1].joints.back()), GlyphPoint{50.6, 60.6}), 0.5);
}

TEST(Trace, TheWallsOfAKickHaveNoDiscs) {
  StrokeLine line = stroke({{60, 10}}, StrokeEnding::hook);
  for (int degree = 0; degree <= 120; degree += 10) {
    const double a = degree * kPi / 180;
    line.points.push_back({58 + 2 * std::cos(a), 70 + 2 * std::sin(a)});
  }
  line.points.push_back(line.points.back() + GlyphPoint{-std::sin(2.1), std::cos(2.1)} * 6);
  const double length = geometry::arc_length(std::span<const GlyphPoint>(line.points));
  const double hook = hook_length(line);
  ASSERT_GT(hook, 5);
  for (const Joint& joint : joints_of(trace(line, plain_brush(8), kSize))) {
    const double s =
        geometry::nearest_point(std::span<const GlyphPoint>(line.points), place(joint)).arc_length;
    if (s > length - hook + 0.2) {
      EXPECT_FALSE(joint.needs_disc) << s;
    }
  }
}

TEST(Trace, WhereAGrooveNarrowsByMoreThanATwentiethItsTightBendsHaveNoDiscs) {
  const auto discs = [](double narrows) {
    const StrokeLine bend = arc(3, 0, 180, 10);
    Groove groove;
    double s = 0;
    for (std::size_t i = 0; i < bend.points.size(); ++i) {
      if (i > 0) s += geometry::distance(bend.points[i - 1], bend.points[i]);
      groove.push_back({bend.points[i], 6 - narrows * s, 1});
    }
    const std::vector<Joint> joints = joints_of(trace(groove, kSize));
    return std::count_if(joints.begin(), joints.end(), [](const Joint& joint) { return joint.needs_disc; });
  };
  EXPECT_GT(discs(0), 3);
  EXPECT_GT(discs(0.04), 3);
  EXPECT_EQ(discs(0.06), 0);
  EXPECT_GT(discs(-0.06), 3) << "walls that open hold a disc";
}

TEST(Trace, PointsThatAreAMillionthApartAreOne) {
  const auto joints = [](double apart) {
    return joints_of(trace(stroke({{20, 50}, {60, 50}, {60 + apart, 50}}), even_brush(6), kSize)).size();
  };
  EXPECT_EQ(joints(0.9e-6), 2U);
  EXPECT_EQ(joints(1.2e-6), 3U);
}

TEST(Trace, HasJointsWhereTheBrushChangesAndNoneWhereItDoesNot) {
  constexpr double kWidth = 8;
  constexpr double kLength = 80;
  for (const auto ending : {StrokeEnding::stop, StrokeEnding::taper}) {
    const Brush brush = plain_brush(kWidth);
    const auto line = stroke({{10, 50}, {10 + kLength, 50}}, ending);
    const BrushZones zones = zones_of(brush, ending, kLength, 0);
    std::vector<double> at;
    for (const Joint& joint : joints_of(trace(line, brush, kSize))) {
      const double s = joint.x / kScale - 10;
      at.push_back(s);
      const BrushMark mark = brush_at(brush, ending, s, kLength);
      EXPECT_NEAR(joint.half_width, mark.half_width * kScale, 1e-9) << s;
      EXPECT_NEAR(joint.depth, mark.depth, 1e-12) << s;
    }
    const auto has = [&](double s) {
      return std::any_of(at.begin(), at.end(), [&](double other) { return std::abs(other - s) < 1e-6; });
    };
    EXPECT_TRUE(has(0) && has(zones.entry_end) && has(zones.ending_start) && has(kLength));
    for (std::size_t i = 1; i < at.size(); ++i) {
      EXPECT_GT(at[i], at[i - 1]);
      // A step is about one and a half samples, and no zone has more than 96 of them.
      const bool changes = at[i] <= zones.entry_end + 1e-9 || at[i] > zones.ending_start + 1e-9;
      const double zone = at[i] <= zones.entry_end + 1e-9 ? zones.entry_end : kLength - zones.ending_start;
      if (changes) {
        EXPECT_LT(at[i] - at[i - 1], std::max(0.15, zone / 96) * 1.001) << at[i];
      }
    }
    EXPECT_EQ(
        std::count_if(at.begin(), at.end(),
                      [&](double s) { return s > zones.entry_end + 1e-6 && s < zones.ending_start - 1e-6; }),
        0);
  }
}

TEST(Trace, OnACoarseGridTheEndingsStillHaveTheirShape) {
  // Eight joints make an entry, twelve an ending, however few samples they have.
  const auto joints = joints_of(trace(stroke({{10, 50}, {90, 50}}), plain_brush(8), 20));
  EXPECT_GE(joints.size(), 8U + 12U + 1U);
  EXPECT_LE(joints.size(), 8U + 12U + 4U);
}

TEST(Trace, FollowedAsTheGridShowsNoFacetOfABendIsShorterThanASample) {
  const std::vector<Joint> joints =
      joints_of(trace(arc(20, 0, 120, 30), even_brush(4), 129, Detail::samples));
  for (std::size_t i = 1; i < joints.size(); ++i)
    EXPECT_GT(std::hypot(joints[i].x - joints[i - 1].x, joints[i].y - joints[i - 1].y), 0.95);
}

TEST(Trace, FollowedAsTheGridShowsItALineHasNoMoreJointsThanSamples) {
  StrokeLine line;
  for (int i = 0; i <= 20'000; ++i) {
    const double t = i / 20'000.0;
    line.points.push_back({10 + 89 * t, 54.5 + 20 * std::sin(6 * t)});
  }
  const double length = geometry::arc_length(std::span<const GlyphPoint>(line.points));
  const auto joints = joints_of(trace(line, even_brush(6), 129, Detail::samples));
  const double samples = length * 128 / 109;
  EXPECT_LE(static_cast<double>(joints.size()), 2 * samples + 8);
  EXPECT_GE(static_cast<double>(joints.size()), samples);
  for (const Joint& joint : joints) {
    const GlyphPoint p{joint.x * 109 / 128, joint.y * 109 / 128};
    EXPECT_LT(geometry::nearest_point(std::span<const GlyphPoint>(line.points), p).distance, 0.02);
  }
}

}  // namespace
}  // namespace nazori::carving
