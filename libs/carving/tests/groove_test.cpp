// SPDX-License-Identifier: Apache-2.0
#include "nazori/carving/groove.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "nazori/geometry/polyline.h"
#include "test_strokes.h"

namespace nazori::carving {
namespace {

using namespace test;

constexpr int kSize = 512;

std::vector<Groove> copies(const std::vector<StrokeLine>& strokes) {
  const Brush brush = fitted({}, strokes);
  std::vector<Groove> grooves;
  for (const StrokeLine& line : strokes) grooves.push_back(groove_of(line, brush));
  return grooves;
}

surface::HeightMap grooved(const std::vector<Groove>& grooves, int size = kSize) {
  auto map = carve_grooves(grooves, size);
  if (!map) {
    ADD_FAILURE() << base::to_line(map.error());
    return {};
  }
  return *std::move(map);
}

float largest_difference(const surface::HeightMap& a, const surface::HeightMap& b) {
  float worst = 0;
  for (std::size_t i = 0; i < a.samples().size(); ++i)
    worst = std::max(worst, std::abs(a.samples()[i] - b.samples()[i]));
  return worst;
}

/// Grooves whose width and depth wander, too.
std::vector<Groove> random_grooves(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> width(0, 6);
  std::uniform_real_distribution<double> depth(0.1, 1);
  std::vector<Groove> grooves;
  for (const StrokeLine& line : random_strokes(seed)) {
    Groove groove;
    for (const GlyphPoint p : line.points) groove.push_back({p, width(random), depth(random)});
    grooves.push_back(std::move(groove));
  }
  return grooves;
}

TEST(Groove, TheCopyOfAStrokeIsCarvedLikeTheStroke) {
  for (const std::string character : {"休", "永", "鬱", "口", "書", "あ", "の", "る"}) {
    const auto strokes = kanjivg(character);
    EXPECT_LT(largest_difference(carved(strokes, kSize, {}), grooved(copies(strokes))), 0.017F) << character;
  }
}

TEST(Groove, ACopyHasFewPoints) {
  std::size_t points = 0;
  std::size_t strokes = 0;
  for (const std::string character : {"休", "永", "鬱", "書"}) {
    for (const Groove& groove : copies(kanjivg(character))) {
      points += groove.size();
      ++strokes;
    }
  }
  EXPECT_LT(static_cast<double>(points) / static_cast<double>(strokes), 30);
}

TEST(Groove, AcrossAStraightGrooveLiesTheRoundedProfile) {
  // Depth (1 - x^2)^2 at x half widths from the centre line.
  const auto map = grooved({{{{20, 54.5}, 8, 0.6}, {{90, 54.5}, 8, 0.6}}}, 1091);
  for (int row = 0; row < 1091; ++row) {
    const double x = std::min(std::abs(row * 0.1 - 54.5) / 8, 1.0);
    const double u = 1 - x * x;
    EXPECT_NEAR(map.at(545, row), 1 - 0.6 * u * u, 2e-6) << row;
  }
}

TEST(Groove, WidthAndDepthChangeEvenlyBetweenTwoPoints) {
  const auto map = grooved({{{{20, 54.5}, 2, 0.2}, {{90, 54.5}, 9, 0.9}}}, 1091);
  for (int column = 210; column < 890; column += 17) {
    const double t = (column * 0.1 - 20) / 70;
    EXPECT_NEAR(map.at(column, 545), 1 - (0.2 + 0.7 * t), 2e-5) << column;
    // Half of the half width away the depth is 9/16 of that.
    const double half_width = 2 + 7 * t;
    const auto row = 545 + static_cast<int>(std::lround(half_width * 5));
    const double x = (row - 545) * 0.1 / half_width;
    const double u = 1 - x * x;
    EXPECT_NEAR(map.at(column, row), 1 - (0.2 + 0.7 * t) * u * u, 2e-3) << column;
  }
}

TEST(Groove, WidthAndDepthPassThroughTheirPointsAndNeverOvershoot) {
  const Groove groove{
      {{10, 50}, 2, 0.3}, {{30, 50}, 6, 1}, {{50, 50}, 6, 1}, {{55, 50}, 1, 0.2}, {{95, 50}, 3, 0.4}};
  const auto line = smooth_line(groove);
  std::size_t met = 0;
  for (const SmoothPoint& p : line) {
    const GroovePoint& a = groove[p.segment];
    const GroovePoint& b = groove[std::min(p.segment + 1, groove.size() - 1)];
    EXPECT_GE(p.half_width, std::min(a.half_width, b.half_width));
    EXPECT_LE(p.half_width, std::max(a.half_width, b.half_width));
    EXPECT_GE(p.depth, std::min(a.depth, b.depth));
    EXPECT_LE(p.depth, std::max(a.depth, b.depth));
    EXPECT_NEAR(p.arc_length, p.at.x - 10, 1e-9);
    if (p.at == a.at) {
      EXPECT_EQ(p.half_width, a.half_width);
      EXPECT_EQ(p.depth, a.depth);
      ++met;
    }
  }
  EXPECT_EQ(met, groove.size());
  EXPECT_EQ(line.back().segment, groove.size() - 1);
}

TEST(Groove, TheWidthHasNoKinkAtAPoint) {
  const Groove groove{{{10, 50}, 2, 1}, {{40, 50}, 4, 1}, {{70, 50}, 9, 1}};
  // The harmonic mean of the slopes 2/30 and 5/30, as Fritsch and Butland weigh them for equal steps.
  const double slope = 2 / (30.0 / 2 + 30.0 / 5);
  const auto line = smooth_line(groove);
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (std::abs(line[i].at.x - 40) > 1.2 || line[i].at.x == 40) continue;
    EXPECT_NEAR((line[i].half_width - 4) / (line[i].at.x - 40), slope, 0.006);
  }
}

TEST(Groove, ACarvedBoxIsTheSamePartOfTheWholeToTheLastBit) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const auto grooves = seed % 3 == 0 ? copies(kanjivg(seed % 2 == 0 ? "鬱" : "る")) : random_grooves(seed);
    const auto whole = grooved(grooves);
    std::mt19937 random(seed);
    for (int k = 0; k < 6; ++k) {
      int x[2] = {static_cast<int>(random() % kSize), static_cast<int>(random() % kSize)};
      int y[2] = {static_cast<int>(random() % kSize), static_cast<int>(random() % kSize)};
      const GridBox box{std::min(x[0], x[1]), std::min(y[0], y[1]), std::max(x[0], x[1]) + 1,
                        std::max(y[0], y[1]) + 1};
      auto map = surface::HeightMap::create(kSize, 0.25F);
      ASSERT_TRUE(carve_grooves_in(box, grooves, *map));
      for (int row = 0; row < kSize; ++row) {
        for (int column = 0; column < kSize; ++column) {
          const bool inside = column >= box.left && column < box.right && row >= box.top && row < box.bottom;
          ASSERT_EQ(map->at(column, row), inside ? whole.at(column, row) : 0.25F)
              << seed << ": " << column << ", " << row;
        }
      }
    }
  }
}

