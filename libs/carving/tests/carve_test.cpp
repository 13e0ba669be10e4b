// SPDX-License-Identifier: Apache-2.0
#include "nazori/carving/carve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "nazori/geometry/polyline.h"
#include "test_strokes.h"

namespace nazori::carving {
namespace {

using namespace test;

/// The largest difference between a map and a closed form over all samples.
template <class Height>
double worst_difference(const surface::HeightMap& map, Height height) {
  double worst = 0;
  for (int y = 0; y < map.size(); ++y) {
    for (int x = 0; x < map.size(); ++x) {
      const GlyphPoint p =
          geometry::grid_to_glyph({static_cast<double>(x), static_cast<double>(y)}, map.size());
      worst = std::max(worst, std::abs(map.at(x, y) - height(p)));
    }
  }
  return worst;
}

double rounded(double distance, double half_width) {
  const double u = 1 - std::pow(std::min(distance / half_width, 1.0), 2);
  return u * u;
}

TEST(Carve, NoStrokesLeaveThePlateauWhole) {
  const auto map = carved({}, 16, {});
  for (const float height : map.samples()) EXPECT_EQ(height, 1.0F);
}

TEST(Carve, AStraightEvenStrokeHasTheRoundedSectionOfItsDistanceEverywhere) {
  const std::vector<GlyphPoint> line{{20, 31}, {83, 70}};
  for (const int size : {97, 128, 401}) {
    Brush brush = even_brush(12);
    brush.depth = 0.8;
    const auto map = carved({{line, StrokeEnding::stop, {}}}, size, brush);
    EXPECT_LT(worst_difference(map,
                               [&](GlyphPoint p) {
                                 const double d =
                                     geometry::nearest_point(std::span<const GlyphPoint>(line), p).distance;
                                 return 1 - 0.8 * rounded(d, 6);
                               }),
              2e-4)
        << size;
  }
}

TEST(Carve, LevelAndUprightStrokesFollowTheClosedFormToo) {
  for (const std::vector<GlyphPoint>& line :
       {std::vector<GlyphPoint>{{10, 50}, {90, 50}}, std::vector<GlyphPoint>{{50, 90}, {50, 10}},
        std::vector<GlyphPoint>{{90, 50}, {10, 50}}, std::vector<GlyphPoint>{{54.5, 54.5}, {54.5, 54.5}}}) {
    const auto map = carved({{line, StrokeEnding::stop, {}}}, 128, even_brush(9));
    EXPECT_LT(worst_difference(
                  map,
                  [&](GlyphPoint p) {
                    return 1 - rounded(geometry::nearest_point(std::span<const GlyphPoint>(line), p).distance,
                                       4.5);
                  }),
              2e-4);
  }
}

TEST(Carve, AnArcGivenByPointsIsCarvedAsAnArcAndNotAsItsChords) {
  constexpr double kRadius = 30;
  StrokeLine line;
  for (int degree = 0; degree <= 180; degree += 10) {
    const double a = degree * std::numbers::pi / 180;
    line.points.push_back({54.5 + kRadius * std::cos(a), 30 + kRadius * std::sin(a)});
  }
  const auto map = carved({line}, 512, even_brush(8));
  // The chords leave the circle by 30 (1 - cos 5°) = 0.114 units, on the wall a height of 0.05.
  const double worst = worst_difference(map, [&](GlyphPoint p) {
    if (p.y < 35) return static_cast<double>(height_at(map, p));  // the ends are tested elsewhere
    return 1 - rounded(std::abs(geometry::distance(p, GlyphPoint{54.5, 30}) - kRadius), 4);
  });
  EXPECT_LT(worst, 0.006);
}

TEST(Carve, ARingAsTightAsTheBrushIsWideIsDeepestOnItsLineAndNotAtItsSeam) {
  // Split into pieces, it would be cut twice where its end meets its start.
  constexpr double kHalfWidth = 10;
  constexpr double kRadius = 9.5;
  StrokeLine line;
  for (int degree = 0; degree <= 360; degree += 10) {
    const double a = degree * std::numbers::pi / 180;
    line.points.push_back({54.5 + kRadius * std::cos(a), 54.5 + kRadius * std::sin(a)});
  }
  const auto map = carved({line}, 257, even_brush(2 * kHalfWidth));
  EXPECT_LT(worst_difference(map,
                             [&](GlyphPoint p) {
                               const double r = geometry::distance(p, GlyphPoint{54.5, 54.5});
                               return 1 - rounded(std::abs(r - kRadius), kHalfWidth);
                             }),
            2e-3);
}

TEST(Carve, AStrokeWithSharpCornersIsCarvedAsItsStraightPartsHoweverCloseTheCornersAre) {
  constexpr int kSize = 257;
  for (const double step : {1.0, 3.0, 12.0}) {
    const std::vector<GlyphPoint> line{
        {20, 40}, {54, 40}, {54, 40 + step}, {54 + step, 40 + step}, {54 + step, 90}};
    std::vector<StrokeLine> parts;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) parts.push_back(stroke({line[i], line[i + 1]}));
    const auto whole = carved({{line, StrokeEnding::stop, {}}}, kSize, even_brush(12));
    const auto apart = carved(parts, kSize, even_brush(12));
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        ASSERT_NEAR(whole.at(x, y), apart.at(x, y), 1e-4) << step << ": " << x << ", " << y;
  }
}

TEST(Carve, TheVSectionHasStraightWalls) {
  const auto map = carved({stroke({{54.5, 10}, {54.5, 99}})}, 1091, even_brush(20, CrossSection::v_shaped));
  const auto depth = [&](double distance) { return 1 - height_at(map, {54.5 + distance, 54.5}); };
  EXPECT_NEAR(depth(0), 1, 1e-4);
  EXPECT_NEAR(depth(10), 0, 1e-4);
  EXPECT_NEAR(depth(5), 0.5, 1e-3);
  const double slope = depth(3) - depth(4);
  for (double d = 2; d < 8; d += 0.5) EXPECT_NEAR(depth(d) - depth(d + 0.5), slope / 2, 1e-3) << d;
  // Rounded at the bottom and the rim: no edge that a fingertip would feel.
  EXPECT_LT(depth(0) - depth(0.2), 0.1 * slope);
  EXPECT_LT(depth(9.8), 0.1 * slope);
}

TEST(Carve, TheFlatSectionIsLevelOverItsMiddleHalf) {
  const auto map =
      carved({stroke({{54.5, 10}, {54.5, 99}})}, 1091, even_brush(20, CrossSection::flat_bottom));
  for (double d = 0; d <= 4.9; d += 0.1) EXPECT_NEAR(height_at(map, {54.5 + d, 54.5}), 0, 1e-4) << d;
  EXPECT_NEAR(height_at(map, {54.5 + 7.5, 54.5}), 0.5, 1e-3);
  EXPECT_EQ(height_at(map, {54.5 + 10.1, 54.5}), 1);
}

TEST(Carve, DepthIsThatOfTheCentreLine) {
  for (const double depth : {0.05, 0.5, 1.0}) {
    for (const auto section : {CrossSection::rounded, CrossSection::v_shaped, CrossSection::flat_bottom}) {
      Brush brush = plain_brush();
      brush.depth = depth;
      brush.cross_section = section;
      const auto map = carved({stroke({{10, 54.5}, {99, 54.5}})}, 219, brush);
      EXPECT_NEAR(height_at(map, {54.5, 54.5}), 1 - depth, 1e-5);
      EXPECT_GE(*std::min_element(map.samples().begin(), map.samples().end()), 1 - depth - 1e-5);
    }
  }
}

TEST(Carve, APointIsCarvedAsADimple) {
  const auto map = carved({stroke({{54.5, 54.5}})}, 219, plain_brush(8));
  EXPECT_LT(height_at(map, {54.5, 54.5}), 1e-5);
  EXPECT_GT(height_at(map, {54.5, 54.5 + 3}), 0.5);
  EXPECT_EQ(height_at(map, {54.5, 54.5 + 6}), 1);
}

TEST(Carve, ReachesInFromOutsideTheBoxAndIgnoresWhatIsFarAway) {
  const auto map =
      carved({stroke({{-3, 20}, {-3, 90}}), stroke({{500, 500}, {-900, 1100}})}, 128, even_brush(10));
  EXPECT_NEAR(height_at(map, {0, 54.5}), 1 - rounded(3, 5), 1e-3);
  EXPECT_EQ(height_at(map, {3, 54.5}), 1);
  EXPECT_EQ(height_at(map, {100, 100}), 1);
}

TEST(Carve, TheSmallestMapWorks) {
  const auto map = carved({stroke({{0, 0}, {109, 109}})}, 2, even_brush(7));
  EXPECT_LT(map.at(0, 0), 1e-5);
  EXPECT_EQ(map.at(1, 0), 1);
}

TEST(Carve, RefusesWhatItCannotCarveAndNamesTheArgument) {
  const std::vector<StrokeLine> good{stroke({{10, 10}, {90, 90}})};
  const auto where = [](const base::Result<surface::HeightMap>& result) {
    return result ? std::string("carved") : result.error().where;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const int size : {0, 1, -5, 8193, 1'000'000}) EXPECT_EQ(where(carve(good, size)), "size");
  for (const double width : {0.49, 40.1, 0.0, -1.0, nan, infinite})
    EXPECT_EQ(where(carve(good, 64, {.width = width})), "brush.width");
  for (const double depth : {0.0, 1.01, -1.0, nan, infinite})
    EXPECT_EQ(where(carve(good, 64, {.depth = depth})), "brush.depth");
  for (const double bad : {nan, infinite, -infinite, 1e300, 1200.0, -1091.0}) {
    EXPECT_EQ(where(carve(std::vector{good[0], stroke({{1, 1}, {bad, 1}})}, 64)), "stroke 2") << bad;
    EXPECT_EQ(where(carve(std::vector{stroke({{1, bad}})}, 64)), "stroke 1") << bad;
  }
  EXPECT_EQ(where(carve(std::vector{stroke({})}, 64)), "stroke 1");
}

TEST(Carve, FitsTheBrushToCrowdedStrokesSoThatARidgeStaysBetweenThem) {
  for (const double pitch : {3.5, 4.0, 5.0, 6.0}) {
    std::vector<StrokeLine> comb;
    for (int i = 0; i < 5; ++i) comb.push_back(stroke({{20, 30 + pitch * i}, {90, 30 + pitch * i}}));
    EXPECT_NEAR(suggested_width(comb), pitch, 1e-6);
    const auto map = carved(comb, 512, {});
    for (int i = 0; i < 4; ++i) {
      EXPECT_LT(height_at(map, {55, 30 + pitch * i}), 0.02);
      EXPECT_GT(height_at(map, {55, 30 + pitch * (i + 0.5)}), 0.95) << pitch;
    }
  }
  EXPECT_EQ(suggested_width(std::vector{stroke({{10, 50}, {99, 50}})}), kWidest);
  EXPECT_EQ(suggested_width({}), kWidest);
}

TEST(Carve, AFittedBrushIsNeverWiderThanTheGivenOne) {
  const auto dense = kanjivg("鬱");
  EXPECT_LT(suggested_width(dense), 6);
  EXPECT_EQ(fitted({.width = 2}, dense).width, 2);
  EXPECT_EQ(fitted({.width = 9, .fit = false}, dense).width, 9);
}

TEST(Carve, WhereStrokesHaveFilledATileTheOthersStillCutAllAroundIt) {
  // Level strokes fill a corner, because they start furthest left and so are cut first. The others go on
  // beyond it, and dots reach over its lower border.
  constexpr int kSize = 128;
  std::vector<StrokeLine> strokes;
  for (double x = 1; x < 1.4; x += 0.1)
    for (double y = 2; y <= 54; y += 1) strokes.push_back(stroke({{x, y}, {62, y}}));
  // Where the corner is full, these strokes still deepen the other half, which is half deep everywhere by
  // then.
  for (double y = 2; y < 108; y += 4) strokes.push_back(stroke({{64, y}, {108, y}}));
  for (double x = 10; x < 107; x += 9) strokes.push_back(stroke({{x, 107}, {x + 0.1, 3}}));
  strokes.push_back(stroke({{107, 40}, {2, 40.3}}));
  for (double y = 5; y < 60; y += 11) strokes.push_back(stroke({{107, y}, {55, y + 20}, {2, y + 45}}));
  for (double x = 14; x < 50; x += 9) strokes.push_back(stroke({{x, 56}}));
  const Brush brush = even_brush(9);
  std::vector<double> left(static_cast<std::size_t>(kSize) * kSize, 1.0);  // 1 - S
  for (const StrokeLine& one : strokes) {
    const auto alone = carve(std::vector{one}, kSize, brush);
    ASSERT_TRUE(alone);
    for (std::size_t i = 0; i < left.size(); ++i) {
      const double depth = 1.0 - alone->samples()[i];
      left[i] *= 1 - depth * depth;
    }
  }
  const auto all = carve(strokes, kSize, brush);
  ASSERT_TRUE(all);
  for (std::size_t i = 0; i < left.size(); ++i)
    ASSERT_NEAR(all->samples()[i], 1 - std::sqrt(1 - left[i]), 3e-3) << i % kSize << ", " << i / kSize;
}

}  // namespace
}  // namespace nazori::carving
