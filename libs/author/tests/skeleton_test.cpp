// SPDX-License-Identifier: Apache-2.0
#include "skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "distance_map.h"

namespace nazori::author {
namespace {

using Picture = std::vector<std::uint8_t>;

Picture random_ink(int side, unsigned seed, unsigned of_ten) {
  std::mt19937 random(seed);
  Picture ink;
  for (int i = 0; i < side * side; ++i) ink.push_back(random() % 10 < of_ten ? 1 : 0);
  return ink;
}

template <class Inside>
Picture picture_of(int side, Inside inside) {
  Picture ink;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) ink.push_back(inside(x, y) ? 1 : 0);
  return ink;
}

/// Connected parts: of ink over corners, of paper over edges.
int parts(const Picture& picture, int side, std::uint8_t value) {
  Picture open = picture;
  int count = 0;
  for (std::size_t start = 0; start < open.size(); ++start) {
    if (open[start] != value) continue;
    ++count;
    std::vector<std::size_t> todo{start};
    open[start] = 2;
    while (!todo.empty()) {
      const int x = static_cast<int>(todo.back()) % side;
      const int y = static_cast<int>(todo.back()) / side;
      todo.pop_back();
      for (int v = std::max(0, y - 1); v <= std::min(side - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(side - 1, x + 1); ++u) {
          const auto i = static_cast<std::size_t>(v * side + u);
          if ((value == 0 && u != x && v != y) || open[i] != value) continue;
          open[i] = 2;
          todo.push_back(i);
        }
    }
  }
  return count;
}

TEST(DistanceMap, IsTheDistanceToTheNearestPixelWithoutInkOrOfTheFrame) {
  constexpr int kSide = 19;
  for (const unsigned of_ten : {5U, 9U, 10U}) {
    const Picture ink = random_ink(kSide, 3 + of_ten, of_ten);
    const DistanceMap map = distance_map(ink, kSide);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        double least = 1e9;
        for (int v = -1; v <= kSide; ++v)
          for (int u = -1; u <= kSide; ++u) {
            const bool outside = u < 0 || v < 0 || u >= kSide || v >= kSide;
            if (outside || ink[map.index(u, v)] == 0) least = std::min(least, std::hypot(u - x, v - y));
          }
        const std::size_t i = map.index(x, y);
        ASSERT_NEAR(static_cast<double>(map.distance[i]), least, 1e-5) << x << ", " << y;
        const Pixel foot = map.nearest[i];
        ASSERT_NEAR(std::hypot(foot.x - x, foot.y - y), least, 1e-5) << x << ", " << y;
        const bool outside = foot.x < 0 || foot.y < 0 || foot.x >= kSide || foot.y >= kSide;
        ASSERT_TRUE(outside || ink[map.index(foot.x, foot.y)] == 0) << x << ", " << y;
      }
  }
}

TEST(Thinned, KeepsPartsAndHoles) {
  constexpr int kSide = 24;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    // A frame of paper, so that paper that touches the edge is one part.
    Picture ink = random_ink(kSide, seed, 4 + seed % 5);
    for (int k = 0; k < kSide; ++k)
      for (const int i : {k, k * kSide, (kSide - 1) * kSide + k, k * kSide + kSide - 1})
        ink[static_cast<std::size_t>(i)] = 0;
    const DistanceMap map = distance_map(ink, kSide);
    const Picture none(ink.size());
    const Picture lines = thinned(ink, kSide, map.distance, none);
    EXPECT_EQ(parts(lines, kSide, 1), parts(ink, kSide, 1)) << seed;
    EXPECT_EQ(parts(lines, kSide, 0), parts(ink, kSide, 0)) << seed;
    for (std::size_t i = 0; i < ink.size(); ++i) ASSERT_LE(lines[i], ink[i]);
  }
}

TEST(Thinned, WithoutHolesLeavesOnePixelAPartWhereNothingIsKept) {
  constexpr int kSide = 31;
  const Picture disc = picture_of(kSide, [](int x, int y) { return std::hypot(x - 15, y - 15) < 9.5; });
  const DistanceMap map = distance_map(disc, kSide);
  const Picture none(disc.size());
  const Picture lines = thinned(disc, kSide, map.distance, none);
  ASSERT_EQ(std::count(lines.begin(), lines.end(), 1), 1);
  const auto at = std::find(lines.begin(), lines.end(), 1) - lines.begin();
  EXPECT_NEAR(static_cast<double>(at % kSide), 15, 1.0);
  EXPECT_NEAR(static_cast<double>(at / kSide), 15, 1.0);
}

TEST(Thinned, JoinsWhatIsKeptAlongTheHighest) {
  // A bar whose highest row is its third.
  constexpr int kSide = 30;
  const Picture bar = picture_of(kSide, [](int x, int y) { return x > 2 && x < 27 && y > 9 && y < 19; });
  std::vector<float> height;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) height.push_back(1.0F / (1.0F + std::abs(static_cast<float>(y - 12))));
  Picture kept(bar.size());
  kept[12 * kSide + 3] = kept[12 * kSide + 26] = 1;
  const Picture lines = thinned(bar, kSide, height, kept);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      EXPECT_EQ(lines[static_cast<std::size_t>(y * kSide + x)], y == 12 && x >= 3 && x <= 26 ? 1 : 0)
          << x << ", " << y;
}

TEST(Thinned, WithItsEndsKeptDoesNotShortenALine) {
  constexpr int kSide = 12;
  const Picture line = picture_of(kSide, [](int x, int y) { return y == 5 && x > 1 && x < 9; });
  const std::vector<float> height(line.size(), 1.0F);
  const Picture none(line.size());
  EXPECT_EQ(thinned(line, kSide, height, none, true), line);
  const Picture shortened = thinned(line, kSide, height, none);
  EXPECT_EQ(std::count(shortened.begin(), shortened.end(), 1), 1);
}

TEST(MiddleOf, ABarIsItsAxisWithoutItsCorners) {
  constexpr int kSide = 64;
  const Picture bar = picture_of(kSide, [](int x, int y) { return x > 9 && x < 55 && y > 20 && y < 36; });
  const DistanceMap map = distance_map(bar, kSide);
  Picture middle = middle_of(map);
  // Single pixels at the very corners, two from the rim, are no line.
  for (std::size_t i = 0; i < middle.size(); ++i)
    if (map.distance[i] < 3) middle[i] = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      if (middle[map.index(x, y)] != 0) {
        EXPECT_NEAR(y, 28, 1.0) << x;
        EXPECT_GT(x, 9 + 5);
        EXPECT_LT(x, 55 - 5);
      }
  for (int x = 20; x < 45; ++x) EXPECT_EQ(middle[map.index(x, 28)], 1) << x;
}

TEST(MiddleOf, ADiscIsNearItsCentreAlone) {
  constexpr int kSide = 64;
  const Picture disc = picture_of(kSide, [](int x, int y) { return std::hypot(x - 32, y - 32) < 20.4; });
  const DistanceMap map = distance_map(disc, kSide);
  const Picture middle = middle_of(map);
  EXPECT_GT(std::count(middle.begin(), middle.end(), 1), 0);
  int far = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      if (middle[map.index(x, y)] != 0 && std::hypot(x - 32, y - 32) > 3) ++far;
  EXPECT_EQ(far, 0);
}

}  // namespace
}  // namespace nazori::author
