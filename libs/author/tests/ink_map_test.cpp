// SPDX-License-Identifier: Apache-2.0
#include "ink_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace nazori::author::test {
namespace {

scan::Photo paper(int width, int height, int brightness) {
  return {width, height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                                    static_cast<std::uint8_t>(brightness))};
}

void fill(scan::Photo& photo, int left, int top, int right, int bottom, int brightness) {
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      photo.grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(photo.width) +
                 static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(brightness);
}

std::string why(const scan::Photo& photo) {
  const auto map = author::ink_of(photo);
  return map ? std::string() : map.error().what;
}

std::ptrdiff_t count_ink(const InkMap& map) { return std::ranges::count(map.ink, 1); }

TEST(Between, IsBilinearAndKeepsTheValuesOfTheEdgesOutside) {
  std::vector<float> values;
  for (int y = 0; y < kInkSide; ++y)
    for (int x = 0; x < kInkSide; ++x) values.push_back(static_cast<float>(x * y + 2 * x - y));
  const auto truth = [](double x, double y) { return x * y + 2 * x - y; };
  for (const geometry::GridPoint p :
       std::vector<geometry::GridPoint>{{0, 0}, {3, 5}, {3.25, 5.5}, {510.5, 20.75}, {7.5, 510.5}})
    EXPECT_NEAR(static_cast<double>(between(values, p)), truth(p.x, p.y), 0.02 + 1e-6 * truth(p.x, p.y));
  EXPECT_NEAR(static_cast<double>(between(values, {-4, 12.5})), truth(0, 12.5), 0.02);
  EXPECT_NEAR(static_cast<double>(between(values, {12.5, -1})), truth(12.5, 0), 0.02);
  EXPECT_NEAR(static_cast<double>(between(values, {600, 2})), truth(511, 2), 0.1);
  EXPECT_NEAR(static_cast<double>(between(values, {2, 600})), truth(2, 511), 0.1);
}

TEST(Blur, IsABellInBothDirections) {
  constexpr int kWidth = 31;
  constexpr int kHeight = 21;
  for (const double sigma : {0.5, 1.0, 1.7}) {
    std::vector<float> values(kWidth * kHeight);
    values[10 * kWidth + 15] = 1;
    blur(values, kWidth, kHeight, sigma);
    // Cut off at 2.5 sigma, to whole samples upwards.
    const int reach = static_cast<int>(std::ceil(2.5 * sigma));
    double sum = 0;
    for (int k = -reach; k <= reach; ++k) sum += std::exp(-k * k / (2 * sigma * sigma));
    const auto bell = [&](int k) {
      return std::abs(k) > reach ? 0 : std::exp(-k * k / (2 * sigma * sigma)) / sum;
    };
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        EXPECT_NEAR(static_cast<double>(values[static_cast<std::size_t>(y * kWidth + x)]),
                    bell(x - 15) * bell(y - 10), 1e-6)
            << x << ", " << y;
  }
}

TEST(Blur, GoesOnWithTheValuesOfTheEdges) {
  std::vector<float> level(12 * 7, 0.75F);
  blur(level, 12, 7, 2);
  for (const float v : level) EXPECT_NEAR(static_cast<double>(v), 0.75, 1e-6);
  std::vector<float> sharp{1, 0, 5, 2};
  blur(sharp, 2, 2, 0);
  EXPECT_EQ(sharp, (std::vector<float>{1, 0, 5, 2}));
}

/// A map of 512 samples a side, level but for what is set.
surface::HeightMap level_map() { return *surface::HeightMap::create(kInkSide, 1.0F); }

void dig(surface::HeightMap& map, int left, int top, int right, int bottom, float depth) {
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) map.set(x, y, 1 - depth);
}

