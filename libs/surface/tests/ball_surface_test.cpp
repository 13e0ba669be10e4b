// SPDX-License-Identifier: Apache-2.0
#include "nazori/surface/ball_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "../src/ball_search.h"

namespace nazori::surface {
namespace {

HeightMap map_of(int size, auto height) {
  HeightMap map = *HeightMap::create(size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) map.set(x, y, static_cast<float>(height(x, y)));
  return map;
}

double hill(double x, double y) {
  return 0.5 + 0.25 * std::sin(x * 0.31) + 0.25 * std::cos(y * 0.23 + x * 0.1);
}

std::vector<HeightMap> maps() {
  constexpr int kSize = 40;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(0, 1);
  return {map_of(kSize, hill),
          map_of(kSize, [](int x, int y) { return std::round(40 * hill(x, y)) / 40; }),
          map_of(kSize, [&](int, int) { return any(random); }),
          map_of(kSize, [&](int, int) { return any(random) < 0.1F ? 1.0 : 0.0; }),
          map_of(kSize, [](int x, int y) { return (x / 7 + y / 5) % 3 == 0 ? 1.0 : 0.0; }),
          map_of(kSize, [](int x, int y) { return std::min(1.0, std::abs(x - 24.3 + 0.4 * y - 9) / 30); })};
}

/// The height of the ball above a sample when contacts on the map 1 / `parts` apart are tried [cells].
double tried(const SmoothSurface& surface, int column, int row, double radius, double steep, int parts) {
  const int reach = static_cast<int>(radius * parts);
  const double last = surface.size() - 1;
  const auto on_map = [last](double x, double y) { return x >= 0 && y >= 0 && x <= last && y <= last; };
  double best = -std::numeric_limits<double>::infinity();
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i) {
      const double x = static_cast<double>(i) / parts, y = static_cast<double>(j) / parts;
      const double left = radius * radius - x * x - y * y;
      if (left < 0 || !on_map(column + x, row + y)) continue;
      best = std::max(best, surface.at(column + x, row + y).height * steep + std::sqrt(left) - radius);
    }
  return best;
}

TEST(BallSearch, NoContactAtASampleIsHigherOnAnyMap) {
  for (const HeightMap& map : maps()) {
    const auto surface = *SmoothSurface::create(map);
    const int size = map.size();
    std::vector<float> found(map.samples().size());
    for (const double radius : {4.2, 7.5, 15.0})
      for (const double steep : {3.0, 12.7, 60.0}) {
        BallSearch(map, *surface, radius, steep, 0.01).rows(0, size, found);
        for (int row = 0; row < size; ++row)
          for (int column = 0; column < size; ++column)
            ASSERT_GE(static_cast<double>(found[static_cast<std::size_t>(row * size + column)]) * steep,
                      tried(*surface, column, row, radius, steep, 1) - 1e-6 * steep)
                << "radius " << radius << ", steepness " << steep << " at " << column << ", " << row;
      }
  }
}

/// Grooves with round floors, as strokes are carved, two of them crossing, and a cone.
double carved(double x, double y) {
  const auto groove = [](double off, double half) {
    return off < half ? 0.5 - 0.5 * std::cos(std::numbers::pi * off / half) : 1.0;
  };
  return std::min({groove(std::abs(x - 47.3 + 0.12 * y), 11), groove(std::abs(y - 30.6), 14),
                   groove(std::abs(x - 82 - 0.6 * (y - 60)) / 1.17, 6),
                   0.05 + std::hypot(x - 75, y - 85) / 17});
}

/// The definition, cell by cell: the largest of z(q) + c(x - q) over all samples q [cells].
std::vector<double> by_definition(const SmoothSurface& surface, double radius, double steep) {
  const int size = surface.size(), reach = static_cast<int>(radius);
  std::vector<double> z, cap, best;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) z.push_back(surface.at(x, y).height * steep);
  const auto at = [size](int x, int y) { return static_cast<std::size_t>(y * size + x); };
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      double most = z[at(x, y)];
      for (int j = std::max(-reach, -y); j <= std::min(reach, size - 1 - y); ++j)
        for (int i = std::max(-reach, -x); i <= std::min(reach, size - 1 - x); ++i) {
          // Only where it can be more than the best so far: a root takes long.
          const double higher = z[at(x + i, y + j)] - most, left = radius * radius - i * i - j * j;
          if (left >= 0 && higher > 0) most = std::max(most, most + higher + std::sqrt(left) - radius);
        }
      best.push_back(most);
    }
  return best;
}

