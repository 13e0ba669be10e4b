// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/plate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "test_plates.h"

namespace nazori::model {
namespace {

using testing::HasSubstr;

Plate flat(double width = 40, double height = 20, double step = 0.1) {
  return Plate::create(width, height, step, 3).value();
}

double rise(const Plate& plate, double x, double y) {
  return plate.at(static_cast<int>(std::lround(x / plate.step_mm())),
                  static_cast<int>(std::lround(y / plate.step_mm()))) -
         plate.thickness_mm();
}

double highest(const Plate& plate) {
  return *std::max_element(plate.heights().begin(), plate.heights().end());
}

TEST(Plate, ItsSidesAreRoundedUpToWholeSteps) {
  const Plate plate = Plate::create(10, 4.9, 0.25, 3).value();
  EXPECT_EQ(plate.columns(), 41);
  EXPECT_EQ(plate.rows(), 21);
  EXPECT_DOUBLE_EQ(plate.height_mm(), 5);
  EXPECT_EQ(Plate::create(100, 100, 0.1, 3).value().columns(), 1001);
}

TEST(Plate, WhatIsOutOfRangeIsRefused) {
  EXPECT_THAT(Plate::create(0.5, 10, 0.1, 3).error().what, HasSubstr("0.5 x 10"));
  EXPECT_FALSE(Plate::create(10, 1001, 1, 3));
  EXPECT_FALSE(Plate::create(10, std::nan(""), 1, 3));
  EXPECT_FALSE(Plate::create(10, 10, 0.01, 3));
  EXPECT_FALSE(Plate::create(10, 10, 0.1, 0.3));
  EXPECT_THAT(Plate::create(1000, 1000, 0.1, 3).error().remedy, HasSubstr("4000000"));
  EXPECT_TRUE(Plate::create(1000, 1000, 0.51, 3));
}

TEST(Plate, ASunkMapIsUprightAndInItsPlace) {
  auto map = surface::HeightMap::create(11).value();
  map.set(2, 0, 0.0F);  // near the upper left corner of the picture
  Plate plate = flat();
  plate.sink(map, {5, 3}, 10, 2);
  EXPECT_NEAR(rise(plate, 7, 13), -2, 1e-5);
  EXPECT_NEAR(rise(plate, 7.5, 13), -1, 1e-5);  // half way to the next sample
  EXPECT_NEAR(rise(plate, 7, 12.5), -1, 1e-5);
  EXPECT_EQ(rise(plate, 8, 13), 0);
  EXPECT_EQ(rise(plate, 4.9, 3), 0);
}

TEST(Plate, APutMapRisesFromThePlate) {
  auto map = surface::HeightMap::create(11, 0.0F).value();
  map.set(10, 10, 1.0F);
  Plate plate = flat();
  plate.put(map, {5, 3}, 10, 4);
  EXPECT_NEAR(rise(plate, 15, 3), 4, 1e-5);
  EXPECT_EQ(rise(plate, 5, 13), 0);
}

TEST(Plate, AMapThatIsPartlyOutsideIsCutOff) {
  Plate plate = flat(20, 20);
  plate.sink(surface::HeightMap::create(11, 0.0F).value(), {15, -5}, 10, 1);
  EXPECT_NEAR(rise(plate, 20, 0), -1, 1e-6);
  EXPECT_EQ(rise(plate, 14.9, 0), 0);
  EXPECT_EQ(rise(plate, 20, 5.1), 0);
}

TEST(Plate, ARaisedLineHasItsHeightInTheMiddleAndItsWidthAtHalfOfIt) {
  Plate plate = flat(40, 20, 0.05);
  const PlateLine line{{10, 10}, {30, 10}};
  plate.add_line(line, {1.0, 1.1});
  EXPECT_NEAR(rise(plate, 20, 10), 1, 1e-5);
  EXPECT_NEAR(rise(plate, 20, 10.55), 0.5, 0.01);
  EXPECT_NEAR(rise(plate, 20, 9.45), 0.5, 0.01);
  EXPECT_GT(rise(plate, 20, 10.95), 0);
  EXPECT_EQ(rise(plate, 20, 11.05), 0);
  EXPECT_NEAR(rise(plate, 10, 10), 1, 1e-5);
  EXPECT_NEAR(rise(plate, 30, 10), 1, 1e-5);
  EXPECT_NEAR(rise(plate, 30.55, 10), 0.5, 0.01);
  EXPECT_EQ(rise(plate, 31.1, 10), 0);
}

TEST(Plate, ASinkingLineIsAThirdAsHighAtItsEnd) {
  Plate plate = flat();
  plate.add_line(PlateLine{{5, 10}, {15, 10}, {35, 10}}, {1.2, 1.1}, LineEnd::sinks);
  EXPECT_NEAR(rise(plate, 5, 10), 1.2, 1e-5);
  EXPECT_NEAR(rise(plate, 27, 10), 1.2, 1e-4);
  EXPECT_NEAR(rise(plate, 31, 10), 0.8, 1e-4);
  EXPECT_NEAR(rise(plate, 35, 10), 0.4, 1e-4);
}

TEST(Plate, AShortSinkingLineKeepsItsHeightOverMostOfIt) {
  Plate plate = flat();
  plate.add_line(PlateLine{{10, 10}, {20, 10}}, {1.0, 1.1}, LineEnd::sinks);
  EXPECT_NEAR(rise(plate, 16, 10), 1, 1e-4);
  EXPECT_NEAR(rise(plate, 18, 10), 2.0 / 3, 1e-4);
}

TEST(Plate, WhereLinesCrossTheHigherOneCounts) {
  Plate plate = flat();
  plate.add_line(PlateLine{{5, 10}, {35, 10}}, {1.0, 1.1});
  plate.add_line(PlateLine{{20, 2}, {20, 18}}, {0.5, 1.1});
  EXPECT_NEAR(rise(plate, 20, 10), 1, 1e-5);
  EXPECT_NEAR(rise(plate, 20, 5), 0.5, 1e-5);
  EXPECT_NEAR(highest(plate), 4, 1e-5);
}

TEST(Plate, ADotIsAPieceOfASphere) {
  Plate plate = flat(10, 10, 0.05);
  plate.add_dot({5, 5}, 2, 0.5);
  EXPECT_NEAR(rise(plate, 5, 5), 0.5, 1e-6);
  // The sphere through the foot and the top has a radius of (1 + 0.25) / (2 * 0.5) = 1.25.
  EXPECT_NEAR(rise(plate, 5.6, 5), std::sqrt(1.25 * 1.25 - 0.36) - 0.75, 1e-5);
  EXPECT_NEAR(rise(plate, 5, 4.4), std::sqrt(1.25 * 1.25 - 0.36) - 0.75, 1e-5);
  EXPECT_EQ(rise(plate, 6, 5), 0);
}

TEST(Plate, OneSinglePointIsARoundKnob) {
  Plate plate = flat(10, 10, 0.05);
  plate.add_line(PlateLine{{5, 5}}, {1, 1.1});
  EXPECT_NEAR(rise(plate, 5, 5), 1, 1e-6);
  EXPECT_NEAR(rise(plate, 5, 5.55), 0.5, 0.01);
}

TEST(Plate, WhatLeavesThePlateIsCutOff) {
  Plate plate = flat(10, 10);
  plate.add_line(PlateLine{{-5, 5}, {15, 5}}, {});
  plate.add_dot({0, 0}, 2, 1);
  plate.add_dot({10, 10}, 2, 1);
  plate.add_dot({30, 30}, 2, 1);
  EXPECT_NEAR(rise(plate, 0, 5), 1, 1e-5);
  EXPECT_NEAR(rise(plate, 10, 5), 1, 1e-5);
  EXPECT_NEAR(rise(plate, 0, 0), 1, 1e-5);
  EXPECT_NEAR(rise(plate, 10, 10), 1, 1e-5);
}

TEST(Plate, TheMouldIsDeepWhereThePlateIsHighAndLeftIsRight) {
  Plate plate = flat(20, 10);
  plate.add_dot({4, 5}, 2, 1);
  const Plate mould = plate.negative();
  EXPECT_NEAR(rise(mould, 16, 5), 0, 1e-5);
  EXPECT_NEAR(rise(mould, 4, 5), 1, 1e-5);
  const Plate again = mould.negative();
  for (std::size_t i = 0; i < plate.heights().size(); ++i)
    ASSERT_NEAR(again.heights()[i], plate.heights()[i], 1e-5);
}

TEST(Plate, ABorderStandsAroundAllOfIt) {
  Plate plate = flat(20, 10);
  plate.add_border(2, 3);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {20.0, 5.0}, {1.9, 5.0}, {10.0, 10.0}, {10.0, 0.5}})
    EXPECT_NEAR(rise(plate, x, y), 3, 1e-5) << x << " " << y;
  EXPECT_EQ(rise(plate, 2.2, 2.2), 0);
  EXPECT_EQ(rise(plate, 17.8, 7.8), 0);
}

