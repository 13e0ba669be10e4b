// SPDX-License-Identifier: Apache-2.0
#include "nazori/tablet/trial_tablet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nazori::tablet {
namespace {

TEST(WallAndGroove, AFloorASteepWallAndARoundGrooveInThePlateau) {
  const auto tablet = wall_and_groove({});
  ASSERT_TRUE(tablet);
  const auto& map = tablet->height_map();
  const auto at = [&](double x) {
    return map.at(static_cast<int>(std::lround(x * (map.size() - 1))), map.size() / 3);
  };
  EXPECT_NEAR(at(0), 0.1, 1e-6);
  EXPECT_NEAR(at(0.29), 0.1, 1e-6);
  EXPECT_NEAR(at(0.33), 0.55, 0.02) << "half way up the wall";
  EXPECT_NEAR(at(0.37), 1, 1e-6);
  EXPECT_NEAR(at(0.5), 1, 1e-3);
  EXPECT_NEAR(at(0.68), 0.2, 0.01) << "the bottom of the groove";
  EXPECT_NEAR(at(0.68 - 0.035), at(0.68 + 0.035), 0.04) << "as steep on both sides";
  EXPECT_NEAR(at(0.68 + 0.035), 1 - 0.8 / std::numbers::e, 0.02);
  EXPECT_NEAR(at(1), 1, 1e-3);
  for (const int row : {0, map.size() - 1})
    EXPECT_EQ(map.at(10, row), map.at(10, 5)) << "the same in each row";
  ASSERT_EQ(tablet->paths().size(), 1U);
  const auto& path = tablet->paths()[0].points;
  // The stroke lies in the groove, from the upper part of the tablet to the lower one.
  const double width_m = tablet->shape().width_m;
  for (const auto& point : path) EXPECT_NEAR(point.x, (0.68 - 0.5) * width_m, 0.01 * width_m);
  EXPECT_GT(path.front().y, 0.2 * width_m);
  EXPECT_LT(path.back().y, -0.2 * width_m);
}

}  // namespace
}  // namespace nazori::tablet