TEST(InkOfAHeightMap, IsWhatIsDeeperThanItsNoise) {
  surface::HeightMap map = level_map();
  dig(map, 100, 50, 200, 150, 0.0087F);
  dig(map, 300, 50, 400, 150, 0.0083F);
  const auto ink = author::ink_of(map);
  ASSERT_TRUE(ink);
  EXPECT_EQ(count_ink(*ink), 100 * 100);
  EXPECT_EQ(ink->ink[ink->index(100, 50)], 1);
  EXPECT_EQ(ink->ink[ink->index(199, 149)], 1);
  EXPECT_TRUE(ink->is_groove);
  EXPECT_NEAR(static_cast<double>(ink->depth[ink->index(150, 100)]), 0.0087, 1e-6);
  EXPECT_NEAR(static_cast<double>(ink->level[ink->index(150, 100)]), 0.0087 / 0.0085, 1e-4);
  EXPECT_EQ(ink->distance.distance[ink->index(100, 100)], 1.0F);
}

TEST(InkOfAHeightMap, SpecksAndPinHolesOfLessThanAUnitGo) {
  // A glyph unit is 4.688 samples, its square 21.98.
  surface::HeightMap map = level_map();
  dig(map, 100, 100, 200, 200, 0.5F);
  dig(map, 120, 120, 124, 125, 0);  // 20 samples
  dig(map, 160, 120, 167, 123, 0);  // 21
  dig(map, 300, 100, 304, 105, 0.5F);
  dig(map, 300, 150, 307, 153, 0.5F);
  const auto ink = author::ink_of(map);
  ASSERT_TRUE(ink);
  EXPECT_EQ(ink->ink[ink->index(121, 121)], 1);
  EXPECT_GT(ink->level[ink->index(121, 121)], 1.0F);
  EXPECT_EQ(ink->ink[ink->index(161, 121)], 0);
  EXPECT_EQ(ink->ink[ink->index(301, 101)], 0);
  EXPECT_EQ(ink->level[ink->index(301, 101)], 0.0F);
  EXPECT_EQ(ink->ink[ink->index(301, 151)], 1);
  EXPECT_EQ(count_ink(*ink), 100 * 100 - 21 + 21);
}

TEST(InkOfAHeightMap, InkIsOneOverCornersAndPaperIsNot) {
  surface::HeightMap map = level_map();
  dig(map, 100, 100, 104, 104, 0.5F);  // 16 and 16 samples that meet at a corner
  dig(map, 104, 104, 108, 108, 0.5F);
  dig(map, 200, 200, 300, 300, 0.5F);
  dig(map, 210, 210, 214, 214, 0);
  dig(map, 214, 214, 218, 218, 0);
  const auto ink = author::ink_of(map);
  ASSERT_TRUE(ink);
  EXPECT_EQ(count_ink(*ink), 32 + 100 * 100);
  EXPECT_EQ(ink->ink[ink->index(100, 100)], 1);
  EXPECT_EQ(ink->ink[ink->index(212, 212)], 1);
}

TEST(InkOfAHeightMap, PartsAtTheEdgesAreSeenWhole) {
  surface::HeightMap map = level_map();
  dig(map, 0, 0, 2, 20, 0.5F);
  dig(map, 510, 490, 512, 512, 0.5F);
  dig(map, 200, 0, 220, 2, 0.5F);
  const auto ink = author::ink_of(map);
  ASSERT_TRUE(ink);
  EXPECT_EQ(count_ink(*ink), 40 + 44 + 40);
}

TEST(InkOfAHeightMap, NothingAndNearlyAllAreRefused) {
  EXPECT_EQ(author::ink_of(level_map()).error().what, "the height map has no groove");
  surface::HeightMap map = level_map();
  dig(map, 0, 0, 512, 384, 0.5F);
  EXPECT_TRUE(author::ink_of(map)) << "three quarters";
  dig(map, 0, 0, 512, 385, 0.5F);
  EXPECT_EQ(author::ink_of(map).error().what, "nearly the whole height map is groove");
  EXPECT_EQ(author::ink_of(surface::HeightMap()).error().what, "no height map is loaded");
}

