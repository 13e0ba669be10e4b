// SPDX-License-Identifier: Apache-2.0
// A ball on shapes on which its place is known in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nazori/surface/ball_surface.h"

namespace nazori::surface {
namespace {

constexpr geometry::TabletShape kShape{0.100, 0.010};

/// A map with the heights z(x, y) in metres, from -depth to 0, and x, y from the middle.
HeightMap map_of(int size, auto z) {
  HeightMap map = *HeightMap::create(size);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const auto p =
          geometry::grid_to_tablet({static_cast<double>(column), static_cast<double>(row)}, size, kShape);
      map.set(column, row,
              static_cast<float>(1 + std::clamp(z(p.x, p.y), -kShape.depth_m, 0.0) / kShape.depth_m));
    }
  return map;
}

double cell_m(int size) { return kShape.width_m / (size - 1); }

/// The lowest point of the ball above a sample [m].
double lowest_m(const HeightMap& heights, int column, int row) {
  return (static_cast<double>(heights.at(column, row)) - 1) * kShape.depth_m;
}

/// Compares with `z` at the samples within `reach_m` of the middle, along a row and along a slanted line.
void expect_lowest(const HeightMap& heights, double reach_m, double tolerance_m, auto z) {
  const int size = heights.size(), middle = size / 2;
  const int reach = static_cast<int>(reach_m / cell_m(size));
  for (int i = -reach; i <= reach; ++i)
    for (const int j : {0, i / 3, -i / 2}) {
      const double x = i * cell_m(size), y = -j * cell_m(size);
      EXPECT_NEAR(lowest_m(heights, middle + i, middle + j), z(x, y), tolerance_m)
          << size << " samples, " << x * 1e3 << " mm, " << y * 1e3 << " mm";
    }
}

constexpr int kSizes[] = {129, 513, 1025};
constexpr double kBalls_m[] = {0.0005, 0.001, 0.002, 0.003};

TEST(Ball, OnAPlateItsLowestPointIsOnThePlate) {
  for (const int size : kSizes) {
    const HeightMap low = map_of(size, [](double, double) { return -0.004; });
    for (const double ball_m : kBalls_m) EXPECT_EQ(*heights_under_ball(low, kShape, ball_m), low);
    const HeightMap plateau = *HeightMap::create(size);
    EXPECT_EQ(*heights_under_ball(plateau, kShape, 0.003), plateau);
  }
}

TEST(Ball, OnASlopeItTouchesBesideItsLowestPoint) {
  for (const int size : {129, 513})
    for (const double slope : {0.2, 0.6})
      for (const double ball_m : kBalls_m) {
        // Along x, along y, and along both.
        for (const auto& [a, b] :
             {std::pair{slope, 0.0}, std::pair{0.0, -slope}, std::pair{-slope / 2, slope}}) {
          const auto plane = [a = a, b = b](double x, double y) { return -0.005 + a * x + b * y; };
          const double over = ball_m * (std::sqrt(1 + a * a + b * b) - 1);
          const auto heights = heights_under_ball(map_of(size, plane), kShape, ball_m);
          ASSERT_TRUE(heights);
          expect_lowest(*heights, 0.0025, 1e-6, [&](double x, double y) { return plane(x, y) + over; });
        }
      }
}

TEST(Ball, InAVGrooveItsMiddleIsItsRadiusByTheSineOfHalfTheAngleAboveTheBottom) {
  for (const int size : kSizes)
    for (const double half_deg : {30.0, 45.0, 60.0}) {
      const double half = half_deg * std::numbers::pi / 180, slope = 1 / std::tan(half);
      const HeightMap groove = map_of(size, [&](double x, double) { return -0.009 + std::abs(x) * slope; });
      for (const double ball_m : kBalls_m) {
        // The bottom of the surface is round within one and a half samples.
        if (ball_m * std::cos(half) < 1.5 * cell_m(size)) continue;
        const auto heights = heights_under_ball(groove, kShape, ball_m);
        ASSERT_TRUE(heights);
        const double bottom = -0.009 + ball_m / std::sin(half) - ball_m;
        expect_lowest(*heights, 0.001, 4e-6, [&](double x, double) { return bottom + std::abs(x) * slope; });
      }
    }
}

TEST(Ball, OverARidgeItsMiddleMovesOnACircle) {
  for (const int size : kSizes)
    for (const double slope : {0.3, 0.8}) {
      const HeightMap roof = map_of(size, [&](double x, double) { return -0.001 - std::abs(x) * slope; });
      const double flattened = slope * cell_m(size) / 4;  // what the surface takes off the edge
      for (const double ball_m : kBalls_m) {
        if (ball_m < 2 * cell_m(size)) continue;
        const auto heights = heights_under_ball(roof, kShape, ball_m);
        ASSERT_TRUE(heights);
        const double touches = ball_m * slope / std::sqrt(1 + slope * slope);
        expect_lowest(*heights, 0.004, 1.05 * flattened + 2e-6, [&](double x, double) {
          const double a = std::abs(x);
          return -0.001 + (a < touches ? std::sqrt(ball_m * ball_m - a * a) - ball_m
                                       : ball_m * (std::sqrt(1 + slope * slope) - 1) - a * slope);
        });
      }
    }
}

TEST(Ball, InAWiderBowlItsMiddleMovesOnASphere) {
  for (const int size : {513, 1025}) {
    constexpr double kBowl_m = 0.008;
    const HeightMap bowl = map_of(size, [](double x, double y) {
      const double left = kBowl_m * kBowl_m - x * x - y * y;
      return left > 0 ? -0.0005 - std::sqrt(left) : -0.0005;
    });
    for (const double ball_m : kBalls_m) {
      const double inside = kBowl_m - ball_m;
      const auto heights = heights_under_ball(bowl, kShape, ball_m);
      ASSERT_TRUE(heights);
      const double rounded = cell_m(size) * cell_m(size) / kBowl_m;  // of the surface, on the walls
      expect_lowest(*heights, 0.5 * inside, rounded + 3e-6, [&](double x, double y) {
        return -0.0005 - std::sqrt(inside * inside - x * x - y * y) - ball_m;
      });
    }
  }
}

TEST(Ball, OnANarrowerHoleItRestsOnTheRim) {
  constexpr int kSize = 1025;
  constexpr double kHole_m = 0.0012;
  const HeightMap hole =
      map_of(kSize, [](double x, double y) { return x * x + y * y < kHole_m * kHole_m ? -0.008 : 0.0; });
  for (const double ball_m : {0.002, 0.003}) {
    const auto heights = heights_under_ball(hole, kShape, ball_m);
    ASSERT_TRUE(heights);
    // The rim is known to a sample and a half.
    const double most = kHole_m / std::sqrt(ball_m * ball_m - kHole_m * kHole_m) * 1.5 * cell_m(kSize);
    expect_lowest(*heights, 0.9 * kHole_m, most, [&](double x, double y) {
      const double to_rim = kHole_m - std::hypot(x, y);
      return std::sqrt(ball_m * ball_m - to_rim * to_rim) - ball_m;
    });
  }
}

}  // namespace
}  // namespace nazori::surface
