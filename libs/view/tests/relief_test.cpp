// SPDX-License-Identifier: Apache-2.0
#include "../src/relief.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nazori::view {
namespace {

surface::HeightMap map_of(int size, auto height) {
  surface::HeightMap map = surface::HeightMap::create(size).value();
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      map.set(column, row,
              static_cast<float>(
                  height(static_cast<double>(column) / (size - 1), static_cast<double>(row) / (size - 1))));
  return map;
}

/// A bowl: where Catmull-Rom has all its samples it meets every polynomial of second degree exactly.
double bowl(double x, double y) {
  return 0.2 + 0.5 * (x - 0.4) * (x - 0.4) + 0.3 * (y - 0.6) * (y - 0.6) + 0.1 * x * y;
}

TEST(Resampled, FinerMeetsABowlExactlyAwayFromTheRim) {
  constexpr int kFrom = 17;
  constexpr int kTo = 65;
  const Relief fine = resampled(map_of(kFrom, bowl), kTo);
  ASSERT_EQ(fine.size, kTo);
  for (int row = 4; row <= kTo - 5; ++row)
    for (int column = 4; column <= kTo - 5; ++column)
      EXPECT_NEAR(fine.at(column, row), bowl(column / 64.0, row / 64.0), 1e-6) << column << " " << row;
}

TEST(Resampled, FinerKeepsTheSamplesAndStaysWithinTheirRange) {
  const auto step = [](double x, double) { return x < 0.5 ? 0.0 : 1.0; };
  const surface::HeightMap map = map_of(9, step);
  const Relief fine = resampled(map, 33);
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 9; ++column)
      EXPECT_NEAR(fine.at(4 * column, 4 * row), map.at(column, row), 1e-6);
  for (const float height : fine.heights) {
    EXPECT_GE(height, 0);
    EXPECT_LE(height, 1);
  }
}

TEST(Resampled, CoarserKeepsAPlaneAndSkipsNothingFine) {
  const auto plane = [](double x, double y) { return 0.1 + 0.6 * x + 0.2 * y; };
  const Relief coarse = resampled(map_of(129, plane), 33);
  for (int row = 1; row < 32; ++row)
    for (int column = 1; column < 32; ++column)
      EXPECT_NEAR(coarse.at(column, row), plane(column / 32.0, row / 32.0), 1e-6);
  // A groove of one sample, wherever it lies, takes as much of the coarse map: a quarter of a sample's width.
  for (int at = 40; at < 48; ++at) {
    const Relief lines =
        resampled(map_of(129, [at](double x, double) { return std::lround(x * 128) == at ? 0.0 : 1.0; }), 33);
    double missing = 0;
    for (int column = 0; column < 33; ++column) missing += 1 - lines.at(column, 16);
    EXPECT_NEAR(missing, 0.25, 1e-5) << at;
  }
}

TEST(Resampled, TheSameSizeIsTheMapItself) {
  const surface::HeightMap map = map_of(33, bowl);
  const Relief same = resampled(map, 33);
  for (int row = 0; row < 33; ++row)
    for (int column = 0; column < 33; ++column) EXPECT_EQ(same.at(column, row), map.at(column, row));
}

}  // namespace
}  // namespace nazori::view