TEST(InkOfAHeightMap, OfAnotherSizeHasTheMeanAroundEachSample) {
  // Depth rises evenly to the right, so a mean is the value in the middle.
  surface::HeightMap map = *surface::HeightMap::create(1600, 1.0F);
  for (int y = 400; y < 800; ++y)
    for (int x = 200; x < 1200; ++x) map.set(x, y, 1 - 0.0005F * static_cast<float>(x - 150));
  const auto ink = author::ink_of(map);
  ASSERT_TRUE(ink);
  const double scale = 1599.0 / 511;
  for (const int x : {100, 150, 200, 300})
    EXPECT_NEAR(static_cast<double>(ink->depth[ink->index(x, 190)]), 0.0005 * (x * scale - 150), 1e-4) << x;
  EXPECT_EQ(ink->ink[ink->index(63, 190)], 0);
  EXPECT_EQ(ink->ink[ink->index(66, 190)], 1);
  EXPECT_EQ(ink->ink[ink->index(382, 190)], 1);
  EXPECT_EQ(ink->ink[ink->index(385, 190)], 0);
  EXPECT_EQ(ink->ink[ink->index(150, 126)], 0);
  EXPECT_EQ(ink->ink[ink->index(150, 129)], 1);
}

TEST(InkOfAPhoto, LiesInTheMiddleOfTheBoxWithAMargin) {
  scan::Photo photo = paper(600, 400, 220);
  fill(photo, 100, 150, 472, 190, 20);
  const auto ink = author::ink_of(photo);
  ASSERT_TRUE(ink) << base::to_line(ink.error());
  // 372 pixels are 93 units: 4 pixels a unit. The middle of the ink is at (285.5, 169.5).
  EXPECT_NEAR(ink->place.pixels_per_unit, 4, 1e-9);
  EXPECT_NEAR(ink->place.left, 285.5 - 4 * 54.5, 1e-9);
  EXPECT_NEAR(ink->place.top, 169.5 - 4 * 54.5, 1e-9);
  EXPECT_FALSE(ink->is_groove);
  // Its ink is 93 units long and 10 high.
  EXPECT_NEAR(static_cast<double>(count_ink(*ink)), 930 * kInkPerUnit * kInkPerUnit, 600);
  EXPECT_EQ(*std::ranges::min_element(ink->depth), 1.0F);
  const int middle = kInkSide / 2;
  EXPECT_EQ(ink->ink[ink->index(middle, middle)], 1);
  const int half = static_cast<int>(5 * kInkPerUnit);
  EXPECT_EQ(ink->ink[ink->index(middle, middle - half + 1)], 1);
  EXPECT_EQ(ink->ink[ink->index(middle, middle - half - 3)], 0);
  EXPECT_EQ(ink->ink[ink->index(middle, middle + half - 1)], 1);
  EXPECT_EQ(ink->ink[ink->index(middle, middle + half + 3)], 0);
}

TEST(InkOfAPhoto, AHighOneHasItsMarginAboveAndBelow) {
  scan::Photo photo = paper(400, 600, 220);
  fill(photo, 150, 100, 190, 472, 20);
  const auto ink = author::ink_of(photo);
  ASSERT_TRUE(ink);
  EXPECT_NEAR(ink->place.pixels_per_unit, 4, 1e-9);
  EXPECT_NEAR(ink->place.left, 169.5 - 4 * 54.5, 1e-9);
  EXPECT_NEAR(ink->place.top, 285.5 - 4 * 54.5, 1e-9);
}

TEST(InkOfAPhoto, ALargeOneIsReadInSteps) {
  // 2,800 pixels are read by two, one more by three.
  scan::Photo photo = paper(2800, 1000, 220);
  fill(photo, 200, 400, 200 + 2 * 930, 500, 20);
  const auto two = author::ink_of(photo);
  ASSERT_TRUE(two);
  EXPECT_NEAR(two->place.pixels_per_unit, 20, 1e-9);
  EXPECT_NEAR(two->place.left, 1129.5 - 20 * 54.5, 1e-9);
  EXPECT_NEAR(two->place.top, 449.5 - 20 * 54.5, 1e-9);
  scan::Photo larger = paper(2801, 1000, 220);
  fill(larger, 300, 402, 300 + 3 * 558, 501, 20);
  const auto three = author::ink_of(larger);
  ASSERT_TRUE(three);
  EXPECT_NEAR(three->place.pixels_per_unit, 18, 1e-9);
  EXPECT_NEAR(three->place.left, 300 + 837 - 0.5 - 18 * 54.5, 1e-9);
  EXPECT_NEAR(three->place.top, 451 - 18 * 54.5, 1e-9);
}