TEST(BallSearch, NoBallThatASampleCanHoldIsOutsideItsBox) {
  std::mt19937 random(11);
  const auto between = [&random](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  int held = 0;
  for (int i = 0; i < 60'000; ++i) {
    const double r = std::exp(between(std::log(2.8), std::log(130.0)));
    const double steep = std::exp(between(std::log(0.02), std::log(12.0)));
    const double to = between(-std::numbers::pi, std::numbers::pi);
    const double bend = std::exp(between(std::log(0.001), std::log(2.0)));
    const auto slope = [&](double way) { return static_cast<float>(steep * way + between(-bend, bend)); };
    const BallSearch::Slopes s{slope(std::cos(to)), slope(std::cos(to)), slope(std::sin(to)),
                               slope(std::sin(to))};
    const auto box = BallSearch::region_of(s, static_cast<float>(r));
    if (!box.is_sure || (box.right - box.left) * (box.bottom - box.top) > 200) continue;
    constexpr double kNever = -1e30;
    const auto cap = [r](double x, double y) {
      const double left = r * r - x * x - y * y;
      return left >= 0 ? std::sqrt(left) - r : kNever;
    };
    const auto around = [](float a, float b, int by) { return static_cast<int>((a + b) / 2) + by; };
    constexpr int kRoom = 16;
    for (int y = around(box.top, box.bottom, -kRoom); y <= around(box.top, box.bottom, kRoom); ++y)
      for (int x = around(box.left, box.right, -kRoom); x <= around(box.left, box.right, kRoom); ++x) {
        const double here = cap(x, y) + 1e-9;
        if (here < kNever / 2 || here < cap(x - 1, y) + static_cast<double>(s.right) ||
            here < cap(x + 1, y) - static_cast<double>(s.left) ||
            here < cap(x, y - 1) + static_cast<double>(s.down) ||
            here < cap(x, y + 1) - static_cast<double>(s.up))
          continue;
        ++held;
        const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
        ASSERT_TRUE(box.left <= fx && fx <= box.right && box.top <= fy && fy <= box.bottom)
            << "radius " << r << ", slopes " << s.left << ' ' << s.right << ' ' << s.up << ' ' << s.down
            << ", at " << x << ", " << y;
      }
  }
  EXPECT_GT(held, 100'000);
}

TEST(BallSearch, AmongTheSamplesItIsTheDefinitionCellByCell) {
  constexpr double kNoneBetween = 1e9;  // so high a tolerance that no contact between samples is looked for
  std::vector<HeightMap> all = maps();
  all.push_back(map_of(110, carved));
  all.push_back(map_of(110, [](int x, int y) { return std::round(255 * carved(x, y)) / 255; }));
  for (const HeightMap& map : all) {
    const auto surface = *SmoothSurface::create(map);
    const int size = map.size();
    std::vector<float> found(map.samples().size());
    for (const double radius : {4.2, 9.7, 20.48})
      for (const double steep : {3.0, 12.7, 35.0, 150.0}) {
        BallSearch(map, *surface, radius, steep, kNoneBetween).rows(0, size, found);
        const auto plain = by_definition(*surface, radius, steep);
        for (std::size_t i = 0; i < plain.size(); ++i)
          ASSERT_NEAR(static_cast<double>(found[i]) * steep, plain[i], 1e-6 * steep)
              << "radius " << radius << ", steepness " << steep << ", " << size << " samples, at "
              << i % static_cast<std::size_t>(size) << ", " << i / static_cast<std::size_t>(size);
      }
  }
}

TEST(BallSearch, OnSmoothReliefItIsTheHighestOfAllContacts) {
  const HeightMap map = map_of(40, hill);
  const auto surface = *SmoothSurface::create(map);
  std::vector<float> found(map.samples().size());
  for (const double radius : {0.3, 0.7, 1.3, 2.6, 3.9, 4.2, 7.5, 15.0}) {
    constexpr double kSteep = 6;
    const int parts = radius < 2 ? 40 : 16;
    // What is between the points that are tried here.
    const double between = (1 / radius + 0.3) / (4 * parts * parts) * 4 + 2e-3;
    BallSearch(map, *surface, radius, kSteep, 0.001).rows(0, map.size(), found);
    for (int row = 0; row < map.size(); row += 3)
      for (int column = 0; column < map.size(); column += 2) {
        const double all = tried(*surface, column, row, radius, kSteep, parts);
        const double is =
            static_cast<double>(found[static_cast<std::size_t>(row * map.size() + column)]) * kSteep;
        const double to_edge = std::min({row, column, map.size() - 1 - row, map.size() - 1 - column});
        // Beyond the edge, where a large ball finds a little more, no contact is searched.
        if (radius < 8 || to_edge > radius) {
          ASSERT_GE(is, all - 2e-3) << "radius " << radius << " at " << column << ", " << row;
        }
        if (to_edge <= radius) continue;  // the surface goes on beyond the edge
        ASSERT_LE(is, all + between) << "radius " << radius << " at " << column << ", " << row;
      }
  }
}

TEST(BallSearch, ALargeBallTouchesBetweenTheSamplesOnWhicheverSideTheContactIs) {
  constexpr int kSize = 110, kParts = 8;
  constexpr double kRadius = 34.5, kSteep = 20;
  const HeightMap map = map_of(kSize, [](int x, int y) { return hill(x / 3.0, y / 3.0); });
  const auto surface = *SmoothSurface::create(map);
  std::vector<float> found(map.samples().size());
  BallSearch(map, *surface, kRadius, kSteep, 1e-5).rows(0, kSize, found);
  for (int row = 36; row < 74; row += 5)
    for (int column = 36; column < 74; column += 6) {
      const double all = tried(*surface, column, row, kRadius, kSteep, kParts);
      const double is = static_cast<double>(found[static_cast<std::size_t>(row * kSize + column)]) * kSteep;
      ASSERT_NEAR(is, all, 1e-3) << column << ", " << row;
    }
}

TEST(BallSearch, BandsOfRowsGiveTheSameBytesAsAllRows) {
  for (const HeightMap& map : maps()) {
    const auto surface = *SmoothSurface::create(map);
    const auto size = static_cast<std::size_t>(map.size());
    for (const double radius : {1.4, 9.0}) {
      const BallSearch search(map, *surface, radius, 12, 0.01);
      std::vector<float> whole(size * size), bands(size * size);
      search.rows(0, map.size(), whole);
      for (const auto& [first, last] : {std::pair{0, 7}, std::pair{7, 8}, std::pair{8, 40}})
        search.rows(first, last,
                    std::span(bands).subspan(static_cast<std::size_t>(first) * size,
                                             static_cast<std::size_t>(last - first) * size));
      ASSERT_EQ(whole, bands);
    }
  }
}

TEST(BallSurface, ThreadsFindWhatOneBandFinds) {
  const HeightMap map = map_of(300, [](int x, int y) { return hill(x / 4.0, y / 4.0); });
  constexpr geometry::TabletShape kShape{0.1, 0.01};
  const double cell_m = kShape.width_m / 299;
  const auto surface = *SmoothSurface::create(map);
  for (const double radius_m : {0.0007, 0.003}) {
    std::vector<float> one(map.samples().size());
    BallSearch(map, *surface, radius_m / cell_m, kShape.depth_m / cell_m, 2e-6 / cell_m).rows(0, 300, one);
    const auto heights = heights_under_ball(map, kShape, radius_m);
    ASSERT_TRUE(heights);
    EXPECT_TRUE(std::equal(one.begin(), one.end(), heights->samples().begin()));
  }
}

TEST(BallSurface, RadiusZeroIsTheSurfaceOfTheMapToTheLastBit) {
  for (const HeightMap& map : maps()) {
    const auto plain = *SmoothSurface::create(map);
    const auto none = surface_for_ball(map, {}, 0);
    ASSERT_TRUE(none);
    for (double y = -1; y < 41; y += 0.37)
      for (double x = -1; x < 41; x += 0.41) {
        ASSERT_EQ((*none)->at(x, y).height, plain->at(x, y).height);
        ASSERT_EQ((*none)->at(x, y).d_row, plain->at(x, y).d_row);
      }
  }
}

TEST(BallSurface, AVerySmallBallFeelsAlmostTheSameOnSmoothRelief) {
  const HeightMap map = map_of(128, [](int x, int y) { return hill(x / 2.0, y / 2.0); });
  const auto plain = *SmoothSurface::create(map);
  for (const double radius_m : {1e-9, 1e-5}) {
    const auto small = surface_for_ball(map, {}, radius_m);
    ASSERT_TRUE(small);
    for (double y = 4; y < 124; y += 1.7)
      for (double x = 4; x < 124; x += 1.3)
        ASSERT_NEAR((*small)->at(x, y).height, plain->at(x, y).height, 2e-3);
  }
}

TEST(BallSurface, ItPassesThroughTheHeightsUnderTheBallWhereTheBendChangesLittle) {
  const HeightMap map = map_of(256, [](int x, int y) { return hill(x / 6.0, y / 6.0); });
  const auto heights = heights_under_ball(map, {}, 0.002);
  const auto surface = surface_for_ball(map, {}, 0.002);
  ASSERT_TRUE(heights && surface);
  for (int y = 3; y < 253; ++y)
    for (int x = 3; x < 253; ++x)
      ASSERT_NEAR((*surface)->at(x, y).height, static_cast<double>(heights->at(x, y)), 2e-4);
}

TEST(BallSurface, ControlsOfAKinkDoNotRing) {
  const HeightMap kink = map_of(32, [](int x, int) { return 0.1 + 0.02 * std::abs(x - 16); });
  EXPECT_EQ(controls_through(kink), kink);
  for (const double bend : {0.001, -0.001}) {  // a bowl and a dome
    const HeightMap round = map_of(32, [bend](int x, int y) {
      return 0.5 - 300 * bend + bend * ((x - 16) * (x - 16) + (y - 9) * (y - 9));
    });
    const HeightMap controls = controls_through(round);
    const auto surface = *SmoothSurface::create(controls);
    for (int y = 3; y < 29; ++y)
      for (int x = 3; x < 29; ++x)
        ASSERT_NEAR(surface->at(x, y).height, static_cast<double>(round.at(x, y)), 1e-6) << x << ", " << y;
  }
}

TEST(BallSurface, ControlsAreTheSameWhicheverThreadMakesThem) {
  constexpr int kSize = 150;
  const HeightMap map = map_of(kSize, [](int x, int y) { return hill(x / 2.0, y / 2.0); });
  const HeightMap controls = controls_through(map);
  // A strip of few rows has one thread; what is two rows away does not matter.
  constexpr int kStrip = 24;
  for (int first = 0; first + kStrip <= kSize; first += 3) {
    HeightMap strip = *HeightMap::create(kStrip);
    for (const int column : {0, kSize - kStrip}) {
      for (int y = 0; y < kStrip; ++y)
        for (int x = 0; x < kStrip; ++x) strip.set(x, y, map.at(column + x, first + y));
      const HeightMap alone = controls_through(strip);
      for (int y = 2; y < kStrip - 2; ++y)
        for (int x = 2; x < kStrip - 2; ++x)
          ASSERT_EQ(alone.at(x, y), controls.at(column + x, first + y)) << column + x << ", " << first + y;
    }
  }
}

TEST(BallSurface, ItIsNowhereBelowTheSurfaceOfTheMapNorAboveThePlateau) {
  for (const HeightMap& map : maps()) {
    const auto plain = *SmoothSurface::create(map);
    for (const double radius_m : {0.001, 0.01}) {
      const auto heights = heights_under_ball(map, {}, radius_m);
      ASSERT_TRUE(heights);
      for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
          ASSERT_GE(static_cast<double>(heights->at(x, y)), plain->at(x, y).height - 1e-6);
          ASSERT_LE(heights->at(x, y), 1.0F);
        }
    }
  }
}

TEST(BallSurface, WhatHasNoSizeIsRefused) {
  const HeightMap map = *HeightMap::create(16);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double radius : {-1e-9, 0.0251, nan, inf}) {
    const auto refused = surface_for_ball(map, {}, radius);
    if (radius == 0) continue;
    ASSERT_FALSE(refused) << radius;
    EXPECT_EQ(refused.error().code, base::Errc::bad_argument);
    EXPECT_EQ(refused.error().where, "radius");
  }
  EXPECT_TRUE(surface_for_ball(map, {}, 0.025));
  EXPECT_FALSE(surface_for_ball(HeightMap(), {}, 0.001));
  EXPECT_FALSE(heights_under_ball(HeightMap(), {}, 0));
  EXPECT_EQ(heights_under_ball(map, {0, 0.01}, 0.001).error().where, "shape");
  EXPECT_EQ(heights_under_ball(map, {0.1, inf}, 0.001).error().where, "shape");
}

}  // namespace
}  // namespace nazori::surface