TEST(Plate, AHoleNeedsFlatGroundAndRoom) {
  Plate plate = flat(40, 40);
  plate.add_dot({20, 20}, 2, 1);
  EXPECT_THAT(plate.add_hole({{2.9, 20}, 2}).error().what, HasSubstr("edge"));
  EXPECT_THAT(plate.add_hole({{37.1, 20}, 2}).error().what, HasSubstr("edge"));
  EXPECT_THAT(plate.add_hole({{20, 2.9}, 2}).error().what, HasSubstr("edge"));
  EXPECT_THAT(plate.add_hole({{20, 37.1}, 2}).error().what, HasSubstr("edge"));
  EXPECT_THAT(plate.add_hole({{20, 23.8}, 2}).error().what, HasSubstr("flat"));
  EXPECT_THAT(plate.add_hole({{20, 30}, 0.7}).error().what, HasSubstr("too small"));
  EXPECT_TRUE(plate.holes().empty());
  EXPECT_TRUE(plate.add_hole({{20, 30}, 2}));
  EXPECT_THAT(plate.add_hole({{24.9, 30}, 2}).error().what, HasSubstr("another"));
  EXPECT_TRUE(plate.add_hole({{25.1, 30}, 2}));
  EXPECT_TRUE(plate.add_hole({{3.1, 20}, 2}));
  EXPECT_EQ(plate.holes().size(), 3U);
  EXPECT_TRUE(plate.negative().holes().empty());
}

}  // namespace
}  // namespace nazori::model