TEST(InkOfAPhoto, SpecksAreNotInItsBox) {
  scan::Photo photo = paper(600, 400, 220);
  fill(photo, 100, 150, 472, 190, 20);
  fill(photo, 20, 20, 24, 24, 20);
  auto ink = author::ink_of(photo);
  ASSERT_TRUE(ink);
  EXPECT_NEAR(ink->place.pixels_per_unit, 4, 1e-9);
  // One of 180 pixels, more than a hundredth of the ink, is writing.
  fill(photo, 20, 20, 35, 35, 20);
  ink = author::ink_of(photo);
  ASSERT_TRUE(ink);
  EXPECT_NEAR(ink->place.pixels_per_unit, (472 - 20) / 93.0, 1e-9);
  EXPECT_NEAR(ink->place.top, (20 + 189) / 2.0 - ink->place.pixels_per_unit * 54.5, 1e-9);
}

TEST(InkOfAPhoto, WhatIsTooDarkTooFaintOrTooNarrowIsRefused) {
  const auto with_ink = [](int brightness, int ink) {
    scan::Photo photo = paper(600, 400, brightness);
    fill(photo, 100, 150, 472, 190, ink);
    return why(photo);
  };
  EXPECT_EQ(with_ink(23, 2), "there is nothing but ink in the picture");
  EXPECT_EQ(with_ink(25, 2), "");
  // Ink is darker than the paper by 0.24 of it.
  EXPECT_EQ(with_ink(200, 156), "there is no ink in the picture");
  EXPECT_EQ(with_ink(200, 144), "");
  EXPECT_EQ(why(paper(600, 400, 200)), "there is no ink in the picture");
  scan::Photo narrow = paper(600, 9, 200);
  fill(narrow, 100, 4, 400, 6, 10);
  EXPECT_EQ(why(narrow), "the picture is too narrow");
  narrow = paper(600, 10, 200);
  fill(narrow, 100, 4, 400, 6, 10);
  EXPECT_EQ(why(narrow), "");
  scan::Photo thin = paper(9, 600, 200);
  EXPECT_EQ(why(thin), "the picture is too narrow");
}

TEST(InkOfAPhoto, NothingButSpecksIsNoInk) {
  scan::Photo photo = paper(600, 400, 220);
  for (int y = 10; y < 390; y += 20)
    for (int x = 10; x < 590; x += 20) fill(photo, x, y, x + 2, y + 2, 10);
  EXPECT_EQ(why(photo), "there is no ink in the picture");
}

TEST(InkOfAPhoto, AThickStrokeOfSeveralTilesIsInkInside) {
  // The picture is seen in ten tiles a side of 60 x 40 pixels; six of them are all ink.
  scan::Photo photo = paper(600, 400, 220);
  fill(photo, 175, 115, 365, 205, 20);
  const auto ink = author::ink_of(photo);
  ASSERT_TRUE(ink);
  const double side = 93 * kInkPerUnit;
  EXPECT_NEAR(static_cast<double>(count_ink(*ink)), side * side * 90 / 190, side * 6);
  EXPECT_EQ(ink->ink[ink->index(256, 256)], 1);
}

TEST(InkOfAPhoto, LightThatFallsOffIsNoInk) {
  scan::Photo photo = paper(600, 400, 0);
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 600; ++x) fill(photo, x, y, x + 1, y + 1, 235 - x / 5 - y / 8);
  fill(photo, 100, 150, 472, 190, 20);
  const auto ink = author::ink_of(photo);
  ASSERT_TRUE(ink);
  EXPECT_NEAR(ink->place.pixels_per_unit, 4, 1e-9);
  EXPECT_NEAR(ink->place.left, 285.5 - 4 * 54.5, 1e-9);
  EXPECT_NEAR(ink->place.top, 169.5 - 4 * 54.5, 1e-9);
}

}  // namespace
}  // namespace nazori::author::test