TEST(Groove, ItChangesNothingOutsideOfItsBox) {
  for (unsigned seed = 20; seed < 40; ++seed) {
    for (const Groove& groove : random_grooves(seed)) {
      const auto map = grooved({groove});
      const GridBox box = box_of(groove, kSize);
      for (int row = 0; row < kSize; ++row) {
        for (int column = 0; column < kSize; ++column) {
          if (map.at(column, row) == 1.0F) continue;
          ASSERT_TRUE(column >= box.left && column < box.right && row >= box.top && row < box.bottom)
              << seed << ": " << column << ", " << row;
        }
      }
    }
  }
}

TEST(Groove, TheBoxOfALevelGrooveReachesOneAndAHalfHalfWidthsAroundIt) {
  const Groove groove{{{20, 50}, 4, 1}, {{60, 50}, 4, 1}};
  // One sample a glyph unit.
  EXPECT_EQ(box_of(groove, 110), (GridBox{14, 44, 67, 57}));
  EXPECT_TRUE(box_of({{{-50, 50}, 4, 1}}, 110).is_empty());
}

TEST(Groove, OrderAndRepetitionDoNotChangeABit) {
  for (unsigned seed = 50; seed < 56; ++seed) {
    auto grooves = random_grooves(seed);
    const auto map = grooved(grooves);
    std::reverse(grooves.begin(), grooves.end());
    grooves.push_back(grooves[1]);
    EXPECT_EQ(map, grooved(grooves));
  }
}

TEST(Groove, OneThatDiffersOnlyInItsWidthIsAnother) {
  const Groove narrow{{{20, 50}, 3, 1}, {{60, 50}, 3, 1}};
  Groove wide = narrow;
  wide[1].half_width = 9;
  EXPECT_NE(grooved({narrow, wide}), grooved({narrow}));
  EXPECT_NE(grooved({narrow, wide}), grooved({wide}));
}

TEST(Groove, WhatIsOutOfRangeIsRefusedByName) {
  const auto refused = [](const Groove& groove, int size = 64) {
    const auto map = carve_grooves(std::vector<Groove>{{{{1, 1}, 1, 1}}, groove}, size);
    return map ? std::string() : map.error().where;
  };
  EXPECT_EQ(refused({}), "stroke 2");
  EXPECT_EQ(refused({{{1, 1}, 1, 1}, {{1, NAN}, 1, 1}}), "stroke 2, point 2");
  EXPECT_EQ(refused({{{1200, 1}, 1, 1}}), "stroke 2, point 1");
  EXPECT_EQ(refused({{{1, 1}, 20, 1}}), "");
  EXPECT_EQ(refused({{{1, 1}, 20.01, 1}}), "stroke 2, point 1");
  EXPECT_EQ(refused({{{1, 1}, -0.01, 1}}), "stroke 2, point 1");
  EXPECT_EQ(refused({{{1, 1}, 1, 1.01}}), "stroke 2, point 1");
  EXPECT_EQ(refused({{{1, 1}, 0, 0}}), "");
  EXPECT_FALSE(carve_grooves({}, 1));
  EXPECT_TRUE(carve_grooves({}, 2));
}

TEST(GridBox, UnitesAndIntersects) {
  const GridBox a{1, 2, 5, 6};
  const GridBox b{4, 1, 9, 3};
  EXPECT_EQ(united(a, b), (GridBox{1, 1, 9, 6}));
  EXPECT_EQ(common(a, b), (GridBox{4, 2, 5, 3}));
  EXPECT_EQ(united(a, {}), a);
  EXPECT_EQ(united({7, 7, 7, 9}, b), b);
  EXPECT_EQ(common(a, {5, 2, 9, 6}), GridBox{});
  EXPECT_EQ(whole_map(8), (GridBox{0, 0, 8, 8}));
}

}  // namespace
}  // namespace nazori::carving
