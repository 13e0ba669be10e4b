// SPDX-License-Identifier: Apache-2.0
// Distances, dashes, regions and the plate that is carved from them, against what is computed sample by
// sample.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "../src/dashes.h"
#include "../src/distance_grid.h"
#include "drawn_lines.h"
#include "nazori/functions/plate.h"
#include "nazori/functions/tablet_curves.h"

namespace nazori::functions {
namespace {

using test::line;
using test::tracing_of;

double distance_to(PlatePoint c, PlatePoint p, PlatePoint q) {
  const double du = q.u - p.u;
  const double dv = q.v - p.v;
  const double length2 = du * du + dv * dv;
  const double t = length2 > 0 ? std::clamp(((c.u - p.u) * du + (c.v - p.v) * dv) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(c.u - p.u - t * du, c.v - p.v - t * dv);
}

PlatePoint centre_of(std::size_t sample, int size) {
  const auto n = static_cast<std::size_t>(size);
  return {(static_cast<double>(sample % n) + 0.5) / size, 1 - (static_cast<double>(sample / n) + 0.5) / size};
}

std::size_t samples_of(int size) { return static_cast<std::size_t>(size) * static_cast<std::size_t>(size); }

Plate carved(const Tracing& tracing, PlateSettings settings = {}) {
  auto plate = carve(tracing, settings);
  EXPECT_TRUE(plate);
  return std::move(*plate);
}

PlateSettings bare(int size, double half_width) {
  PlateSettings settings;
  settings.size = size;
  settings.half_width = half_width;
  settings.layers = Layers::none();
  return settings;
}

TEST(DistanceGrid, IsExactWithinItsReachAndInfiniteBeyond) {
  constexpr int kSize = 64;
  constexpr double kReach = 0.06;
  struct Segment {
    PlatePoint p, q;
  };
  std::vector<Segment> segments{{{0.2, 0.3}, {0.2, 0.3}},   {{0.1, 0.8}, {0.6, 0.8}},
                                {{0.7, 0.9}, {0.7, 0.4}},   {{-0.03, 0.1}, {-0.03, 0.5}},
                                {{0.3, 1.04}, {0.5, 1.04}}, {{0.9, -0.05}, {1.05, 0.1}},
                                {{-0.5, 0.6}, {1.5, 0.65}}, {{0.4, -2}, {0.45, 3}}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-0.2, 1.2);
  for (int i = 0; i < 6; ++i) segments.push_back({{any(random), any(random)}, {any(random), any(random)}});
  for (const Segment& s : segments) {
    DistanceGrid grid(kSize, kReach);
    grid.add_segment(s.p, s.q, 4);
    for (std::size_t i = 0; i < samples_of(kSize); ++i) {
      const double truth = distance_to(centre_of(i, kSize), s.p, s.q);
      if (truth < kReach - 1e-6) {
        ASSERT_NEAR(grid.distance(i), truth, 1e-6) << s.p.u << ' ' << s.p.v << " sample " << i;
        ASSERT_EQ(grid.statement(i), 5);
      } else if (truth > kReach + 1e-6) {
        ASSERT_EQ(grid.distance(i), std::numeric_limits<float>::infinity()) << i;
        ASSERT_EQ(grid.statement(i), 0);
      }
    }
  }
}

TEST(DistanceGrid, TheNearestOfSeveralCountsAndOfEquallyNearTheFirst) {
  DistanceGrid grid(32, 0.5);
  grid.add_segment({0, 0.25}, {1, 0.25}, 0);
  grid.add_segment({0, 0.75}, {1, 0.75}, 1);
  grid.add_segment({0, 0.75}, {1, 0.75}, 2);
  for (std::size_t i = 0; i < samples_of(32); ++i) {
    const double v = centre_of(i, 32).v;
    ASSERT_EQ(grid.statement(i), v < 0.5 ? 1 : 2) << v;
    ASSERT_NEAR(grid.distance(i), std::abs(v - (v < 0.5 ? 0.25 : 0.75)), 1e-6);
  }
}

TEST(DistanceGrid, ALineOfManyPointsIsKeptWithinAThirtySecondOfACell) {
  constexpr int kSize = 64;
  for (const bool closed : {false, true}) {
    std::vector<CurvePoint> points;
    for (int i = 0; i <= 300; ++i) {
      const double angle = 5.5 * i / 300;
      points.push_back({0.5 + 0.3 * std::cos(angle), 0.5 + 0.2 * std::sin(angle), 0});
    }
    // Back over itself and with a point twice.
    points.push_back(points.back());
    points.push_back(points[295]);
    DistanceGrid grid(kSize, 0.1);
    grid.add_line(points, closed, 0);
    for (std::size_t i = 0; i < samples_of(kSize); ++i) {
      const PlatePoint c = centre_of(i, kSize);
      double truth = 1;
      for (std::size_t k = 0; k + 1 < points.size() + (closed ? 1 : 0); ++k) {
        const CurvePoint& b = points[(k + 1) % points.size()];
        truth = std::min(truth, distance_to(c, {points[k].u, points[k].v}, {b.u, b.v}));
      }
      if (truth < 0.099) {
        ASSERT_NEAR(grid.distance(i), truth, 1.0 / (32 * kSize) + 1e-6) << i;
      }
    }
  }
  DistanceGrid point(kSize, 0.1);
  point.add_line({{0.5, 0.5, 0}}, true, 0);
  point.add_line({}, true, 0);
  EXPECT_NEAR(point.distance(32 * 64 + 32), std::hypot(0.5, 0.5) / 64, 1e-6);
}

TEST(Dashes, GoOnRoundCornersAndOverTheSeamOfAClosedLine) {
  constexpr int kSize = 400;
  const std::array lengths{0.07, 0.03, 0.02, 0.05};
  const std::vector<CurvePoint> corners{{0.2, 0.2, 0}, {0.8, 0.2, 0}, {0.8, 0.6, 0}, {0.2, 0.6, 0}};
  for (const bool closed : {false, true}) {
    DistanceGrid grid(kSize, 0.002);
    add_dashes(grid, line(corners, 0, closed), lengths);
    double walked = 0;
    for (std::size_t k = 0; k < (closed ? 4U : 3U); ++k) {
      const CurvePoint& a = corners[k];
      const CurvePoint& b = corners[(k + 1) % 4];
      const double length = std::hypot(b.u - a.u, b.v - a.v);
      for (double s = 0.004; s < length - 0.004; s += 0.0025) {
        const double along = std::fmod(walked + s, 0.17);
        double off = std::abs(along - 0.07);
        for (const double end : {0.0, 0.1, 0.12, 0.17}) off = std::min(off, std::abs(along - end));
        if (off < 0.005) continue;
        const bool ink = along < 0.07 || (along > 0.1 && along < 0.12);
        const int column = static_cast<int>((a.u + (b.u - a.u) * s / length) * kSize);
        const int row = static_cast<int>((1 - (a.v + (b.v - a.v) * s / length)) * kSize);
        const auto i = static_cast<std::size_t>(row * kSize + column);
        ASSERT_EQ(std::isfinite(grid.distance(i)), ink) << closed << " after " << walked + s;
      }
      walked += length;
    }
    if (!closed) {
      // Nothing on the way back to the start.
      for (int row = 165; row < 315; ++row) {
        ASSERT_FALSE(std::isfinite(grid.distance(static_cast<std::size_t>(row * kSize + 80))));
      }
    }
  }
}

TEST(Regions, HoldTheSamplesWhoseMiddlesTheyCover) {
  Tracing tracing;
  EXPECT_TRUE(regions_of(tracing, 32).empty());
  tracing.fills.push_back({0, {0.1, 0.2}, {0.4, 0.7}});
  tracing.fills.push_back({2, {0.75, 0.75}, {1, 1}});
  tracing.fills.push_back({1, {-0.5, -0.5}, {0.05, 0.05}});
  // From one middle to another: both count.
  tracing.fills.push_back({3, {20.5 / 32, 3.5 / 32}, {22.5 / 32, 4.5 / 32}});
  const auto inside = regions_of(tracing, 32);
  ASSERT_EQ(inside.size(), samples_of(32));
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const PlatePoint c = centre_of(i, 32);
    int wanted = 0;
    for (const Fill& f : tracing.fills) {
      if (c.u >= f.low.u && c.u <= f.high.u && c.v >= f.low.v && c.v <= f.high.v) wanted = f.statement + 1;
    }
    ASSERT_EQ(inside[i], wanted) << c.u << ' ' << c.v;
  }
}

TEST(Carve, AGrooveIsARaisedCosineAcrossItself) {
  const PlateSettings settings = bare(200, 0.05);
  Tracing tracing = tracing_of({line({{0.1, 0.3, 0}, {0.9, 0.5, 0}})});
  tracing.bars.push_back({0, {0.3, 0.7}, {0.3, 0.9}});
  tracing.dots.push_back({0, {0.8, 0.8}});
  const Plate plate = carved(tracing, settings);
  for (std::size_t i = 0; i < samples_of(200); ++i) {
    const PlatePoint c = centre_of(i, 200);
    const double d = std::min({distance_to(c, {0.1, 0.3}, {0.9, 0.5}), distance_to(c, {0.3, 0.7}, {0.3, 0.9}),
                               distance_to(c, {0.8, 0.8}, {0.8, 0.8})});
    const double wanted = d < 0.05 ? 0.5 - 0.5 * std::cos(std::numbers::pi * d / 0.05) : 1;
    ASSERT_NEAR(plate.heights.samples()[i], wanted, 2e-4) << c.u << ' ' << c.v;
    if (std::abs(d - 0.05) < 1e-6) continue;
    ASSERT_EQ(plate.mask[i], d < 0.05 ? 255 : 0);
    ASSERT_EQ(plate.statement[i], d < 0.05 ? 1 : 0);
  }
}

TEST(Carve, BumpsRiseFromTheFloorOfTheSecondGrooveAndLeaveItsWalls) {
  constexpr int kSize = 1000;
  constexpr double kHalfWidth = 0.06;
  const Plate plate = carved(tracing_of({line({{0, 0.5, 0}, {1, 0.5, 0}}, 1)}), bare(kSize, kHalfWidth));
  double least = 1;
  double most = 0;
  for (std::size_t i = 0; i < samples_of(kSize); ++i) {
    const double d = std::abs(centre_of(i, kSize).v - 0.5);
    if (d >= kHalfWidth) continue;
    const double depth = 0.5 + 0.5 * std::cos(std::numbers::pi * d / kHalfWidth);
    const double bump = plate.heights.samples()[i] - (1 - depth);
    // Up to 15 % of the depth on the middle line, nothing where the wall is 70 % deep or less.
    const double allowed = depth > 0.7 ? depth * 0.15 * (depth - 0.7) / 0.3 : 0;
    ASSERT_GE(bump, -1e-5);
    ASSERT_LE(bump, allowed + 1e-5);
    if (depth > 0.99) {
      least = std::min(least, bump / allowed);
      most = std::max(most, bump / allowed);
    }
  }
  EXPECT_NEAR(most, 1, 0.02);
  EXPECT_NEAR(least, 0, 0.02);
  // Along the middle row the bumps repeat with the period of the statement.
  const double period = feel_of(1).texture_period;
  int tops = 0;
  for (int column = 1; column < kSize; ++column) {
    const auto is_high = [&](int c) { return plate.heights.at(c, 500) > 0.075F; };
    tops += is_high(column) && !is_high(column - 1) ? 1 : 0;
  }
  EXPECT_NEAR(tops, 1 / period, 1.5);
  // One of them stands in the upper left corner of the plate.
  for (int column = 0; column < kSize; ++column) {
    const double wave = std::cos(2 * std::numbers::pi * column / (kSize * period)) *
                        std::cos(2 * std::numbers::pi * 0.5 / period);
    const double d = 0.0005;  // from the middle of the sample to the middle line
    const double depth = 0.5 + 0.5 * std::cos(std::numbers::pi * d / kHalfWidth);
    const double bump = 0.15 * (0.5 + 0.5 * wave) * (depth - 0.7) / 0.3;
    ASSERT_NEAR(plate.heights.at(column, 500), 1 - depth * (1 - bump), 1e-4) << column;
  }
}

TEST(Carve, ARegionHasARippleBetweenATenthAndAQuarterOfTheDepth) {
  Tracing tracing = tracing_of({});
  tracing.fills.push_back({0, {0, 0}, {0.5, 1}});
  const Plate plate = carved(tracing, bare(1000, 0.0125));
  float least = 1;
  float most = 0;
  int waves = 0;
  for (int column = 0; column < 500; ++column) {
    const float h = plate.heights.at(column, 300);
    least = std::min(least, h);
    most = std::max(most, h);
    waves += column > 0 && h > 0.825F && plate.heights.at(column - 1, 300) <= 0.825F ? 1 : 0;
    // Aslant: a step to the right and one up are the same wave.
    if (column > 0) {
      ASSERT_NEAR(h, plate.heights.at(column - 1, 301), 1e-5);
    }
  }
  EXPECT_NEAR(least, 0.75, 0.001);
  EXPECT_NEAR(most, 0.90, 0.001);
  EXPECT_NEAR(waves, 0.5 / 0.012, 1);
  EXPECT_EQ(plate.heights.at(500, 300), 1);
  EXPECT_EQ(plate.mask[300 * 1000 + 499], 255);
  EXPECT_EQ(plate.mask[300 * 1000 + 500], 0);
  EXPECT_EQ(plate.statement[300 * 1000 + 10], 1);
}

TEST(Carve, ABorderThatDoesNotBelongIsDashed) {
  Branch border = line({{0, 0.5, 0}, {1, 0.5, 0}});
  border.boundary = border.strict = true;
  for (const auto& [half_width, dash] : {std::pair{0.005, 0.022}, std::pair{0.02, 0.04}}) {
    const Plate plate = carved(tracing_of({border}), bare(1000, half_width));
    int deep = 0;
    int strokes = 0;
    for (int column = 0; column < 1000; ++column) {
      const bool cut = plate.heights.at(column, 500) < 0.5F;
      deep += cut ? 1 : 0;
      strokes += cut && (column == 0 || plate.heights.at(column - 1, 500) >= 0.5F) ? 1 : 0;
      ASSERT_EQ(plate.mask[static_cast<std::size_t>(500 * 1000 + column)], 0);
    }
    EXPECT_NEAR(strokes, 1 / (2 * dash), 1.1) << half_width;
    // Half a half width of groove goes on beyond either end of a stroke.
    EXPECT_NEAR(deep, 500 + strokes * half_width * 1000, 30) << half_width;
    EXPECT_LT(plate.heights.at(5, 500), 0.05F);
  }
  border.strict = false;
  EXPECT_LT(carved(tracing_of({border}), bare(1000, 0.005)).heights.at(33, 500), 0.05F);
}

TEST(Carve, WhatOnlyComesNearTheWindowIsNotCarved) {
  const auto any_cut = [](const Tracing& t) {
    const Plate plate = carved(t, bare(64, 0.05));
    return std::any_of(plate.mask.begin(), plate.mask.end(), [](std::uint8_t m) { return m != 0; });
  };
  EXPECT_FALSE(any_cut(tracing_of({line({{-0.01, 0, 0}, {-0.01, 1, 0}})})));
  EXPECT_TRUE(any_cut(tracing_of({line({{-0.01, 0.5, 0}, {0.01, 0.5, 0}})})));
  EXPECT_TRUE(any_cut(tracing_of({line({{0, 0, 0}, {0, 1, 0}})})));
  EXPECT_TRUE(any_cut(tracing_of({line({{0, 1, 0}, {1, 1, 0}})})));
  EXPECT_FALSE(any_cut(tracing_of({line({{0.2, 1.01, 0}, {0.6, 1.01, 0}})})));
  EXPECT_FALSE(any_cut(tracing_of({line({{0.9, 1.2, 0}, {1.2, 0.9, 0}})}))) << "past the corner";
  EXPECT_TRUE(any_cut(tracing_of({line({{0.7, 1.2, 0}, {1.2, 0.7, 0}})}))) << "over the corner";
  EXPECT_TRUE(any_cut(tracing_of({line({{2, 2, 0}, {1.5, 0.5, 0}, {0.5, 0.5, 0}})})));
  Tracing parts = tracing_of({});
  parts.dots.push_back({0, {1.01, 0.5}});
  parts.bars.push_back({0, {-0.01, 0.2}, {-0.01, 0.4}});
  EXPECT_FALSE(any_cut(parts));
  parts.bars.push_back({0, {0.5, 0.2}, {0.5, 0.4}});
  EXPECT_TRUE(any_cut(parts));
}

TEST(Carve, RefusesSettingsOutOfRangeAndTakesThoseOnItsEnds) {
  const Tracing tracing = tracing_of({});
  const auto refused = [&](PlateSettings s) {
    const auto plate = carve(tracing, s);
    return !plate && plate.error().code == base::Errc::bad_argument;
  };
  EXPECT_FALSE(refused(bare(32, 0.01)));
  EXPECT_TRUE(refused(bare(31, 0.01)));
  EXPECT_TRUE(refused(bare(4097, 0.01)));
  EXPECT_FALSE(refused(bare(64, 0.001)));
  EXPECT_TRUE(refused(bare(64, 0.0009)));
  EXPECT_FALSE(refused(bare(64, 0.2)));
  EXPECT_TRUE(refused(bare(64, 0.21)));
  PlateSettings heights = bare(64, 0.01);
  heights.heights = HeightRange{0, 1};
  EXPECT_FALSE(refused(heights));
  heights.heights = HeightRange{1, 1};
  EXPECT_TRUE(refused(heights));
  heights.heights = HeightRange{0, std::numeric_limits<double>::infinity()};
  EXPECT_TRUE(refused(heights));
}

}  // namespace
}  // namespace nazori::functions
