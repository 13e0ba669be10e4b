// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/relief.h"

#include <gtest/gtest.h>

#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

using namespace test;

TEST(Relief, PaintRisesAboveThePaperByItsAmount) {
  Sheet sheet = sheet_of(128);
  sheet.drop(64, 64, kOne, {2 * kOne, kOne, 0});
  const auto map = relief_of(sheet, {.paper = 0.3, .per_filling = 0.1, .tooth = 0, .smooth_m = 0});
  EXPECT_EQ(map.size(), 128);
  EXPECT_NEAR(map.at(64, 64), 0.6, 1e-6);
  EXPECT_NEAR(map.at(65, 64), 0.3, 1e-6);
  sheet.dry_now();
  EXPECT_NEAR(relief_of(sheet, {.tooth = 0, .smooth_m = 0}).at(64, 64), 0.6, 1e-6);
}

TEST(Relief, DryLayersCountAndTheHeightIsLimited) {
  Sheet sheet = sheet_of(128);
  float last = 0;
  for (int layer = 0; layer < 12; ++layer) {
    sheet.drop(64, 64, kOne, {kOne, 0, 0});
    const float now = relief_of(sheet, {.tooth = 0, .smooth_m = 0}).at(64, 64);
    EXPECT_NEAR(now, std::min(0.3 + 0.1 * (layer + 1), 1.0), 1e-6);
    EXPECT_GE(now, last);
    last = now;
    sheet.dry_now();
  }
  EXPECT_GT(sheet.at(64, 64).covered, 0);
}

TEST(Relief, BarePaperHasItsGrainAndPaintFillsIt) {
  Sheet sheet = sheet_of(128);
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 128; ++column) sheet.drop(column, row, kOne, {kOne, 0, 0});
  const auto map = relief_of(sheet, {.paper = 0.3, .per_filling = 0.1, .tooth = 0.02, .smooth_m = 0});
  float low = 1, high = 0;
  for (int column = 0; column < 128; ++column) {
    EXPECT_NEAR(map.at(column, 30), 0.4, 1e-6);
    low = std::min(low, map.at(column, 100));
    high = std::max(high, map.at(column, 100));
  }
  EXPECT_LT(low, 0.285);
  EXPECT_GE(low, 0.28F - 1e-6F);
  EXPECT_GT(high, 0.295);
  EXPECT_LE(high, 0.3F);
}

TEST(Relief, PaintIsLevelledAndKeepsItsVolume) {
  Sheet sheet = sheet_of(512);
  sheet.drop(200, 200, kOne, {5 * kOne, 0, 0});
  const ReliefOptions options{.paper = 0.3, .per_filling = 0.1, .tooth = 0, .smooth_m = 0.001};
  const auto map = relief_of(sheet, options);
  double volume = 0;
  for (const float height : map.samples()) volume += static_cast<double>(height) - 0.3;
  EXPECT_NEAR(volume, 0.5, 0.01);
  EXPECT_NEAR(map.at(198, 202), 0.3 + 0.5 / 49, 1e-4);  // 7 x 7 cells: 1 mm is 2.5 cells to each side
  EXPECT_NEAR(map.at(204, 200), 0.3, 1e-6);
}

}  // namespace
}  // namespace nazori::paint
