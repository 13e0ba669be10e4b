// SPDX-License-Identifier: Apache-2.0
// The lowest place of a ball on a plate, against every point of the ball.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../src/ball_cutter.h"
#include "nazori/model/plate.h"

namespace nazori::model {
namespace {

TEST(BallCutter, RestsWhereSomePointOfTheBallTouchesFirst) {
  Plate plate = Plate::create(8, 6, 0.5, 3).value();
  plate.add_dot({3, 2}, 2.5, 1.2);
  plate.add_line(PlateLine{{6, 0}, {6, 6}}, {0.7, 1});
  // Heights over the face at the samples and half way between them.
  const auto height = [&](int column, int row) {
    double sum = 0;
    for (const int c : {column / 2, (column + 1) / 2})
      for (const int r : {row / 2, (row + 1) / 2}) sum += static_cast<double>(plate.at(c, r)) - 3;
    return sum / 4;
  };
  for (const double radius : {0.4, 1.3}) {
    const BallCutter cutter(plate, radius);
    for (double x = 0; x <= 8; x += 0.37)
      for (double y = 0; y <= 6; y += 0.41) {
        double highest = -1e9;
        for (int row = 0; row <= 24; ++row)
          for (int column = 0; column <= 32; ++column) {
            const double d2 = std::pow(column * 0.25 - x, 2) + std::pow(row * 0.25 - y, 2);
            if (d2 <= radius * radius)
              highest = std::max(highest, height(column, row) + std::sqrt(radius * radius - d2));
          }
        ASSERT_NEAR(cutter.lowest_tip({x, y}), highest - radius, 1e-5) << x << " " << y;
      }
    for (const PlatePoint outside :
         {PlatePoint{-0.01, 3}, PlatePoint{8.01, 3}, PlatePoint{6, -0.01}, PlatePoint{6, 6.01}})
      EXPECT_EQ(cutter.lowest_tip(outside), 0);
  }
}

}  // namespace
}  // namespace nazori::model
